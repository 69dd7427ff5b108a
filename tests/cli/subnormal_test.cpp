// Numbers near the least that a double can be, in a result and in what is made of it.

#include <catch2/catch.hpp>

#include "program.h"
#include "rows.h"

using namespace flyrock::test;

namespace subnormal_test {

namespace {

/// A disk (a sphere in 3D) on a plane, with a velocity along it and a spin.
std::string on_a_plane(int dimension, const std::string& speed, const std::string& spin) {
  const bool in_3d = dimension == 3;
  const std::string zero = in_3d ? ", 0" : "";
  return "flyrock: 1\ndimension: " + std::to_string(dimension) +
         "\nmethod: nscd\nterrain: { type: plane, material: m }\nmaterials: { m: {} }\nbodies:\n"
         "  - { name: b, shape: { type: " +
         (in_3d ? "sphere" : "disk") + ", radius: 0.5 }, position: [0" + zero +
         ", 0.5], density: 2700, material: m, velocity: [" + speed + zero +
         ", 0], spin: " + (in_3d ? "[0, " + spin + ", 0]" : spin) + " }\nstop: { time: 0.1 s }\n";
}

void check_readable(const Folder& folder) {
  for (const char* command : {"report r", "export r --to csv", "export r --to vtk", "animate r"}) {
    const Output output = call(folder, command);
    INFO(command << ": " << output.err);
    CHECK(output.code == 0);
  }
}

}  // namespace

TEST_CASE("A speed or an energy of any smallness is a number of the result, and of its page", "[heavy]") {
  const Folder folder;
  const char* const numbers[] = {"1e-30", "1e-150", "1e-156", "-1e-160", "1e-300", "5e-324"};
  for (const int dimension : {2, 3})
    for (const char* number : numbers)
      for (const bool turns : {false, true}) {
        folder.write("s.yaml", on_a_plane(dimension, turns ? "0" : number, turns ? number : "0"));
        const Output run = call(folder, "run s.yaml --quiet --force -o r");
        INFO(dimension << " " << number << " " << turns << ": " << run.err);
        REQUIRE(run.code == 0);
        check_readable(folder);
      }
}

TEST_CASE("A body at rest has no speed below 1e-30 m/s") {
  const Folder folder;
  // A driven disk passes through a heap that falls: the bodies come to rest with rolling resistance.
  folder.write("s.yaml", R"(flyrock: 1
dimension: 2
method: nscd
seed: 150
trials: 1
terrain: { type: profile, points: [[-17.256, 53.839], [-15.263, 51.699], [-13.328, 50.819], [13.0459933673371, 50.819]], material: m }
materials: { m: { restitution: { type: newton, en: 0.2 }, friction: { type: coulomb, mu: 1.2 }, rolling: { type: rolling_resistance, mu_r: 0.058 m } } }
bodies:
  - { name: b1, shape: { type: polygon, sides: 9, diameter: 0.934, irregularity: 0.4 }, position: [6.914, 59.708], material: m, density: 2700 }
  - { name: b2, shape: { type: polygon, sides: 5, diameter: 0.683, irregularity: 0.2, rounding: 0.034 }, position: [6.896, 61.608], material: m, density: 2700, velocity: [-4.39, -10.48] }
  - { name: b3, shape: { type: wall, length: 0.625, radius: 0.266 }, position: [7.028, 63.508], material: m, density: 2700, velocity: [11.91, 0.49] }
  - { name: b4, shape: { type: polygon, sides: 5, diameter: 0.377, irregularity: 0.2, rounding: 0.019 }, position: [6.974, 65.408], material: m, density: 2700, velocity: [-14.9, -0.21] }
  - { name: b5, shape: { type: disk, radius: 0.45 }, position: [7.255, 67.308], material: m, density: 1500, spin: -15.44 }
  - { name: b7, shape: { type: wall, length: 1.352, radius: 0.289 }, position: [7.097, 71.108], material: m, density: 1500, spin: 5.23 }
  - { name: drv, shape: { type: disk, radius: 0.8 }, density: 2700, position: [7.15, 56.13], material: m, driven: { velocity: [-1.97, -0.29], spin: 2.0 } }
stop: { time: 20 s }
)");
  const Output run = call(folder, "run s.yaml --quiet -o r");
  INFO(run.err);
  REQUIRE(run.code == 0);
  check_readable(folder);
  CHECK(query(folder.path() / "r/results.db",
              "SELECT COUNT(*) FROM trajectories WHERE kinetic_energy_J > 0 AND kinetic_energy_J < 1e-61") ==
        std::vector<std::string>{"0"});
}

}  // namespace subnormal_test
