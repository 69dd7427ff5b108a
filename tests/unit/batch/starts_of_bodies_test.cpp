// Bodies of a scenario that settle, are pulled, or wait.

#include <algorithm>

#include "load.h"

namespace starts_of_bodies_test {

using namespace flyrock;

const BodyHistory& history_of(const LoadedScenario& scenario, const TrialRecords& records,
                              const std::string& name) {
  const std::vector<BodyPlan>& bodies = scenario.plan.points.front().bodies;
  const auto body =
      std::find_if(bodies.begin(), bodies.end(), [&](const BodyPlan& plan) { return plan.name == name; });
  return records.totals.bodies[static_cast<std::size_t>(body - bodies.begin())];
}

TEST_CASE("bodies of a scenario settle, one under a force and one that waits start at their times") {
  const LoadedScenario scenario = loaded("tests/unit/batch/starts.yaml");
  const TrialRecords records = first_trial(scenario);
  for (const auto& [name, height] : {std::pair("lower", 0.1), std::pair("upper", 0.3)}) {
    INFO(name);
    const BodyHistory& settled = history_of(scenario, records, name);
    CHECK(settled.first.time == 0);
    CHECK(settled.first.position.y() == Approx(height).margin(1e-5));
    CHECK(settled.last.position.y() == Approx(height).margin(1e-5));
    CHECK(settled.impact_count == 0);
  }
  const BodyHistory& pulled = history_of(scenario, records, "pulled");
  CHECK(pulled.first.position.x() == 5);
  CHECK(pulled.last.position.x() == Approx(5 + 0.5 * (200 / 40. - 0.3 * 9.81)).epsilon(1e-6));
  const BodyHistory& waiting = history_of(scenario, records, "waiting");
  CHECK(waiting.last.position.x() == Approx(-5 + 3 * 0.75));
  CHECK(waiting.last.position.y() == Approx(9 + 2 * 0.75 - 0.5 * 9.81 * 0.75 * 0.75));
  REQUIRE_FALSE(records.series_bodies.empty());
  for (const auto& [trial, row] : records.series_bodies) CHECK(row.state.time >= 0);
}

}  // namespace starts_of_bodies_test
