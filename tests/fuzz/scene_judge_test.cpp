// The judge of scenes finds what it is told to look for.

#include "scene_judge.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "cli/dispatch.h"

using namespace flyrock;
using namespace flyrock::fuzz;

namespace {

/// A block that lies on the ground, and a disk of 10 cm that falls on it, on springs that give way by
/// centimetres.
constexpr const char* soft_block = R"(flyrock: 1
dimension: 3
method: nscd
terrain: { type: plane, point: [0, 0, 0], material: m }
materials: { m: { unilateral: { type: penalty, stiffness: 1e4 N/m, damping: 10 N s/m } } }
bodies:
  - { name: block, shape: { type: box, size: [1, 1, 0.4] }, density: 2700, fixed: true, material: m, position: [0, 0, 0.2] }
  - { name: disk, shape: { type: cylinder, radius: 0.1, height: 0.1 }, density: 2700, material: m, position: [0, 0, 0.6], velocity: [0, 0, -1] }
stop: { time: 0.5 s }
output: { series: { every: step }, trajectories: { first: 1 } }
)";

using Files = std::vector<std::pair<std::string, std::string>>;  // names and texts

std::string verdict_of(const Scene& scene, const Files& beside = {}) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("flyrock_judge_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  std::ofstream(folder / "s.yaml") << scene.text;
  for (const auto& [name, text] : beside) std::ofstream(folder / name) << text;
  const std::string out = (folder / "out").string();
  const int code =
      cli::dispatch({"run", (folder / "s.yaml").string(), "-o", out, "--force", "--quiet", "-j", "1"});
  REQUIRE(code == cli::done);
  const std::string verdict = fault_of_scene(scene, out);
  fs::remove_all(folder);
  return verdict;
}

bool says(const std::string& verdict, const std::string& what) {
  INFO(verdict);
  return verdict.find(what) != std::string::npos;
}

}  // namespace

TEST_CASE("The judge of scenes finds bodies in the ground and in each other, and energy from nowhere") {
  Scene scene;
  scene.text = soft_block;
  scene.is_spring = scene.gives_energy = true;
  CHECK(verdict_of(scene).empty());
  scene.is_spring = false;  // so that the depth of its springs counts
  CHECK(says(verdict_of(scene), "disk lies"));
  CHECK(says(verdict_of(scene), "in block"));
  scene.is_spring = true;
  scene.gives_energy = false;  // and the energy that they give back
  CHECK(says(verdict_of(scene), "more than before"));
  scene.is_spring = false;
  scene.gives_energy = true;
  scene.place.z() = 0.7;  // the ground is said to be higher than it was in the run
  CHECK(says(verdict_of(scene), "in the ground"));
}

TEST_CASE("The judge lets Newton's law gain where an impact ends the slip") {
  // A rod that lands on its end: slip that stops gives energy to e_n of the normal velocity (Kane).
  Scene scene;
  scene.dimension = 2;
  scene.profile = {{-12, 0}, {20, 0}};
  scene.text = R"(flyrock: 1
dimension: 2
method: nscd
terrain: { type: profile, points: [[-12, 0], [20, 0]], material: m }
materials: { m: { restitution: { type: newton, en: 0.927 }, friction: { type: coulomb, mu: 0.704 } } }
bodies:
  - { name: rod, shape: { type: polygon, vertices: [[1, 0.05], [-1, 0.05], [-1, -0.05], [1, -0.05]] }, density: 2700, material: m, position: [0, 1.5], orientation: 63.5 deg, velocity: [4.61, -5.47], spin: -1.31 }
stop: { time: 0.6 s }
output: { series: { every: step }, trajectories: { first: 1 } }
)";
  CHECK(says(verdict_of(scene), "more than before"));
  scene.law_gains = true;
  CHECK(verdict_of(scene).empty());
}

