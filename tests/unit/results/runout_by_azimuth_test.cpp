// The runout by azimuth: rocks count by the direction from their own release.
#include "results/measured/runout_by_azimuth.h"

#include <catch2/catch.hpp>

#include "results/measured/sectors.h"

using namespace flyrock;

namespace {

RockRecord rock_towards(double azimuth_deg, double runout, double x = 2.6e6, double y = 1.2e6) {
  RockRecord r;
  r.reason = StopReason::stopped;
  r.start_x = x;
  r.start_y = y;
  r.stop_x = x + runout * std::cos(azimuth_deg * pi / 180);
  r.stop_y = y + runout * std::sin(azimuth_deg * pi / 180);
  r.runout = runout;
  return r;
}

/// Each rock is of a trial of its own.
RunoutByAzimuth summary_of(std::vector<RockRecord> rocks) {
  for (std::size_t i = 0; i < rocks.size(); ++i) rocks[i].trial = i;
  AzimuthTally tally;
  do {
    for (const RockRecord& r : rocks) tally.add(r, azimuth_sector_of(r));
  } while (tally.needs_another_pass());
  return tally.summary();
}

}  // namespace

TEST_CASE("Azimuths count from +x towards +y, and a sector does not hold its end") {
  CHECK(sector_of({1, 0}, 36) == 0);
  CHECK(sector_of({0, 1}, 36) == 9);
  CHECK(sector_of({-1, 0}, 4) == 2);
  CHECK(sector_of({0, -1}, 4) == 3);
  CHECK(sector_of({1, -1e-12}, 36) == 35);
  CHECK(sector_of({1, -1e-300}, 36) == 35);
}

TEST_CASE("Each sector has the percentiles of its rocks, seen from their own releases") {
  std::vector<RockRecord> rocks;
  for (int i = 0; i <= 100; ++i) rocks.push_back(rock_towards(25, 1 + i, 1000 * i, -500 * i));
  for (int i = 0; i < 19; ++i) rocks.push_back(rock_towards(-5, 10 + i));
  rocks.push_back(rock_towards(0, 0));
  const RunoutByAzimuth summary = summary_of(rocks);
  REQUIRE(summary.sectors.size() == 36);
  CHECK(summary.still == 1);
  const AzimuthSector &many = summary.sectors[2], &few = summary.sectors[35], &none = summary.sectors[0];
  CHECK(many.count == 101);
  CHECK(many.share.value == Approx(101.0 / 120));
  CHECK(many.percentiles[0].value.value == Approx(51));
  CHECK(many.percentiles[1].value.value == Approx(96));
  CHECK(many.percentiles[0].interval.lower < 51);
  CHECK(many.percentiles[0].interval.upper > 51);
  CHECK(many.greatest.value == Approx(101));
  CHECK(few.count == 19);
  CHECK(few.greatest.value == Approx(28));
  CHECK(std::isnan(few.percentiles[0].value.value));
  CHECK(none.count == 0);
  CHECK(std::isnan(none.greatest.value));
}

TEST_CASE("A censored rock makes the greatest runout of its sector a lower bound") {
  std::vector<RockRecord> rocks;
  for (int i = 0; i < 30; ++i) rocks.push_back(rock_towards(95, 10 + i));
  rocks[3].reason = StopReason::left_domain;
  rocks[3].censored = true;
  const AzimuthSector sector = summary_of(rocks).sectors[9];
  CHECK(sector.greatest.value == Approx(39));
  CHECK(sector.greatest.censored);
  CHECK(sector.percentiles[1].value.censored);
}
