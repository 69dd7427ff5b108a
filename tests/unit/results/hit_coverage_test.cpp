// Intervals of hit probabilities hold the truth as often as they say, over 200 seeds.

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "random/stream.h"
#include "results/risk/exposure.h"

using namespace flyrock;

namespace hit_coverage_test {

constexpr double reach = 300;  // m, rocks land at a distance that is uniform up to it
constexpr int seeds = 200;

/// Adds a rock of a trial that lands at a distance and an azimuth from its release at the origin.
void add_landing(TrialRecords& records, int trial, double distance, double azimuth, double weight = 1) {
  RockRecord& rock = records.rocks.emplace_back();
  rock.trial = static_cast<std::uint64_t>(trial);
  rock.rock = static_cast<int>(records.rocks.size());
  rock.reason = StopReason::stopped;
  rock.stop_x = distance * std::cos(azimuth);
  rock.stop_y = distance * std::sin(azimuth);
  rock.weight = weight;
}

ExposureSummary exposed(const ExposurePlan& plan, const TrialRecords& records, int trials, int dimension) {
  Scenario scenario;
  scenario.dimension = dimension;
  scenario.exposures = {plan};
  ExposureTally tally(scenario);
  do tally.add(records);
  while (tally.needs_another_pass());
  return tally.summaries(static_cast<std::uint64_t>(trials)).front();
}

/// A Poisson number with a mean, by the product of uniform numbers (Knuth).
int poisson(RandomStream& rng, double mean) {
  int n = -1;
  for (double product = 1; product > std::exp(-mean); ++n) product *= rng.uniform();
  return n;
}

/// The share of seeds whose interval holds the truth.
double coverage(double truth, const std::function<ExposureSummary(RandomStream&)>& run) {
  int inside = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    RandomStream rng(static_cast<std::uint64_t>(seed), "coverage", DrawKey{});
    const ExposureSummary found = run(rng);
    inside += found.per_blast.interval.lower <= truth && truth <= found.per_blast.interval.upper;
  }
  return static_cast<double>(inside) / seeds;
}

/// Landings a m2 of one rock at a distance, thrown evenly in all directions.
double density_at(double distance) { return 1 / (2 * pi * distance * reach); }

TEST_CASE("isotropic throws on level ground: 91 to 99 % of the intervals hold the hit probability",
          "[slow]") {
  const int trials = 1000, rocks = 10;
  const ExposurePlan person{.name = "person", .at = {90, 120}, .line = {}, .area = 0.5};
  const double truth = 1 - std::pow(1 - person.area * density_at(150), rocks);
  const double held = coverage(truth, [&](RandomStream& rng) {
    TrialRecords records;
    for (int t = 0; t < trials; ++t)
      for (int i = 0; i < rocks; ++i) {
        const double distance = reach * rng.uniform();
        add_landing(records, t, distance, 2 * pi * rng.uniform());
      }
    return exposed(person, records, trials, 3);
  });
  CHECK(held >= 0.91);
  CHECK(held <= 0.99);
}

TEST_CASE("a Poisson number of rocks: 91 to 99 % of the intervals hold 1 - exp(-mean hits)", "[slow]") {
  const int trials = 1000;
  const double rocks = 8;
  const ExposurePlan roof{.name = "roof", .at = {150, 0}, .line = {}, .area = 40};
  const double truth = 1 - std::exp(-rocks * roof.area * density_at(150));
  const double held = coverage(truth, [&](RandomStream& rng) {
    TrialRecords records;
    for (int t = 0; t < trials; ++t)
      for (int i = poisson(rng, rocks); i > 0; --i) {
        const double distance = reach * rng.uniform();
        add_landing(records, t, distance, 2 * pi * rng.uniform());
      }
    return exposed(roof, records, trials, 3);
  });
  CHECK(held >= 0.91);
  CHECK(held <= 0.99);
}

TEST_CASE("2D with spread: 91 to 99 % of the intervals hold the hit probability", "[slow]") {
  const int trials = 1000, rocks = 4;
  const double spread = 0.6;
  const ExposurePlan person{.name = "person", .at = {150, 0}, .line = {}, .area = 0.5, .spread = spread};
  // One rock lands on the arc of length spread x at x with the density 1 / reach.
  const double truth = 1 - std::pow(1 - person.area / (reach * spread * 150), rocks);
  const double held = coverage(truth, [&](RandomStream& rng) {
    TrialRecords records;
    for (int t = 0; t < trials; ++t)
      for (int i = 0; i < rocks; ++i) add_landing(records, t, reach * rng.uniform(), 0);
    return exposed(person, records, trials, 2);
  });
  CHECK(held >= 0.91);
  CHECK(held <= 0.99);
}

TEST_CASE("1e3 rocks that stand for 1e5 hit as all of them do", "[slow]") {
  const int real = 100'000, sampled = 1000, blasts = 40;
  const ExposurePlan roof{.name = "roof", .at = {150, 0}, .line = {}, .area = 2, .radius = 15};
  const auto run = [&](std::uint64_t seed, int rocks) {
    RandomStream rng(seed, "of_all", DrawKey{});
    TrialRecords records;
    for (int t = 0; t < blasts; ++t)
      for (int i = 0; i < rocks; ++i) {
        const double distance = reach * rng.uniform();
        add_landing(records, t, distance, 2 * pi * rng.uniform(), static_cast<double>(real) / rocks);
      }
    return exposed(roof, records, blasts, 3);
  };
  const double truth = 1 - std::exp(-real * roof.area * density_at(150));
  // All of a blast, in one blast: as many landings as the others have in a hundred.
  RandomStream rng(1, "all", DrawKey{});
  TrialRecords records;
  for (int i = 0; i < real; ++i) {
    const double distance = reach * rng.uniform();
    add_landing(records, 0, distance, 2 * pi * rng.uniform());
  }
  const ExposureSummary all = exposed(roof, records, 1, 3);
  CHECK(all.per_blast.upper == Approx(truth).epsilon(0.1));
  // Over seeds, what few rocks say scatters about what all say.
  double hits = 0;
  const int runs = 30;
  for (int seed = 1; seed <= runs; ++seed)
    hits += run(static_cast<std::uint64_t>(seed), sampled).hits_per_m2 / runs;
  // 3000 landings lie within the kernels, which weigh them unequally: 2.3 % is one standard deviation.
  CHECK(hits == Approx(real * density_at(150)).epsilon(0.07));
  CHECK(all.hits_per_m2 == Approx(real * density_at(150)).epsilon(0.1));
}

}  // namespace hit_coverage_test