TEST_CASE("Scenes in which the judge has found a fault move as bodies do") {
  Scene scene;
  scene.fall = 3;
  // A pill that rolls and yaws: one end left the ground in each step, and 477 impacts gave it 24 J.
  scene.text = R"(flyrock: 1
dimension: 3
method: nscd
terrain: { type: plane, point: [0, 0, 0], normal: [0, 0, 1], material: m }
materials: { m: { restitution: { type: newton, en: 0.23893, form: energy } } }
bodies:
  - { name: pill, shape: { type: pill, length: 1.1831, radius: 0.24661 }, density: 2700, material: m, position: [0.081356, -0.56095, 2.62504], orientation: { axis: [0.81759, -0.79327, 1], angle: 209.92 deg }, velocity: [-3.7503, 2.0058, -1.639], spin: [-10.514, 14.305, 9.4008] }
stop: { time: 2.1387 s }
output: { series: { every: step }, trajectories: { first: 1 } }
)";
  CHECK(verdict_of(scene) == "");
  // A coin: an impact lifted one side by 2 cm/s, and the next step drew it down, 4e-5 m into the ground.
  scene.text = R"(flyrock: 1
dimension: 3
method: nscd
terrain: { type: plane, point: [0, 0, 0], normal: [0, 0, 1], material: m }
materials: { m: { restitution: { type: newton, en: 0.235548 }, rolling: { type: rolling_resistance, mu_r: 0.072791 m } } }
bodies:
  - { name: coin, shape: { type: cylinder, radius: 0.12146, height: 0.010907 }, density: 2700, material: m, position: [-0.6863, -0.32116, 2.51185], orientation: { axis: [0.28487, -0.45813, 1], angle: 125.94 deg }, velocity: [-2.2113, 0.5827, -1.5848], spin: [-2.099, 4.8398, 3.8644] }
stop: { time: 1.1532 s }
output: { series: { every: step }, trajectories: { first: 1 } }
)";
  CHECK(verdict_of(scene) == "");
  // A box: solved again with the push that its step had found, a contact collided twice and sank by 2 cm.
  scene.text = R"(flyrock: 1
dimension: 3
method: nscd
terrain: { type: plane, point: [0, 0, 0], normal: [0, 0, 1], material: m }
materials: { m: { restitution: { type: newton, en: 0.28709, form: poisson }, rolling: { type: rolling_resistance, mu_r: 0.075674 m } } }
bodies:
  - { name: box, shape: { type: box, size: [1.53066, 1.4441, 1.5084] }, density: 2700, material: m, position: [0.29582, 0.17887, 3.85064], orientation: { axis: [0.40256, 0.94803, 1], angle: 177.84 deg }, velocity: [-4.5639, 1.9352, 4.6005], spin: [0.18488, -1.2611, -3.3706] }
stop: { time: 2.6912 s }
output: { series: { every: step }, trajectories: { first: 1 } }
)";
  CHECK(verdict_of(scene) == "");
  // A hexagon on springs: its edge came to face a corner with an overlap of 1 cm, which gave it 880 J.
  scene = {};
  scene.dimension = 2;
  scene.is_spring = scene.gives_energy = true;
  scene.profile = {
      {-12, 0}, {-5.4837, -3.0062}, {-2.4313, -1.97013}, {1.1359, -1.17908}, {22.2059, -7.06463}};
  scene.text = R"(flyrock: 1
dimension: 2
method: nscd
terrain: { type: profile, points: [[-12, 0], [-5.4837, -3.0062], [-2.4313, -1.97013], [1.1359, -1.17908], [22.2059, -7.06463]], material: m }
materials: { m: { restitution: { type: newton, en: 0.48597, form: energy }, friction: { type: coulomb, mu: 0.35093 }, rolling: { type: rolling_resistance, mu_r: 0.011739 m }, unilateral: { type: penalty, stiffness: 18752000 N/m, damping: 818.23 N s/m } } }
bodies:
  - { name: b0, shape: { type: polygon, sides: 6, diameter: 0.42129 }, density: 2700, material: m, position: [0.2387, 2.79604], orientation: 304.02 deg, velocity: [-4.3593, -4.0484], spin: -1.3994 }
stop: { time: 0.91725 s }
output: { series: { every: step }, trajectories: { first: 1 } }
)";
  CHECK(verdict_of(scene) == "");
}

