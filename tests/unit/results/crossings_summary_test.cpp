#include <catch2/catch.hpp>

#include "record/rows.h"
#include "results/measured/measures.h"

using namespace flyrock;

namespace {

RockRecord rock(std::uint64_t trial, StopReason reason) {
  RockRecord record;
  record.trial = trial;
  record.reason = reason;
  record.censored = reason == StopReason::timed_out;
  return record;
}

/// Four rocks, of which one diverged; energies of 1 and 3 kJ at the gate.
TrialRecords records(bool lost_before_the_gate) {
  TrialRecords r;
  r.rocks = {rock(0, StopReason::stopped), rock(1, StopReason::caught), rock(2, StopReason::diverged),
             rock(3, lost_before_the_gate ? StopReason::timed_out : StopReason::stopped)};
  r.gates = {{0, 0, {{.speed = 2, .kinetic_energy = 1000, .height = 0.5}, 0}},
             {1, 0, {{.speed = 4, .kinetic_energy = 3000, .height = 1.5}, 0}},
             {2, 0, {{.speed = 9, .kinetic_energy = 9000, .height = 9}, 0}}};
  r.barriers = {{0, 0, {{.kinetic_energy = 1000}, 0, BarrierOutcome::over_top}},
                {1, 0, {{.kinetic_energy = 3000}, 0, BarrierOutcome::caught}}};
  return r;
}

Scenario scenario() {
  Scenario s;
  s.rocks.resize(1);
  s.gates = {{"road", 10}, {"far", 90}};
  s.barriers = {{"fence", 20, 2, 2000}};
  return s;
}

PointResult result(const TrialRecords& r) {
  CrossingTallies tally(scenario());
  read_in_passes(rows_of(r), tally);
  PointResult point;
  point.crossings = tally.summaries();
  return point;
}

}  // namespace

TEST_CASE("Measures of gates and barriers are of the rocks that did not fail") {
  const PointResult point = result(records(false));
  const Scenario s = scenario();
  const auto value = [&](const char* name) { return Measure(name, s).value(point); };
  CHECK(value("gate.road.passed").value == Approx(2.0 / 3));
  CHECK(value("gate.road.mean_energy").value == 2000);
  CHECK(value("gate.road.p95_energy").value == Approx(2900));
  CHECK(value("gate.road.p95_height").value == Approx(1.45));
  CHECK_FALSE(value("gate.road.passed").censored);
  CHECK(value("gate.far.passed").value == 0);
  CHECK(value("gate.far.mean_energy").fault == "no rock passed");
  CHECK(value("barrier.fence.reached").value == Approx(2.0 / 3));
  CHECK(value("barrier.fence.caught").value == Approx(1.0 / 3));
  CHECK(value("barrier.fence.over_top").value == Approx(1.0 / 3));
  CHECK(value("barrier.fence.over_energy").value == 0);
  const BarrierSummary& fence = point.crossings[0].barriers[0];
  CHECK(fence.not_reached == 1);  // with the outcomes, all three
  CHECK(complement_of(fence.share(BarrierShare::reached).of_all).interval.upper ==
        Approx(share_interval(1, 3, 0.95).upper));
  CHECK(Measure("gate.road.passed", s).of_rocks());
  CHECK(point.crossings[0].gates[0].shares.of_all.interval.lower == share_interval(2, 3, 0.95).lower);
  CHECK(fence.share(BarrierShare::over_energy).of_all.interval.lower == 0);
  CHECK(fence.share(BarrierShare::over_energy).of_all.interval.upper == share_interval(0, 3, 0.95).upper);
  CHECK(fence.share(BarrierShare::caught).of_arriving.value == 0.5);
  CHECK(fence.share(BarrierShare::past).of_arriving.value == 0.5);
  CHECK(point.crossings[0].caught.value == Approx(1.0 / 3));
}

TEST_CASE("Shares of a trial count trials with at least one such rock, shares of a group its rocks") {
  // Ten trials of a block that arrives and 30 stones that never do; the block of trials 0 to 3 is caught.
  Scenario s = scenario();
  s.rocks.resize(2);
  s.rocks[0].name = "blocks";
  s.rocks[1].name = "stones";
  TrialRecords r;
  for (std::uint64_t trial = 0; trial < 10; ++trial) {
    for (int i = 0; i < 31; ++i) {
      r.rocks.push_back(rock(trial, i == 0 && trial < 4 ? StopReason::caught : StopReason::stopped));
      r.rocks.back().rock = i;
      r.rocks.back().group = i > 0;
    }
    r.barriers.push_back(
        {trial,
         0,
         {{.kinetic_energy = 1}, 0, trial < 4 ? BarrierOutcome::caught : BarrierOutcome::over_top}});
  }
  CrossingTallies tally(s);
  read_in_passes(rows_of(r), tally);
  const std::vector<CrossingSummary> found = tally.summaries();
  REQUIRE(found.size() == 3);
  const Shares caught = found[0].barriers[0].share(BarrierShare::caught),
               past = found[0].barriers[0].share(BarrierShare::past);
  CHECK(caught.of_all.value == Approx(4.0 / 310));
  CHECK(caught.of_all.interval.trials_needed > 10);  // four trials are too few for an interval
  CHECK(std::isnan(caught.of_all.interval.upper));
  CHECK(caught.of_arriving.value == 0.4);
  CHECK(past.per_trial.value == 0.6);
  CHECK(past.per_trial.interval.upper == share_interval(6, 10, 0.95).upper);
  CHECK(found[1].barriers[0].share(BarrierShare::caught).of_all.value == 0.4);
  CHECK(found[2].barriers[0].count(BarrierShare::reached) == 0);
}

TEST_CASE("A rock lost before it arrived makes the numbers of a gate lower bounds") {
  TrialRecords rows = records(true);
  const PointResult point = result(rows);
  CHECK(point.crossings[0].gates[0].shares.of_all.censored);
  // 2 of 3 have passed, and the third may yet.
  CHECK(point.crossings[0].gates[0].shares.of_all.interval.lower == share_interval(2, 3, 0.95).lower);
  CHECK(point.crossings[0].gates[0].shares.of_all.interval.upper == 1);
  CHECK(point.crossings[0].barriers[0].share(BarrierShare::reached).of_all.censored);
  rows.gates.push_back({3, 0, {{.speed = 1, .kinetic_energy = 10, .height = 0}, 0}});
  CHECK_FALSE(result(rows).crossings[0].gates[0].shares.of_all.censored);
}

TEST_CASE("A censored rock leaves a gate or barrier open unless it is decided for it") {
  TrialRecords r = records(true);
  r.rocks[3].decided_gates = 0b01;
  r.rocks[3].decided_barriers = 0b1;
  const CrossingSummary decided = result(r).crossings.front();
  CHECK_FALSE(decided.gates[0].shares.of_all.censored);
  CHECK(decided.gates[1].shares.of_all.censored);
  CHECK_FALSE(decided.barriers[0].share(BarrierShare::reached).of_all.censored);
  CHECK(decided.gates[0].shares.of_all.value == Approx(2.0 / 3));
}
