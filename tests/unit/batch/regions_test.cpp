// Means over regions: stress and porosity against closed forms.

#include "document/yaml_reader.h"
#include "load.h"
#include "results/measured/measures.h"
#include "scenario/measure.h"
#include "temporary_file.h"

namespace regions_test {

using namespace flyrock;

constexpr double g = 9.81;

LoadedScenario scenario_of(const std::string& text) {
  const TemporaryFile file("regions.yaml", text);
  Diagnostics diagnostics;
  auto scenario = load_scenario(file.path, {}, diagnostics);
  INFO(diagnostics.to_text());
  REQUIRE(scenario);
  return std::move(*scenario);
}

constexpr const char* one_ball =
    "bodies: [{ name: ball, shape: { type: disk, radius: 0.1 }, mass: 1, position: [0, 1] }]";
constexpr const char* lone_rocks =
    "rocks: [{ name: ball, shape: { type: disk, radius: 0.1 }, density: 2700, release: { position: [0, 1] }, "
    "launch: { type: at_rest } }]";

/// The messages of a scenario of these bodies with these regions.
std::string refused(const std::string& regions, const std::string& bodies = one_ball) {
  const std::string begin = R"(flyrock: 1
dimension: 2
method: nscd
terrain: { type: plane, material: rock }
materials: { rock: { friction: { type: coulomb, mu: 0.3 } } }
stop: { time: 1 s }
)";
  const TemporaryFile file("regions.yaml",
                           begin + bodies + "\noutput: { series: { regions: " + regions + " } }\n");
  Diagnostics diagnostics;
  CHECK_FALSE(load_scenario(file.path, {}, diagnostics));
  return diagnostics.to_text();
}

/// The last row of a region.
SeriesRegion last_of(const TrialRecords& records, const std::string& region) {
  std::optional<SeriesRegion> last;
  for (const auto& [trial, row] : records.series_regions)
    if (row.region == region) last = row;
  REQUIRE(last);
  return *last;
}

/// Nine disks of 2 kg in a square lattice of 1 m under a lid of 5 kg that is pressed down with 1 kN.
std::string lattice() {
  std::string text = R"(flyrock: 1
dimension: 2
method: nscd
terrain: { type: profile, points: [[-5, 0], [8, 0]], material: rock }
materials: { rock: { friction: { type: coulomb, mu: 0.3 } } }
bodies:
  - { name: lid, shape: { type: polygon, vertices: [[-1.5, -0.1], [1.5, -0.1], [1.5, 0.1], [-1.5, 0.1]] }, mass: 5, material: rock, position: [1.5, 3.1], force: [0, -1000] }
)";
  for (const char* x : {"0.5", "1.5", "2.5"})
    for (const char* y : {"0.5", "1.5", "2.5"})
      text += std::string("  - { name: disk_") + x[0] + "_" + y[0] +
              ", shape: { type: disk, radius: 0.5 }, mass: 2, material: rock, position: [" + x + ", " + y +
              "] }\n";
  return text + R"(stop: { time: 0.1 s, speed: 0 }
output:
  series:
    contacts: false
    regions: [{ name: all, corners: [[0, 3], [3, 0]] }, { name: top, corners: [[0, 2], [3, 3]] }, { name: empty, corners: [[4, 0], [5, 1]] }]
)";
}

TEST_CASE("a lattice under a pressed lid has the stress of the weight above, and the porosity of squares") {
  const LoadedScenario scenario = scenario_of(lattice());
  const TrialRecords records = first_trial(scenario);
  constexpr double thickness = 4.0 / 3.0 * 0.5;  // by default a disk has the area of the sphere's volume
  constexpr double load = 1000 + 5 * g, disk = 2 * g;
  const SeriesRegion all = last_of(records, "all"), top = last_of(records, "top");
  CHECK(all.bodies == 9);
  CHECK(all.porosity == Approx(1 - pi / 4).epsilon(1e-12));
  CHECK(all.stress_yy == Approx((load + 4.5 * disk) / (3 * thickness)).epsilon(1e-5));
  CHECK(top.bodies == 3);
  CHECK(top.porosity == Approx(1 - pi / 4).epsilon(1e-12));
  CHECK(top.stress_yy == Approx((load + 1.5 * disk) / (3 * thickness)).epsilon(1e-5));
  CHECK(std::abs(all.stress_xy) < 1e-6 * all.stress_yy);
  CHECK(all.stress_zz == 0);
  const SeriesRegion empty = last_of(records, "empty");
  CHECK(empty.bodies == 0);
  CHECK(empty.porosity == 1);
  CHECK(empty.stress_yy == 0);
}

