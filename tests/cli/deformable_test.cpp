// Deformable blocks by the program: the same bytes over threads, what `check` says of them.

#include "same_result.h"

using namespace flyrock::test;

namespace deformable_cli_test {

namespace {

/// Blocks of drawn stiffness tumble on the floor.
constexpr const char* blocks = R"(flyrock: 1
dimension: 2
method: nscd
trials: 12
terrain: { type: profile, points: [[-9, 0], [9, 0]], material: floor }
materials: { floor: { restitution: { type: newton, en: 0.4 }, friction: { type: coulomb, mu: 0.5 } } }
bodies:
  - name: block
    shape:
      type: deformable
      form: rectangle
      size: [1 m, 0.6 m]
      cells: 3
      young: { uniform: [10 GPa, 50 GPa] }
      poisson: 0.25
      damping: { beta: { sweep: [0 s, 2e-6 s] } }
      tensile_strength: 5 MPa
    density: 2700 kg/m3
    position: [0, 0.6]
    orientation: 20 deg
    velocity: [1, -5]
    material: floor
solver: { time_step: 0.00001 s }
stop: { time: 0.02 s, speed: 0 }
output: { series: { every: 1 ms } }
)";

/// Boxes of drawn stiffness tumble on the floor.
constexpr const char* boxes = R"(flyrock: 1
dimension: 3
method: nscd
trials: 6
terrain: { type: plane, material: floor }
materials: { floor: { restitution: { type: newton, en: 0.4 }, friction: { type: coulomb, mu: 0.5 } } }
bodies:
  - name: block
    shape:
      type: deformable
      form: box
      size: [1 m, 0.6 m, 0.4 m]
      cells: 2
      young: { uniform: [10 GPa, 50 GPa] }
      poisson: 0.25
      damping: { beta: { sweep: [0 s, 2e-6 s] } }
      tensile_strength: 5 MPa
    density: 2700 kg/m3
    position: [0, 0, 0.6]
    orientation: { axis: [1, 2, 0], angle: 30 deg }
    velocity: [1, 0, -5]
    spin: [1 rad/s, 2 rad/s, 3 rad/s]
    material: floor
solver: { time_step: 0.00002 s }
stop: { time: 0.02 s, speed: 0 }
output: { series: { every: 1 ms } }
)";

/// A cube of as many bricks a side as `cells` falls flat on the floor.
constexpr const char* cube = R"(flyrock: 1
dimension: 3
method: nscd
gravity: 0 m/s2
terrain: { type: plane, material: floor }
materials: { floor: { friction: { type: coulomb, mu: 0 } } }
bodies:
  - name: block
    shape: { type: deformable, form: box, size: [1 m, 1 m, 1 m], cells: 4, young: 50 GPa, poisson: 0.25, tensile_strength: 5 MPa }
    density: 2700 kg/m3
    position: [0, 0, 0.5]
    velocity: [0, 0, -1]
    material: floor
solver: { time_step: 0.00005809475 s }
stop: { time: 0.002 s, speed: 0 }
output: { series: { every: 0.1 ms } }
)";

void same_bytes_by_threads(const char* scenario) {
  const Folder folder;
  folder.write("s.yaml", scenario);
  for (const char* threads : {"1", "2", "8"}) {
    const Output run = call(folder, std::string("run s.yaml --quiet -o j") + threads + " -j" + threads);
    INFO(run.err);
    REQUIRE(run.code == 0);
  }
  check_same(folder, "j1", "j2");
  check_same(folder, "j1", "j8");
}

}  // namespace

TEST_CASE("a deformable cube has measures of stress, and its mesh is exported as tetrahedra") {
  const Folder folder;
  folder.write("s.yaml", cube);
  const Output run =
      call(folder,
           "run s.yaml -o r --set 'expect=[{ measure: body.block.final.vz, equals: 0.743727, "
           "tolerance: 1e-5 }, { measure: body.block.tension_1pct.max, between: [1 MPa, 30 MPa] "
           "}]'");
  INFO(run.out << run.err);
  CHECK(run.code == 0);
  const Output exported = call(folder, "export r --to vtk -o v");
  INFO(exported.out << exported.err);
  REQUIRE(exported.code == 0);
  const std::string grid = read(folder.path() / "v/meshes-p0/0000.vtu");
  CHECK(grid.find("NumberOfPoints=\"125\" NumberOfCells=\"320\"") != std::string::npos);
  CHECK(grid.find("tension_Pa") != std::string::npos);
  const Output report = call(folder, "report r");
  INFO(report.out << report.err);
  CHECK(report.code == 0);
}

TEST_CASE("deformable boxes give the same bytes over 1, 2 and 8 threads") { same_bytes_by_threads(boxes); }

TEST_CASE("deformable blocks of drawn values give the same bytes over 1, 2 and 8 threads") {
  same_bytes_by_threads(blocks);
}

TEST_CASE("check says how deformable blocks touch, and warns of long steps and of triangles that lock") {
  const Folder folder;
  folder.write("s.yaml", blocks);
  const Output fine = call(folder, "check s.yaml");
  INFO(fine.out << fine.err);
  CHECK(fine.code == 0);
  CHECK(fine.err.empty());
  CHECK(fine.out.find("e_n = e_t = 0 at its contacts, whatever the material says") != std::string::npos);
  const Output coarse = call(folder,
                             "check s.yaml --set solver.time_step=1ms --set bodies.0.shape.young=50GPa "
                             "--set bodies.0.shape.poisson=0.42");
  INFO(coarse.err);
  CHECK(coarse.code == 0);
  CHECK(coarse.err.find(
            "the rebound of `block` is numerical, not by waves: time_step 0.001 s is 7.2 transits of "
            "sound, expected at most 0.1") != std::string::npos);
  CHECK(coarse.err.find("bodies.0.shape.poisson: 0.42 is unusual, expected 0 to 0.4") != std::string::npos);
}

}  // namespace deformable_cli_test
