#include <catch2/catch.hpp>

#include "record/rows.h"
#include "results/measures.h"

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

PointResult result(const TrialRecords& r) {
  CrossingTally tally(2, 1);
  read_in_passes(rows_of(r), tally);
  PointResult point;
  point.gates = tally.gates();
  point.barriers = tally.barriers();
  return point;
}

Scenario scenario() {
  Scenario s;
  s.gates = {{"road", 10}, {"far", 90}};
  s.barriers = {{"fence", 20, 2, 2000}};
  return s;
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
  CHECK(point.barriers[0].not_reached == 1);  // with the outcomes, all three
  CHECK(complement_of(point.barriers[0].reached).interval.upper == Approx(share_interval(1, 3, 0.95).upper));
  CHECK(Measure("gate.road.passed", s).of_rocks());
  CHECK(point.gates[0].share.interval.lower == share_interval(2, 3, 0.95).lower);
  CHECK(point.barriers[0].shares[2].interval.lower == 0);
  CHECK(point.barriers[0].shares[2].interval.upper == share_interval(0, 3, 0.95).upper);
}

TEST_CASE("A rock lost before it arrived makes the numbers of a gate lower bounds") {
  TrialRecords rows = records(true);
  const PointResult point = result(rows);
  CHECK(point.gates[0].share.censored);
  // 2 of 3 have passed, and the third may yet.
  CHECK(point.gates[0].share.interval.lower == share_interval(2, 3, 0.95).lower);
  CHECK(point.gates[0].share.interval.upper == 1);
  CHECK(point.barriers[0].reached.censored);
  rows.gates.push_back({3, 0, {{.speed = 1, .kinetic_energy = 10, .height = 0}, 0}});
  CHECK_FALSE(result(rows).gates[0].share.censored);
}
