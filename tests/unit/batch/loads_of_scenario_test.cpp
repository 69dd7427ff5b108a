// Loads over time of a scenario, as tables and as functions in Lua.

#include <algorithm>
#include <cmath>

#include "load.h"

namespace loads_of_scenario_test {

using namespace flyrock;

const BodyHistory& history_of_body(const LoadedScenario& scenario, const TrialRecords& records,
                                   const std::string& name) {
  const std::vector<BodyPlan>& bodies = scenario.plan.points.front().bodies;
  const auto body =
      std::find_if(bodies.begin(), bodies.end(), [&](const BodyPlan& plan) { return plan.name == name; });
  return records.totals.bodies[static_cast<std::size_t>(body - bodies.begin())];
}

TEST_CASE("loads of a scenario change over time, as tables and as functions in Lua") {
  for (const char* file : {"tests/unit/batch/loads.yaml", "tests/unit/batch/loads.lua"}) {
    INFO(file);
    const LoadedScenario scenario = loaded(file);
    const TrialRecords records = first_trial(scenario);
    const auto last = [&](const char* name) { return history_of_body(scenario, records, name).last; };
    const double slides = 9.81 * std::sqrt(0.5) * 0.2 / 6;  // m, from 1 s on, when mu is tan(45 deg)
    CHECK(last("on_slope").position.x() ==
          Approx(-19.929289321881345 + std::sqrt(0.5) * slides).margin(2e-3 * slides));
    CHECK(last("pushed").position.x() == Approx(40. / 40 * 8 / 6).epsilon(1e-6));
    CHECK(last("pushed").position.y() == Approx(45 - 0.5 * 9.81 * 4).epsilon(1e-9));
  }
}

TEST_CASE("a function of fr.over_time has the rows that its lines need") {
  const LoadedScenario scenario = loaded("tests/unit/batch/loads.lua");
  const Scenario& point = scenario.plan.points.front();
  CHECK(point.gravity_over_time->rows().size() == 2);
  CHECK(point.gravity_over_time->at(1) == Vec3(0, -9.81, 0));
  CHECK(point.materials.front().mu_over_time->rows().size() == 2);
  const OverTime& lift = *point.bodies.back().over_time;
  CHECK(lift.rows().size() == 3);
  CHECK(lift.rows()[1].time == 1);
  CHECK(lift.last_change() == 2);
}

}  // namespace loads_of_scenario_test
