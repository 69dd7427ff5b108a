// The number of each trial that a sensitivity analysis explains, by hand.

#include "results/measured/trial_measure.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "load.h"
#include "results/risk/exposure_kernel.h"

using namespace flyrock;

namespace trial_measure_test {

namespace {

Scenario two_groups() {
  Scenario scenario;
  scenario.rocks.resize(2);
  scenario.rocks[0].name = "face";
  scenario.rocks[1].name = "collar";
  scenario.gates.push_back({.name = "road", .x = 100});
  scenario.barriers.push_back({.name = "fence", .x = 50});
  ExposurePlan house;
  house.name = "house";
  house.at = Vec2(100, 0);
  house.area = 4;
  house.spread = 0.5;
  house.radius = 20;
  scenario.exposures.push_back(house);
  return scenario;
}

RockRecord rock(std::uint64_t trial, int number, int group, double runout, double weight = 1) {
  RockRecord row;
  row.trial = trial;
  row.rock = number;
  row.group = group;
  row.reason = StopReason::stopped;
  row.runout = row.stop_x = runout;
  row.weight = weight;
  return row;
}

double value(const Scenario& scenario, const std::string& text, const TrialRecords& chunk,
             std::size_t trial = 0) {
  std::string fault;
  const auto measure = TrialMeasure::read(text, scenario, fault);
  INFO(fault);
  REQUIRE(measure);
  TrialMeasure with_radius = *measure;
  with_radius.set_radius(20);
  std::vector<double> of_trial(3, measure->without_rocks());
  with_radius.add(chunk, of_trial);
  return of_trial.at(trial);
}

}  // namespace

TEST_CASE(
    "the mean, the greatest and the share beyond a limit count the rocks of their group with their weights") {
  const Scenario scenario = two_groups();
  TrialRecords chunk;
  chunk.rocks = {rock(0, 0, 0, 100, 1), rock(0, 1, 0, 200, 3), rock(0, 2, 1, 500), rock(2, 0, 1, 70)};
  CHECK(value(scenario, "rocks.face.runout.mean", chunk) == 175);
  CHECK(value(scenario, "rocks.face.runout.max", chunk) == 200);
  CHECK(value(scenario, "rocks.runout.max", chunk) == 500);
  CHECK(value(scenario, "rocks.face.runout.beyond[150 m]", chunk) == 0.75);
  CHECK(value(scenario, "rocks.collar.runout.mean", chunk, 2) == 70);
  // A trial without such rocks has no distance, and nothing beyond a limit.
  CHECK(std::isnan(value(scenario, "rocks.face.runout.mean", chunk, 2)));
  CHECK(value(scenario, "rocks.face.runout.beyond[150 m]", chunk, 2) == 0);
  CHECK(value(scenario, "rocks.face.runout.beyond[150 m]", chunk, 1) == 0);
}

TEST_CASE("p95 is that of the percentiles of a run") {
  const Scenario scenario = two_groups();
  TrialRecords chunk;
  for (int i = 0; i < 21; ++i) chunk.rocks.push_back(rock(0, i, 0, (i * 8) % 21));
  CHECK(value(scenario, "rocks.face.runout.p95", chunk) == Approx(19));  // of 0 to 20, at 0.95 of 20
  chunk.rocks.resize(19);
  CHECK(std::isnan(value(scenario, "rocks.face.runout.p95", chunk)));
}

TEST_CASE("a lost rock, or a censored one that may change the number, makes it unknown") {
  const Scenario scenario = two_groups();
  TrialRecords chunk;
  chunk.rocks = {rock(0, 0, 0, 100), rock(0, 1, 0, 200)};
  chunk.rocks[1].censored = true;
  CHECK(std::isnan(value(scenario, "rocks.face.runout.max", chunk)));
  CHECK(value(scenario, "rocks.face.runout.beyond[150 m]", chunk) == 0.5);  // it is beyond already
  CHECK(std::isnan(value(scenario, "rocks.face.runout.beyond[250 m]", chunk)));
  chunk.rocks[1] = rock(0, 1, 1, 200);
  chunk.rocks[1].reason = StopReason::diverged;
  CHECK(value(scenario, "rocks.face.runout.max", chunk) == 100);  // of the other group
  CHECK(std::isnan(value(scenario, "rocks.runout.max", chunk)));
}

TEST_CASE("a gate or a barrier has 1 if one rock does it, and is unknown if one still may") {
  const Scenario scenario = two_groups();
  TrialRecords chunk;
  chunk.rocks = {rock(0, 0, 0, 120), rock(0, 1, 0, 40), rock(1, 0, 0, 40)};
  GateRecord passage;
  passage.trial = 0;
  passage.rock = 0;
  chunk.gates = {passage};
  BarrierRecord hit;
  hit.trial = 0;
  hit.rock = 0;
  hit.hit.outcome = BarrierOutcome::over_top;
  chunk.barriers = {hit};
  CHECK(value(scenario, "gate.road.per_trial", chunk, 0) == 1);
  CHECK(value(scenario, "gate.road.passed.per_trial", chunk, 1) == 0);
  CHECK(value(scenario, "barrier.fence.past.per_trial", chunk, 0) == 1);
  CHECK(value(scenario, "barrier.fence.caught.per_trial", chunk, 0) == 0);
  CHECK(value(scenario, "barrier.fence.reached.per_trial", chunk, 1) == 0);
  chunk.rocks[2].censored = true;
  chunk.rocks[2].reason = StopReason::left_domain;
  CHECK(std::isnan(value(scenario, "gate.road.per_trial", chunk, 1)));
  chunk.rocks[2].decided_gates = 1;
  CHECK(value(scenario, "gate.road.per_trial", chunk, 1) == 0);
}

TEST_CASE("an exposure has the probability that one of its rocks hits, with their weights") {
  const Scenario scenario = two_groups();
  TrialRecords chunk;
  chunk.rocks = {rock(0, 0, 0, 95, 2), rock(0, 1, 1, 110), rock(0, 2, 1, 300)};
  const ExposureKernel kernel(scenario.exposures[0], scenario.dimension);
  const double a = kernel.chance(Vec2(95, 0), 100, 20), b = kernel.chance(Vec2(110, 0), 100, 20);
  CHECK(a > 0);
  CHECK(value(scenario, "exposure.house.per_blast", chunk) ==
        Approx(1 - (1 - a) * (1 - a) * (1 - b)).epsilon(1e-12));
}

TEST_CASE("words that name no number of a trial say what was expected") {
  const Scenario scenario = two_groups();
  const auto fault = [&](const std::string& text) {
    std::string said;
    CHECK_FALSE(TrialMeasure::read(text, scenario, said));
    return said;
  };
  CHECK(fault("rocks.fase.runout.max").find("did you mean `face`?") != std::string::npos);
  CHECK(fault("rocks.face.runuot.max").find("did you mean `runout`?") != std::string::npos);
  CHECK(fault("rocks.face.runout.p50").find("expected rocks.NAME.QUANTITY.mean") != std::string::npos);
  CHECK(fault("gate.road.mean_energy").find("gate.NAME.per_trial") != std::string::npos);
  CHECK(fault("clearance.people.distance").find("exposure.NAME.per_blast") != std::string::npos);
  CHECK(fault("rocks.face.energy.beyond[3 m]").find("expected a limit in J") != std::string::npos);
}

}  // namespace trial_measure_test