TEST_CASE("What moves in a tube stays in it", "[slow]") {
  Scene scene;
  scene.fall = 20;
  // A vertex that an impact had opened came back within a step that other vertices held: 9e-5 m.
  scene.hollows = {{"hollow", 0.3236, 1.2944}};
  scene.gives_energy = false;
  scene.text = R"(flyrock: 1
dimension: 3
method: nscd
terrain: { type: plane, point: [0, 0, 0], normal: [0, 0, 1], material: m }
materials: { m: { friction: { type: coulomb, mu: 0.75939 } } }
air: { density: 1.2 kg/m3, cd: 0.8 }
bodies:
  - { name: hollow, shape: { type: hollow_cylinder, radius: 0.3236, height: 2.5888 }, density: 2700, material: m, position: [0, 0, 8.86688], orientation: { axis: [0.72106, 0.46957, 1], angle: 164.23 deg }, fixed: true }
  - { name: c0, shape: { type: polyhedron, points: [[-0.060025, -0.017378, -0.035346], [0.029613, 0.012646, 0.052948], [-0.029198, 0.059325, 0.0075986], [0.05339, 0.024381, -0.055582], [-0.024277, -0.016827, 0.016707], [0.01258, 0.020943, 0.032857], [0.054886, 0.021125, 0.01059], [0.03553, 0.059007, 0.027476]] }, density: 2700, material: m, position: [-0.018553, 0, 8.90797], velocity: [0.75193, -2.9192, -1.7204], spin: [-2.7043, -4.0871, 4.5064] }
stop: { time: 2.6659 s }
output: { series: { every: step }, trajectories: { first: 1 } }
)";
  CHECK(verdict_of(scene) == "");
  // The place of a rim walked, was 2e-6 m in the wall, and was then taken for one that comes from outside: 15
  // mm.
  scene.hollows = {{"hollow", 0.98117, 3.92468}};
  scene.gives_energy = true;
  scene.text = R"(flyrock: 1
dimension: 3
method: nscd
terrain: { type: plane, point: [0, 0, 0], normal: [0, 0, 1], material: m }
materials: { m: { restitution: { type: mass_scaled, en: 0.71586, half_mass: 500 kg }, friction: { type: coulomb, mu: 0.71184 }, rolling: { type: rolling_resistance, mu_r: 0.006541 m } } }
bodies:
  - { name: hollow, shape: { type: hollow_cylinder, radius: 0.98117, height: 7.84936 }, density: 2700, material: m, position: [0, 0, 9.50249], orientation: { axis: [-0.18912, 0.66767, 1], angle: 261.09 deg }, driven: { velocity: [0.22156, -0.21551, 0.29482], spin: [2.3505, 4.9923, -0.18628] } }
  - { name: c0, shape: { type: cylinder, radius: 0.075127, height: 0.015554 }, density: 2700, material: m, position: [-0.22677, 0, 9.1941], orientation: { axis: [-0.78921, 0.26802, 1], angle: 115.34 deg }, velocity: [-2.2988, 1.0294, -2.6044], spin: [1.7117, 0.2833, 1.2475] }
stop: { time: 2.6151 s }
output: { series: { every: step }, trajectories: { first: 1 } }
)";
  CHECK(verdict_of(scene) == "");
  // The place of a rim walked within the first step after an impact: 0.25 mm.
  scene.hollows = {{"hollow", 2.4511, 9.8044}};
  scene.gives_energy = true;
  scene.text = R"(flyrock: 1
dimension: 3
method: nscd
terrain: { type: plane, point: [0, 0, 0], normal: [0, 0, 1], material: m }
materials: { m: { rolling: { type: rolling_resistance, mu_r: 0.065189 m } } }
air: { density: 1.2 kg/m3, cd: 0.8 }
bodies:
  - { name: hollow, shape: { type: hollow_cylinder, radius: 2.4511, height: 19.6088 }, density: 2700, material: m, position: [0, 0, 14.878], orientation: { axis: [-0.44331, 0.37203, 1], angle: 344.84 deg }, driven: { velocity: [-0.39717, 0.34152, -0.35608], spin: [1.1621, -3.2075, -1.7943] } }
  - { name: c0, shape: { type: cylinder, radius: 0.19754, height: 0.039421 }, density: 2700, material: m, position: [0.21001, 0, 14.751570000000001], orientation: { axis: [0.021736, -0.20661, 1], angle: 242.39 deg }, velocity: [1.1841, -1.5281, -1.4576], spin: [-1.3695, -3.8186, 4.1813] }