/// A block that friction holds against a force in its centre of mass. Its moment is zero, so f_x l_z = f_z
/// l_x, and the shear stress is that of the friction at half of its height.
TEST_CASE("a block that is pushed aside has the shear stress of the friction under it, in 2D and 3D") {
  const std::string begin = R"(
method: nscd
materials: { rock: { friction: { type: coulomb, mu: 0.6 } } }
terrain: { type: plane, material: rock }
stop: { time: 0.2 s, speed: 0 }
)";
  const TrialRecords flat = first_trial(scenario_of("flyrock: 1\ndimension: 2" + begin + R"(
bodies: [{ name: block, shape: { type: polygon, vertices: [[-1, -0.5], [1, -0.5], [1, 0.5], [-1, 0.5]] }, thickness: 1, mass: 10, position: [0, 0.5], force: [20, 0] }]
output: { series: { regions: [{ name: block, corners: [[-1, 0], [1, 1]] }] } }
)"));
  const SeriesRegion in_plane = last_of(flat, "block");
  CHECK(in_plane.porosity == Approx(0).margin(1e-12));
  CHECK(in_plane.stress_yy == Approx(10 * g * 0.5 / 2).epsilon(1e-6));
  CHECK(in_plane.stress_xy == Approx(-20 * 0.5 / 2).epsilon(1e-6));

  const TrialRecords deep = first_trial(scenario_of("flyrock: 1\ndimension: 3" + begin + R"(
bodies: [{ name: block, shape: { type: box, size: [2, 4, 1] }, mass: 10, position: [0, 0, 0.5], force: [20, -10, 0] }]
output: { series: { regions: [{ name: block, corners: [[-1, -2, 0], [1, 2, 1]] }] } }
)"));
  const SeriesRegion in_space = last_of(deep, "block");
  CHECK(in_space.porosity == Approx(0).margin(1e-12));
  CHECK(in_space.stress_zz == Approx(10 * g * 0.5 / 8).epsilon(1e-6));
  CHECK(in_space.stress_xz == Approx(-20 * 0.5 / 8).epsilon(1e-6));
  CHECK(in_space.stress_yz == Approx(10 * 0.5 / 8).epsilon(1e-6));
}

TEST_CASE("measures of a region are numbers of its rows, and a scenario reads back what it resolves to") {
  const LoadedScenario scenario = scenario_of(lattice());
  const Scenario& point = scenario.plan.points.front();
  PointResult result;
  for (const double time : {1.0, 2.0})
    result.series.regions.push_back(
        {.time = time, .region = "top", .step = 1, .porosity = 0.1 * time, .stress_xy = 5 * time});
  result.series.regions.push_back({.time = 2, .region = "all", .step = 1, .porosity = 0.9});
  CHECK(Measure("region.top.porosity.final", point).value(result).value == Approx(0.2));
  CHECK(Measure("region.top.stress_xy.mean", point).value(result).value == 7.5);
  CHECK(Measure("region.top.stress_xy.at[0.5 s]", point).value(result).value == 5);
  CHECK(Measure("region.empty.porosity.max", point).value(result).fault ==
        "the region empty has no row in a step");
  CHECK_FALSE(Measure("region.top.porosity.final", point).of_rocks());

  const std::string once = to_yaml(scenario.plan.resolved);
  CHECK(to_yaml(scenario_of(once).plan.resolved) == once);
}

TEST_CASE("regions that are no boxes, and measures of unknown ones, are refused") {
  using Catch::Contains;
  CHECK_THAT(refused("[{ name: a, corners: [[0, 0], [1, 0]] }]"),
             Contains("output.series.regions.0.corners: expected two opposite corners of a box"));
  CHECK_THAT(refused("[{ name: a, corners: [[0, 0], [1, 1], [2, 2]] }]"),
             Contains("expected two opposite corners of a box"));
  CHECK_THAT(refused("[{ name: a }]"), Contains("`corners` is missing"));
  CHECK_THAT(refused("[{ name: a, corners: [[0, 0], [1, 1]] }, { name: a, corners: [[0, 0], [1, 1]] }]"),
             Contains("the name `a` is taken by an earlier element"));
  CHECK_THAT(refused("[{ name: a, corners: [[0, 0], [1, 1]] }]", lone_rocks),
             Contains("output.series.regions: needs `bodies`, or `rock_contacts: on`"));
  MeasureNames names;
  names.series = true;
  names.regions = {"core"};
  CHECK(check_measure("region.core.stress_yy.final", names).fault.empty());
  CHECK(check_measure("region.core.stress_yy.final", names).dimension == parse_unit("Pa")->dimension);
  CHECK_THAT(check_measure("region.core.stress_zz.final", names).fault, Contains("unknown `stress_zz`"));
  CHECK_THAT(check_measure("region.cor.porosity.max", names).fault, Contains("did you mean `core`?"));
  names.regions.clear();
  CHECK_THAT(check_measure("region.core.porosity.max", names).fault,
             Contains("the scenario has no output.series.regions"));
}

}  // namespace regions_test
