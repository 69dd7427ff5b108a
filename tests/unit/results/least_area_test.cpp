// The area of least size, on throws whose laws are known.

#include "results/measured/least_area.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "geometry/plan_zone.h"
#include "random/stream.h"
#include "results/measured/clearance.h"

namespace flyrock::least_area_test {

namespace {

/// Throws from (0, 0): the speed has a factor of the blast and one of the rock, both lognormal.
struct Throws {
  const char* name;
  double half_angle;  ///< rad, of the azimuth
  double of_blast, of_rock;
  int rocks;  ///< a blast
  bool is_from_face() const { return half_angle < pi; }

  std::vector<Vec2> blast(std::uint64_t seed, std::uint64_t trial) const {
    DrawKey key;
    key.trial = trial;
    RandomStream rng(seed, "throws", key);
    const double factor = std::exp(of_blast * rng.normal());
    std::vector<Vec2> places;
    for (int i = 0; i < rocks; ++i) {
      const double speed = 25 * factor * std::exp(of_rock * rng.normal());
      const double azimuth = rng.uniform(-half_angle, half_angle);
      places.push_back(speed * speed / 9.81 * Vec2(std::cos(azimuth), std::sin(azimuth)));
    }
    return places;
  }
};

TrialRecords records_of(const Throws& throws, std::uint64_t seed, std::uint64_t trials) {
  TrialRecords records;
  for (std::uint64_t t = 0; t < trials; ++t)
    for (const Vec2& place : throws.blast(seed, t)) {
      RockRecord& rock = records.rocks.emplace_back();
      rock.trial = t;
      rock.reason = StopReason::stopped;
      rock.stop_x = place.x();
      rock.stop_y = place.y();
      rock.runout = rock.max_distance = place.norm();
    }
  return records;
}

ClearancePlan asked(double probability, bool per_blast = false) {
  ClearancePlan plan;
  plan.probability = probability;
  plan.per_blast = per_blast;
  plan.least_area = true;
  return plan;
}

LeastArea area_of_records(const ClearancePlan& plan, const TrialRecords& records) {
  ClearanceTally tally({plan});
  do tally.add(records);
  while (tally.needs_another_pass());
  return tally.summaries().front().least_area;
}

bool holds(const LeastArea& area, const Vec2& place) {
  for (const PlanRing& ring : area.polygons)
    if (is_inside(ring, place)) return true;
  return false;
}

/// The share of new rocks (or blasts) outside.
double outside(const LeastArea& area, const Throws& throws, bool per_blast, int blasts,
               std::uint64_t seed = 0) {
  double out = 0, all = 0;
  for (int b = 0; b < blasts; ++b) {
    int of_blast = 0;
    for (const Vec2& place : throws.blast(10'000 + seed, static_cast<std::uint64_t>(b)))
      of_blast += !holds(area, place);
    out += per_blast ? of_blast > 0 : of_blast;
    all += per_blast ? 1 : throws.rocks;
  }
  return out / all;
}

const Throws kinds[] = {
    {"from a face", 30 * pi / 180, 0, 0.3, 1},
    {"from a face, half a circle", pi / 2, 0, 0.3, 1},
    {"to all sides", pi, 0, 0.3, 1},
    {"from a face, with the burden of the blast", 45 * pi / 180, 0.25, 0.15, 20},
    {"to all sides, with the burden of the blast", pi, 0.25, 0.15, 20},
};

/// Over so many seeds each kind leaves at most the probability outside in 92 %, and takes no more land than a
/// circle (to all sides: 1.2 times).
void check_kinds(int seeds, std::uint64_t rocks, int judged, bool per_blast = false) {
  for (const Throws& throws : kinds) {
    if (per_blast && throws.rocks == 1) continue;
    INFO(throws.name << (per_blast ? ", per blast" : ""));
    int kept = 0;
    double hectares = 0, circle = 0;
    for (int seed = 0; seed < seeds; ++seed) {
      constexpr double probability = 0.05;
      const std::uint64_t trials = per_blast ? rocks / 4 : rocks / static_cast<std::uint64_t>(throws.rocks);
      const LeastArea area = area_of_records(asked(probability, per_blast),
                                             records_of(throws, static_cast<std::uint64_t>(seed), trials));
      REQUIRE(area.beyond);
      kept += outside(area, throws, per_blast, per_blast ? judged / 5 : judged / throws.rocks,
                      static_cast<std::uint64_t>(seed)) <= probability;
      hectares += area.hectares;
      circle += area.circle_hectares;
    }
    CHECK(kept >= 0.92 * seeds - 1.5);  // the judge has a sample itself
    CHECK(hectares <= (throws.is_from_face() ? 1 : 1.2) * circle);
  }
}

}  // namespace

TEST_CASE("an area of least size leaves at most its share outside, and takes less land than a circle") {
  check_kinds(1, 2000, 2000);
}

TEST_CASE("of 12 seeds 92 % leave at most their share outside of the area of least size", "[slow]") {
  check_kinds(12, 4000, 5000);
}

TEST_CASE("of 200 seeds 92 % leave at most their share outside of the area of least size", "[heavy]") {
  check_kinds(200, 4000, 40'000);
  check_kinds(60, 4000, 10'000, true);
}

TEST_CASE("the level of an area is that of the k + 1 least numbers of the odd trials, by hand") {
  LeastScores scores(2);  // k = 1
  CHECK_FALSE(scores.level());
  for (const double score : {5.0, 1.0, 4.0, 2.0, 3.0}) scores.add(score, 1);
  CHECK(scores.level() == 2);
  LeastScores halves(2);  // effective rocks of a design effect of 2: four rocks
  for (const double score : {5.0, 1.0, 4.0, 2.0, 3.0}) halves.add(score, 0.5);
  CHECK(halves.level() == 4);
}

TEST_CASE(
    "with a given radius the circle of an area is that of one sector, and rocks that left are counted") {
  const Throws& throws = kinds[0];
  TrialRecords records = records_of(throws, 1, 2000);
  records.rocks[7].censored = true;
  ClearancePlan plan = asked(0.05);
  plan.radius = 12;
  const LeastArea area = area_of_records(plan, records);
  CHECK(area.radius == 12);
  CHECK(area.effective == 1000);
  CHECK(area.beyond == rocks_beyond(1, 1000, 0.05));
  CHECK(area.censored == 1);
  std::vector<double> distances;
  for (const RockRecord& rock : records.rocks) distances.push_back(rock.runout);
  std::sort(distances.begin(), distances.end(), std::greater<>());
  const double distance = distances[*rocks_beyond(1, 2000, 0.05)];
  CHECK(area.circle_distance == Approx(distance));
  CHECK(area.circle_hectares == Approx(pi * distance * distance / 1e4));
}

TEST_CASE("a kernel so small that most places have no density makes an area of discs that still holds") {
  const Throws& throws = kinds[2];
  int kept = 0;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    ClearancePlan plan = asked(0.1);
    plan.radius = 2;
    const LeastArea area = area_of_records(plan, records_of(throws, seed, 400));
    REQUIRE(area.beyond);
    kept += outside(area, throws, false, 1000) <= 0.1;
  }
  CHECK(kept >= 4);
}

TEST_CASE("too few rocks have no area of least size") {
  const LeastArea area = area_of_records(asked(0.02), records_of(kinds[0], 1, 200));
  CHECK_FALSE(area.beyond);
  CHECK(std::isnan(area.hectares));
  CHECK(area.polygons.empty());
}

}  // namespace flyrock::least_area_test