stop: { time: 2.872 s }
output: { series: { every: step }, trajectories: { first: 1 } }
)";
  CHECK(verdict_of(scene) == "");
}

TEST_CASE("A vertex that slides over the foot of a slope stays out of the ground") {
  // It came from below into the thin prism of the next facet, because the step held other vertices only: 3
  // mm.
  const std::string heights =
      R"(0.449128 1.04039 0.499974 0.930528 1.63388 1.8598 3.00167 3.4205 4.18709 3.84062 5.23698 5.37603
-0.215458 0.636379 0.736096 1.82368 2.23135 2.00509 3.3719 3.362 4.39911 4.25682 4.69296 5.38747
0.253018 0.98615 0.454355 1.24457 1.63487 2.65891 2.37201 3.48864 3.26739 3.9997 5.07292 5.141
0.275319 0.305153 1.43342 1.11658 1.81098 1.95608 3.27155 3.00355 4.14674 4.1579 4.37514 5.08165
-0.291367 -0.0922419 0.450678 0.852672 1.35283 2.67921 2.82432 3.8503 4.27358 4.87673 4.84666 5.29649
-0.440926 0.485317 0.775281 1.63156 1.46699 1.81738 3.13587 3.13806 3.37436 4.86208 4.71185 5.27657
0.466318 -0.0653687 0.841962 1.47635 2.28062 2.72076 2.48976 3.21877 4.02005 4.38666 4.23305 4.91963
0.43143 0.882517 1.35933 1.15905 2.36296 2.10317 2.80313 3.48213 3.62333 4.01782 5.20647 5.5757
-0.183147 0.492045 1.04387 1.95189 1.82427 2.03581 3.18834 3.45547 3.4039 4.63677 4.26551 5.39037
-0.519424 0.981926 1.10775 1.79761 1.8379 2.41583 2.5692 3.0142 4.25434 4.76053 5.32669 5.64749
0.118372 0.268534 1.00051 1.25574 1.94044 2.19258 2.7869 3.49085 3.96527 4.14677 4.27272 5.65613
0.567979 -0.0317676 1.44527 1.55121 2.40488 2.77622 2.41051 3.36892 4.04305 3.88908 4.31463 5.75119
)";
  const std::string octahedron =
      "v 0.19798 0 0\nv -0.19798 0 0\nv 0 0.18662 0\nv 0 -0.18662 0\nv 0 0 0.2138\nv 0 0 -0.2138\n"
      "f 1 3 5\nf 2 5 3\nf 1 5 4\nf 1 6 3\nf 2 4 5\nf 2 3 6\nf 1 4 6\nf 2 6 4\n";
  Scene scene;
  scene.fall = 100;
  scene.columns = 12;
  scene.cell = 1.64;
  scene.corner = Vec2::Constant(-9.0199999999999996);
  std::istringstream numbers(heights);
  scene.heights.resize(144);
  for (int row = 11; row >= 0; --row)
    for (int column = 0; column < 12; ++column)
      numbers >> scene.heights[static_cast<std::size_t>(12 * row + column)];
  scene.clouds = {"rock"};
  scene.text = R"(flyrock: 1
dimension: 3
method: nscd
terrain: { type: raster, file: ground.asc, material: m }
materials: { m: { restitution: { type: mass_scaled, en: 0.12748, half_mass: 500 kg }, friction: { type: coulomb, mu: 0.17518 } } }
bodies:
  - { name: rock, shape: { type: mesh_point, file: rock.obj }, density: 2700, material: m, position: [-0.2165, -0.80592, 8.82662], velocity: [-0.48481, 1.489, -4.8911], spin: [-3.9282, -0.2138, 3.2733] }
stop: { time: 1.864 s }
output: { series: { every: step }, trajectories: { first: 1 } }
)";
  const std::string header =
      "ncols 12\nnrows 12\nxllcenter -9.0199999999999996\nyllcenter -9.0199999999999996\ncellsize 1.64\n";
  CHECK(verdict_of(scene, {{"ground.asc", header + heights}, {"rock.obj", octahedron}}) == "");
}
