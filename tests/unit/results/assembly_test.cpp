// Many bodies as a whole.

#include "results/measured/assembly.h"

#include <catch2/catch.hpp>

#include "results/measured/measures.h"
#include "scenario/measure.h"

namespace assembly_test {

using namespace flyrock;

BodyHistory ended_at(double x, double y, StopReason reason, double stop_time) {
  BodyHistory body;
  body.last.position = {x, y, 0};
  body.last.kinetic_energy = 3 * x;
  body.reason = reason;
  body.stop_time = stop_time;
  return body;
}

TEST_CASE("an assembly has the extent, the mean and the rest of the bodies that move") {
  Scenario scenario;
  scenario.bodies.resize(4);
  scenario.bodies[1].fixed = true;
  scenario.bodies[2].driven.emplace();
  const std::vector<BodyHistory> bodies = {
      ended_at(1, 2, StopReason::stopped, 4), ended_at(50, 50, StopReason::timed_out, 0),
      ended_at(-50, 50, StopReason::timed_out, 0), ended_at(3, 0.5, StopReason::timed_out, 0)};
  Assembly assembly = assembly_of(moving_bodies(scenario), bodies);
  CHECK(assembly.bodies == 2);
  CHECK(assembly.at_rest == 1);
  CHECK(assembly.low.position == Vec3(1, 0.5, 0));
  CHECK(assembly.high.position == Vec3(3, 2, 0));
  CHECK(assembly.mean.position == Vec3(2, 1.25, 0));
  CHECK(assembly.mean.kinetic_energy == 6);
  CHECK(
      assembly_text(assembly, 2, 2) ==
      "2 of 2 bodies moved; 1 is at rest, the last one since 4 s. The centres of all lie from x = 1 to 3 m, "
      "from y = 0.5 to 2 m.");
  assembly.at_rest = 0;
  CHECK(assembly_text(assembly, 2, 2).starts_with("2 of 2 bodies moved; none is at rest. "));
}

TEST_CASE("measures of an assembly are numbers of the last states") {
  Scenario scenario;
  scenario.bodies.resize(3);
  scenario.bodies[2].fixed = true;
  PointResult result;
  result.totals.bodies = {ended_at(1, 2, StopReason::stopped, 4), ended_at(3, 0.5, StopReason::timed_out, 0),
                          ended_at(9, 9, StopReason::timed_out, 0)};
  const auto value = [&](const char* name) { return Measure(name, scenario).value(result).value; };
  CHECK(value("assembly.x.mean") == 2);
  CHECK(value("assembly.y.min") == 0.5);
  CHECK(value("assembly.kinetic_energy.max") == 9);
  CHECK(value("assembly.at_rest") == 1);
  CHECK_FALSE(Measure("assembly.x.mean", scenario).of_rocks());
}

TEST_CASE("measures of an assembly need bodies, a component and a statistic") {
  MeasureNames names;
  CHECK(check_measure("assembly.x.mean", names).fault.find("the scenario has no bodies") !=
        std::string::npos);
  names.bodies = {"a", "b"};
  for (const char* measure : {"assembly.x.mean", "assembly.vy.min", "assembly.at_rest"})
    CHECK(check_measure(measure, names).fault.empty());
  CHECK(check_measure("assembly.kinetic_energy.max", names).dimension == dimension::energy);
  CHECK(check_measure("assembly.z.mean", names).fault.find("unknown `z`") != std::string::npos);
  CHECK(check_measure("assembly.x", names).fault.find("expected `mean`, `min` or `max`") !=
        std::string::npos);
  names.dimension = 3;
  CHECK(check_measure("assembly.z.mean", names).fault.empty());
}

}  // namespace assembly_test
