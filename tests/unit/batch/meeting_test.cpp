// Driven bodies that speed up, and bodies that do not meet.
#include "load.h"

using namespace flyrock;

namespace meeting_test {

namespace {

/// The last state of a body in the series.
BodyState last_of(const TrialRecords& records, const std::string& body) {
  BodyState last;
  for (const auto& [trial, row] : records.series_bodies)
    if (row.body == body) last = row.state;
  return last;
}

const BodyHistory& history_of(const LoadedScenario& scenario, const TrialRecords& records,
                              const std::string& body) {
  const auto& bodies = scenario.plan.points.front().bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].name == body) return records.totals.bodies[i];
  throw std::logic_error(body);
}

}  // namespace

TEST_CASE("a box on a plate that speeds up goes along, or slips with the acceleration mu g") {
  const LoadedScenario scenario = loaded("tests/unit/batch/plate.yaml");
  const TrialRecords records = first_trial(scenario);
  const double t = 0.5;
  const BodyState slow = last_of(records, "slow"), fast = last_of(records, "fast");
  CHECK(slow.velocity.x() == Approx(3 * t));
  CHECK(slow.position.x() == Approx(1.5 * t * t));
  CHECK(fast.velocity.x() == Approx(1 + 6 * t));
  CHECK(fast.position.x() == Approx(t + 3 * t * t));
  const BodyHistory &carried = history_of(scenario, records, "carried"),
                    &slipping = history_of(scenario, records, "slipping");
  CHECK(carried.last.velocity.x() == Approx(3 * t).epsilon(1e-9));
  CHECK(carried.last.position.x() == Approx(1.5 * t * t).epsilon(1e-9));
  CHECK(slipping.last.velocity.x() == Approx(0.4 * 9.81 * t).epsilon(1e-9));
  CHECK(slipping.last.position.x() == Approx(0.2 * 9.81 * t * t).epsilon(1e-9));
  CHECK(carried.last.position.y() == Approx(1.2).epsilon(1e-9));
  for (const BodyHistory* history : {&carried, &slipping}) CHECK(history->reason == StopReason::timed_out);
}

TEST_CASE("with body_contacts: off bodies pass each other and meet the terrain") {
  const LoadedScenario scenario =
      loaded("tests/unit/batch/plate.yaml", {.set = {"body_contacts=off", "stop.time=2s"}});
  const TrialRecords records = first_trial(scenario);
  for (const char* body : {"carried", "slipping"}) {
    INFO(body);
    CHECK(history_of(scenario, records, body).last.position.y() == Approx(0.1).margin(1e-6));
    CHECK(history_of(scenario, records, body).last.position.x() == Approx(0).margin(1e-9));
  }
  for (const auto& [trial, row] : records.series_contacts) CHECK(row.b == "terrain");
  CHECK_FALSE(records.series_contacts.empty());
  CHECK(scenario.plan.not_used.size() == 2);  // the plates
}

}  // namespace meeting_test
