// Who is hit: probabilities against closed forms.

#include "results/risk/exposure.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "random/stream.h"

using namespace flyrock;

namespace exposure_test {

/// Rocks thrown evenly in all directions, each to a distance that is uniform up to `reach` m: 1 / (2 pi r
/// reach) landings a m2 at the distance r.
constexpr double reach = 300;

TrialRecords throws(std::uint64_t seed, int trials, int rocks, double share_of_trials = 1) {
  TrialRecords records;
  RandomStream rng(seed, 1, DrawKey{});
  for (int t = 0; t < trials; ++t) {
    const bool throws_any = rng.uniform() < share_of_trials;
    for (int i = 0; i < rocks && throws_any; ++i) {
      const double distance = reach * rng.uniform(), azimuth = 2 * pi * rng.uniform();
      RockRecord& rock = records.rocks.emplace_back();
      rock.trial = static_cast<std::uint64_t>(t);
      rock.rock = i;
      rock.reason = StopReason::stopped;
      rock.stop_x = distance * std::cos(azimuth);
      rock.stop_y = distance * std::sin(azimuth);
      rock.end_energy = distance;
    }
  }
  return records;
}

ExposureSummary exposed(const ExposurePlan& plan, const TrialRecords& records, int trials,
                        int dimension = 3) {
  Scenario scenario;
  scenario.dimension = dimension;
  scenario.exposures = {plan};
  ExposureTally tally(scenario);
  do tally.add(records);
  while (tally.needs_another_pass());
  return tally.summaries(static_cast<std::uint64_t>(trials)).front();
}

TEST_CASE("throws in all directions hit a person as their density says, within the interval") {
  const int trials = 2000, rocks = 10;
  const ExposurePlan person{.name = "person", .at = {90, 120}, .line = {}, .area = 0.5};
  const double at_150 = 1 / (2 * pi * 150 * reach);
  const double truth = 1 - std::pow(1 - person.area * at_150, rocks);
  int inside = 0;
  double mean = 0;
  const int seeds = 100;
  for (int seed = 0; seed < seeds; ++seed) {
    const ExposureSummary found =
        exposed(person, throws(static_cast<std::uint64_t>(seed), trials, rocks), trials);
    inside += found.per_blast.interval.lower <= truth && truth <= found.per_blast.interval.upper;
    mean += found.hits_per_m2 / seeds;
  }
  // The radius is a tenth of the way: the bias is R^2 / 12 times the Laplacian of 1/r, 0.1 %.
  CHECK(mean == Approx(rocks * at_150).epsilon(0.05));
  CHECK(inside >= 88);  // 91 to 99 of 100, less two standard deviations of a count of 95
}

TEST_CASE("blasts that throw nothing count as blasts, and rocks of one blast make no new ones") {
  const int trials = 400, rocks = 400;
  const ExposurePlan roof{.name = "roof", .at = {150, 0}, .line = {}, .area = 100};
  const double mean = rocks * roof.area / (2 * pi * 150 * reach);
  const double truth = 0.3 * (1 - std::exp(-mean));
  int inside = 0;
  for (int seed = 0; seed < 60; ++seed) {
    const ExposureSummary found =
        exposed(roof, throws(1000 + static_cast<std::uint64_t>(seed), trials, rocks, 0.3), trials);
    inside += found.per_blast.interval.lower <= truth && truth <= found.per_blast.interval.upper;
  }
  CHECK(inside >= 53);
}

TEST_CASE("a road is hit as the mean density along it says") {
  // Along x = 150 the density is 1 / (2 pi reach r); its integral over y is asinh(y / 150) / (2 pi reach).
  const int trials = 20000;
  const TrialRecords records = throws(5, trials, 2);
  ExposurePlan road{
      .name = "road", .line = {{150, -200}, {150, 0}, {150, 200}}, .area = 8, .radius = 20, .length = 4};
  const double integral = 2 * std::asinh(200.0 / 150) / (2 * pi * reach);
  CHECK(exposed(road, records, trials).hits_per_m2 * 4 == Approx(2 * integral).epsilon(0.05));
  road.length = 0;  // one area somewhere on 400 m
  CHECK(exposed(road, records, trials).hits_per_m2 * 400 == Approx(2 * integral).epsilon(0.05));
}

TEST_CASE("in the plane, rocks land anywhere on an arc") {
  const int trials = 20000;
  TrialRecords records;
  RandomStream rng(3, 1, DrawKey{});
  for (int t = 0; t < trials; ++t) {
    RockRecord& rock = records.rocks.emplace_back();
    rock.trial = static_cast<std::uint64_t>(t);
    rock.reason = StopReason::stopped;
    rock.start_x = 20;
    rock.stop_x = 20 + reach * rng.uniform();
  }
  const ExposurePlan person{
      .name = "person", .at = {170, 0}, .line = {}, .area = 0.5, .spread = 0.4, .radius = 10};
  const ExposureSummary found = exposed(person, records, trials, 2);
  CHECK(found.hits_per_m2 == Approx(1 / (reach * 0.4 * 150)).epsilon(0.1));
  CHECK(found.per_blast.upper == Approx(0.5 * found.hits_per_m2).epsilon(1e-3));
}

TEST_CASE("a kernel of no given radius holds a hundred landings, about a place and along a line") {
  const TrialRecords records = throws(7, 2000, 60);
  const ExposurePlan place{.name = "person", .at = {90, 120}, .line = {}, .area = 0.5},
      road{.name = "road", .at = {0, 0}, .line = {{150, -40}, {140, 0}, {150, 40}}, .area = 0.5};
  for (const ExposurePlan& plan : {place, road}) {
    INFO(plan.name);
    const ExposureSummary found = exposed(plan, records, 2000);
    REQUIRE(found.radius < 14);  // less than a tenth of the way
    CHECK(found.landings == 100);
  }
}

TEST_CASE("where no rock lands, three landings bound what may happen") {
  const ExposurePlan far{.name = "far", .at = {1000, 0}, .line = {}, .area = 0.5};
  const ExposureSummary found = exposed(far, throws(1, 500, 4), 500);
  CHECK(found.landings == 0);
  CHECK(found.per_blast.upper == 0);
  CHECK(found.radius == Approx(100).epsilon(0.02));  // a tenth of the way from the mean release
  const double one = 0.5 * 2 / (pi * found.radius * found.radius);
  CHECK(found.per_blast.interval.upper == Approx(-std::log(0.05) * one / 500));
}

TEST_CASE("only landings with the energy count, weights stand for rocks, a year has many blasts") {
  TrialRecords records = throws(9, 3000, 10);
  ExposurePlan person{.name = "person", .at = {90, 120}, .line = {}, .area = 0.5, .radius = 20};
  person.energy = reach + 1;
  CHECK(exposed(person, records, 3000).landings == 0);
  person.energy = 0;
  person.blasts_per_year = 50;
  person.occupied = 0.25;
  const ExposureSummary one = exposed(person, records, 3000);
  CHECK(one.per_year == Approx(1 - std::pow(1 - 0.25 * one.per_blast.upper, 50)));
  for (RockRecord& rock : records.rocks) rock.weight = 3;
  const ExposureSummary three = exposed(person, records, 3000);
  CHECK(three.hits_per_m2 == Approx(3 * one.hits_per_m2));
  CHECK(three.per_blast.upper == Approx(3 * one.per_blast.upper).epsilon(0.01));
}

TEST_CASE("the interval of rare events is that of Poisson counts where all are alike") {
  // 12 events of probability 0.01 in 1000 trials: 12 has the exact Poisson interval 6.20 to 20.96.
  const Interval found = rare_interval(0.12, 12e-4, 0.01, 1000000, 0.95);
  CHECK(found.lower * 1e8 == Approx(6.2006).epsilon(1e-3));
  CHECK(found.upper * 1e8 == Approx(20.9616).epsilon(1e-3));
}

}  // namespace exposure_test
