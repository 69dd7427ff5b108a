// stop.time ends a trial, however late its rocks start, by every method.
#include <catch2/catch.hpp>
#include <cmath>

#include "load.h"

using namespace flyrock;

TEST_CASE("each rock of a trial has the time when it came to rest itself, and what it travelled until then") {
  const TrialRecords records = first_trial(loaded("tests/unit/batch/two_rocks.yaml"));
  REQUIRE(records.rocks.size() == 2);
  const double fall = std::sqrt(2 * (20 - 0.5) / 9.81), step = 1e-3;
  for (const auto& [rock, rested] : {std::pair(records.rocks[0], 0.0), std::pair(records.rocks[1], fall)}) {
    CHECK(rock.reason == StopReason::stopped);
    CHECK(rock.time == Approx(rested).margin(step));
    double travelled = 0;
    for (const double time : rock.travel.time) travelled += time;
    CHECK(travelled == Approx(rock.time).margin(1e-9));
  }
}

TEST_CASE("a trial ends at stop.time for rocks of late holes too") {
  for (const char* method : {"nscd", "ballistic"}) {
    INFO(method);
    const TrialRecords records =
        first_trial(loaded("tests/unit/batch/late_holes.yaml", {.set = {std::string("method=") + method}}));
    REQUIRE(records.rocks.size() == 4);
    CHECK(records.rocks[0].reason == StopReason::stopped);
    const RockRecord &flying = records.rocks[2], &late = records.rocks[3];
    CHECK(flying.reason == StopReason::timed_out);  // it left after 4 s
    CHECK(flying.censored);
    CHECK_FALSE(flying.landed);
    CHECK(flying.time == Approx(1));
    CHECK(flying.flight_range == Approx(10));
    CHECK(late.reason == StopReason::timed_out);
    CHECK(late.censored);
    CHECK(late.time == 0);
    CHECK(late.runout == 0);
    CHECK(late.stop_y == 12);
  }
}
