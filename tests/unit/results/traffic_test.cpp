// A stream of vehicles and the stones of a blast on a road.

#include "results/risk/traffic.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "random/stream.h"
#include "results/risk/exposure.h"

using namespace flyrock;

namespace traffic_test {

TEST_CASE("Of stones that are there for certain, the covered length tells whether a vehicle is hit") {
  const double vehicle = 4.5, rho = 0.02;
  const std::vector<StoneOnRoad> one{{3, 1}}, overlapping{{3, 1}, {5, 1}, {40, 1}};
  const VehicleHits of_one = vehicle_hits(one, vehicle, rho),
                    of_three = vehicle_hits(overlapping, vehicle, rho);
  CHECK(of_one.covered == Approx(4.5));
  CHECK(of_one.chance == Approx(1 - std::exp(-0.02 * 4.5)));
  CHECK(of_three.covered == Approx(4.5 + 2 + 4.5));
  CHECK(of_three.chance == Approx(1 - std::exp(-0.02 * 11)));
  CHECK(vehicle_hits({}, vehicle, rho).chance == 0);
}

TEST_CASE("Of stones that may be there, the mean over all they may do tells it") {
  const double vehicle = 4, rho = 0.3;
  const std::vector<StoneOnRoad> stones{{0, 0.3}, {1, 0.8}, {1, 0.5}, {4.5, 0.6}, {20, 0.4}, {23, 0.9}};
  double chance = 0, covered = 0;
  for (unsigned which = 0; which < 1u << stones.size(); ++which) {
    double probability = 1, length = 0, end = -1e9;
    for (std::size_t i = 0; i < stones.size(); ++i) {
      const bool is_there = which >> i & 1u;
      probability *= is_there ? stones[i].chance : 1 - stones[i].chance;
      if (!is_there) continue;
      length += std::min(vehicle, stones[i].at + vehicle - end);
      end = stones[i].at + vehicle;
    }
    chance += probability * (1 - std::exp(-rho * length));
    covered += probability * length;
  }
  const VehicleHits found = vehicle_hits(stones, vehicle, rho);
  CHECK(found.chance == Approx(chance).epsilon(1e-12));
  CHECK(found.covered == Approx(covered).epsilon(1e-12));
}

TEST_CASE("Of a road that stones cover in some trials, the integral is that of each place") {
  CoveredRoad road(10, 4);
  const std::vector<StoneOnRoad> stone{{5, 1}}, two{{5, 0.5}, {5, 0.5}};
  road.add(stone);
  road.add(two);
  CHECK(road.covered(4, 1, 1) == Approx(4 * (1 + 0.75) / 4));
  CHECK(road.covered(4, 1, 3) == Approx(4 * (1 - std::pow(1 - 1.75 / 4, 3))));
}

// Stones land evenly on a field about a road along y. Vehicles and stones are drawn one by one.
struct Crossing {
  double length, stones;  ///< m; mean number of stones on the strip
  double vehicles_per_hour, speed;
};
constexpr double vehicle = 4.5, width = 1.8, x_of_road = 100, aside = 6, beyond = 6;

int poisson(RandomStream& rng, double mean) {
  int n = -1;
  for (double product = 1; product > std::exp(-mean); ++n) product *= rng.uniform();
  return n;
}

double per_metre(const Crossing& crossing) { return crossing.vehicles_per_hour / 3600 / crossing.speed; }

struct Truth {
  double covered, drawn;  ///< from the length that stones cover; from vehicles that are drawn one by one
};

/// Whether a vehicle is hit, of blasts whose stones on the strip are drawn one by one.
Truth truth_of(const Crossing& crossing, int blasts) {
  RandomStream rng(17, "truth", DrawKey{});
  const double road = crossing.length + 2 * vehicle;
  double covered = 0, drawn = 0;
  for (int b = 0; b < blasts; ++b) {
    std::vector<StoneOnRoad> stones;
    for (int i = poisson(rng, crossing.stones); i > 0; --i)
      stones.push_back({crossing.length * rng.uniform(), 1});
    bool is_hit = false;
    for (int i = poisson(rng, per_metre(crossing) * road); i > 0; --i) {
      const double centre = road * rng.uniform() - vehicle;
      for (const StoneOnRoad& stone : stones) is_hit = is_hit || std::abs(centre - stone.at) < vehicle / 2;
    }
    std::sort(stones.begin(), stones.end(),
              [](const StoneOnRoad& one, const StoneOnRoad& other) { return one.at < other.at; });
    covered += vehicle_hits(stones, vehicle, per_metre(crossing)).chance / blasts;
    drawn += static_cast<double>(is_hit) / blasts;
  }
  return {covered, drawn};
}

ExposureSummary run_of(const Crossing& crossing, int trials, std::uint64_t seed, double weight = 1) {
  Scenario scenario;
  scenario.dimension = 3;
  ExposurePlan road{.name = "road",
                    .line = {{x_of_road, 0}, {x_of_road, crossing.length}},
                    .area = vehicle * width,
                    .length = vehicle};
  road.occupied = per_metre(crossing) * vehicle;
  road.is_stream = true;
  scenario.exposures = {road};
  const double field = (crossing.length + 2 * beyond) * 2 * aside,
               stones = crossing.stones * field / (crossing.length * width);
  RandomStream rng(seed, "run", DrawKey{});
  TrialRecords records;
  for (int t = 0; t < trials; ++t)
    for (int i = poisson(rng, stones / weight); i > 0; --i) {
      RockRecord& rock = records.rocks.emplace_back();
      rock.trial = static_cast<std::uint64_t>(t);
      rock.reason = StopReason::stopped;
      rock.weight = weight;
      rock.stop_x = x_of_road + aside * (2 * rng.uniform() - 1);
      rock.stop_y = (crossing.length + 2 * beyond) * rng.uniform() - beyond;
    }
  ExposureTally tally(scenario);
  do tally.add(records);
  while (tally.needs_another_pass());
  return tally.summaries(static_cast<std::uint64_t>(trials)).front();
}

TEST_CASE("A stream of vehicles: the interval holds the truth in 91 to 99 % of the runs", "[slow]") {
  const Crossing crossings[] = {{30, 6.5, 120, 50 / 3.6},
                                {3, 5, 120, 50 / 3.6},
                                {60, 0.1, 120, 50 / 3.6},
                                {20, 1, 900, 30 / 3.6},
                                {3, 0.3, 900, 30 / 3.6}};
  for (const Crossing& crossing : crossings) {
    INFO(crossing.length << " m, " << crossing.stones << " stones");
    const int blasts = 50000;
    const auto [truth, drawn] = truth_of(crossing, blasts);
    CHECK(std::abs(drawn - truth) < 3.5 * std::sqrt(truth / blasts));
    int held = 0;
    constexpr int seeds = 60;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const Interval interval = run_of(crossing, 200, seed).per_blast.interval;
      held += interval.lower <= truth && truth <= interval.upper;
    }
    CHECK(held >= 0.87 * seeds);  // 91 %, less a standard deviation of 60 runs
  }
}

TEST_CASE("Stones of weight 10 bound what all stones do to the vehicles of a road") {
  const Crossing crossing{30, 10, 120, 50 / 3.6};
  const ExposureSummary all = run_of(crossing, 400, 1), few = run_of(crossing, 4000, 2, 10);
  CHECK(few.per_blast.lower < all.per_blast.upper);
  CHECK(few.per_blast.upper > 0.97 * all.per_blast.upper);
  CHECK(few.per_blast.upper < 1.1 * all.per_blast.upper);
  CHECK(all.per_blast.tells());
  CHECK(few.expected_vehicles == Approx(all.expected_vehicles).epsilon(0.08));
}

}  // namespace traffic_test
