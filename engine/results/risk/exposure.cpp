#include "results/risk/exposure.h"

#include <algorithm>
#include <boost/math/distributions/gamma.hpp>
#include <cmath>
#include <span>

#include "results/risk/exposure_kernel.h"

namespace flyrock {

namespace {

constexpr std::size_t landings_held = 100;  ///< by a kernel whose radius nobody gave
constexpr double most_of_way = 0.1;         ///< of its radius

std::size_t group_of(const RockRecord& rock) { return static_cast<std::size_t>(rock.group); }

}  // namespace

Interval rare_interval(double sum, double squares, double greatest, std::uint64_t n, double confidence) {
  const auto trials = static_cast<double>(n);
  if (n == 0) return {unknown, unknown};
  const double mean = sum / trials, event = greatest / trials;
  if (!(sum > 0)) return {0, std::min(1.0, -std::log(1 - confidence) * event)};
  const double half = (1 - confidence) / 2;
  const double variance = std::max((squares - sum * mean) / (trials * trials), 1e-15 * mean * mean);
  const auto quantile = [](double of_mean, double of_variance, double p) {
    return boost::math::quantile(
        boost::math::gamma_distribution<>(of_mean * of_mean / of_variance, of_variance / of_mean), p);
  };
  return {quantile(mean, variance, half),
          std::min(1.0, quantile(mean + event, variance + event * event, 1 - half))};
}

ExposureTally::ExposureTally(const Scenario& scenario) : dimension_(scenario.dimension) {
  const std::size_t sets = scenario.rocks.size() > 1 ? 1 + scenario.rocks.size() : 1;
  for (const ExposurePlan& plan : scenario.exposures) {
    RockSet set;
    if (plan.has_traffic()) set.road.emplace_back(length_of(plan.line), plan.length);
    exposed_.push_back({.plan = plan, .radius = plan.radius, .sets = std::vector<RockSet>(sets, set)});
  }
  if (exposed_.empty()) stage_ = Stage::done;
}

void ExposureTally::add(const TrialRecords& chunk) {
  if (stage_ == Stage::done) return;
  for (const RockRecord& rock : chunk.rocks) {
    if (stage_ == Stage::count && rock.trial != trial_) close_trial();
    trial_ = rock.trial;
    if (rock.reason != StopReason::stopped) continue;
    stage_ == Stage::search ? search(rock) : count(rock);
  }
}

void ExposureTally::search(const RockRecord& rock) {
  ++landings_;
  releases_ += release_of(rock);
  heaviest_ = std::max(heaviest_, rock.weight);
  for (Exposed& exposed : exposed_) {
    exposed.sets.front().weights.add(rock.weight);
    if (exposed.sets.size() > 1) exposed.sets.at(1 + group_of(rock)).weights.add(rock.weight);
    if (exposed.radius > 0 || rock.end_energy < exposed.plan.energy) continue;
    const double s = ExposureKernel(exposed.plan, dimension_).distance(landing_of(rock));
    std::vector<double>& heap = exposed.nearest;
    if (heap.size() == landings_held && s >= heap.front()) continue;
    if (heap.size() == landings_held) {
      std::pop_heap(heap.begin(), heap.end());
      heap.pop_back();
    }
    heap.push_back(s);
    std::push_heap(heap.begin(), heap.end());
  }
}

void ExposureTally::choose_radii() {
  if (landings_ == 0) return;
  const Vec2 release = releases_ / static_cast<double>(landings_);
  for (Exposed& exposed : exposed_) {
    const ExposureKernel kernel(exposed.plan, dimension_);
    const double way = kernel.distance(release);
    if (!(exposed.radius > 0)) {
      const bool enough = exposed.nearest.size() == landings_held;
      exposed.radius = enough ? std::min(exposed.nearest.front(), most_of_way * way) : most_of_way * way;
      exposed.radius = std::max(exposed.radius, exposed.plan.least_radius());
      exposed.nearest = {};
    }
    const double missed = std::log1p(-kernel.greatest_chance(way, exposed.radius));
    const double event = -std::expm1(missed), heavy = -std::expm1(heaviest_ * missed);
    const double hit = -std::expm1(-exposed.plan.occupied);  // a vehicle, by a stone on the road
    for (RockSet& set : exposed.sets) {
      set.place.simulated.greatest = event;
      set.place.weighted.greatest = heavy;
      set.vehicle.simulated.greatest = hit * event;
      set.vehicle.weighted.greatest = hit * heavy;
    }
  }
}

void ExposureTally::count(const RockRecord& rock) {
  for (Exposed& exposed : exposed_) {
    if (rock.end_energy < exposed.plan.energy) continue;
    const ExposureKernel kernel(exposed.plan, dimension_);
    // The landing that gives the radius lies on the edge of the kernel and counts, with the weight 0.
    if (kernel.distance(landing_of(rock)) > exposed.radius) continue;
    const double way = kernel.distance(release_of(rock));
    const double q = kernel.chance(landing_of(rock), way, exposed.radius);
    std::optional<StoneOnRoad> on_road;
    if (exposed.plan.has_traffic()) on_road = kernel.on_road(landing_of(rock), exposed.radius);
    ++exposed.landings;
    exposed.density += rock.weight * q / exposed.plan.area;
    count(exposed.sets.front(), rock, q, on_road);
    if (exposed.sets.size() > 1) count(exposed.sets.at(1 + group_of(rock)), rock, q, on_road);
  }
}

void ExposureTally::count(RockSet& set, const RockRecord& rock, double chance,
                          const std::optional<StoneOnRoad>& on_road) {
  set.has_landing = true;
  set.near.add(rock.weight);
  set.log_missed += std::log1p(-chance);
  set.weighted_log_missed += rock.weight * std::log1p(-chance);
  if (!on_road) return;
  set.stones.push_back(*on_road);
  set.weighted_stones.push_back({on_road->at, carried(on_road->chance, rock.weight)});
}

void ExposureTally::Chances::add(double chance) {
  sum += chance;
  squares += chance * chance;
  greatest = std::max(greatest, chance);
}

void ExposureTally::Hits::add(double of_simulated, double of_weighted) {
  simulated.add(of_simulated);
  weighted.add(of_weighted);
}

void ExposureTally::close_trial() {
  for (Exposed& exposed : exposed_) {
    exposed.trials += exposed.sets.front().has_landing;
    for (RockSet& set : exposed.sets) close_trial(exposed.plan, set);
  }
}

void ExposureTally::close_trial(const ExposurePlan& plan, RockSet& set) {
  if (!set.has_landing) return;
  set.place.add(-std::expm1(set.log_missed), -std::expm1(set.weighted_log_missed));
  set.log_missed = set.weighted_log_missed = 0;
  set.has_landing = false;
  if (set.stones.empty()) return;
  for (std::vector<StoneOnRoad>* stones : {&set.stones, &set.weighted_stones})
    std::stable_sort(stones->begin(), stones->end(),
                     [](const StoneOnRoad& a, const StoneOnRoad& b) { return a.at < b.at; });
  const VehicleHits hits = vehicle_hits(set.stones, plan.length, plan.vehicles_per_metre()),
                    real = set.weights.any()
                               ? vehicle_hits(set.weighted_stones, plan.length, plan.vehicles_per_metre())
                               : hits;
  set.vehicle.add(hits.chance, real.chance);
  set.covered += hits.covered;
  if (set.weights.any()) set.road.front().add(set.stones);
  set.stones.clear();
  set.weighted_stones.clear();
}

bool ExposureTally::needs_another_pass() {
  if (stage_ == Stage::search) {
    choose_radii();
    stage_ = Stage::count;
    return true;
  }
  if (stage_ == Stage::count) close_trial();
  stage_ = Stage::done;
  return false;
}

SimulatedBlasts ExposureTally::Hits::blasts(std::uint64_t trials, const WeightRange& weights,
                                            const WeightRange& near) const {
  const auto interval = [&](const Chances& chances) {
    return rare_interval(chances.sum, chances.squares, chances.greatest, trials, stated_confidence);
  };
  const auto n = static_cast<double>(trials);
  return {simulated.sum / n, interval(simulated), weighted.sum / n, interval(weighted), weights, near};
}

/// With weights a vehicle that several real rocks hit is one: U is also at most 1 - exp(-rho integral of
/// U(s)), with U(s) = 1 - (1 - S(s))^w at each place of the road. Its upper end is that of S(s) as many times
/// as great as the upper end of S.
BlastBounds ExposureTally::vehicle_bounds(const ExposurePlan& plan, const RockSet& set,
                                          std::uint64_t trials) {
  const SimulatedBlasts blasts = set.vehicle.blasts(trials, set.weights, set.near);
  BlastBounds bounds = bounds_of(blasts);
  if (!(bounds.weight > 1) || !(blasts.share > 0)) return bounds;
  const auto hit = [&](double factor) {
    return -std::expm1(-plan.vehicles_per_metre() *
                       set.road.front().covered(trials, factor, set.weights.greatest()));
  };
  bounds.upper = std::min(bounds.upper, hit(1));
  bounds.interval.upper = std::min(bounds.interval.upper, hit(blasts.share_interval.upper / blasts.share));
  return bounds;
}

void ExposureTally::put_bounds(const Exposed& exposed, std::uint64_t trials, ExposureSummary& summary) {
  const ExposurePlan& plan = exposed.plan;
  const RockSet& all = exposed.sets.front();
  std::vector<BlastBounds> places, vehicles;
  for (const RockSet& set : exposed.sets) {
    places.push_back(bounds_of(set.place.blasts(trials, set.weights, set.near)));
    if (plan.has_traffic()) vehicles.push_back(vehicle_bounds(plan, set, trials));
  }
  const auto of_all = [&](const std::vector<BlastBounds>& bounds) {
    return all.weights.differ() ? over_groups(bounds.front(), std::span(bounds).subspan(1)) : bounds.front();
  };
  summary.per_blast = of_all(places);
  if (!plan.has_traffic()) return;
  summary.road_hit = summary.per_blast.upper;
  summary.per_blast = of_all(vehicles);
  const double covered = all.weights.any() ? all.road.front().covered(trials, 1, all.weights.greatest())
                                           : all.covered / static_cast<double>(trials);
  summary.expected_vehicles = plan.vehicles_per_metre() * covered;
}

std::vector<ExposureSummary> ExposureTally::summaries(std::uint64_t trials, Told told) const {
  std::vector<ExposureSummary> list;
  for (const Exposed& exposed : exposed_) {
    const ExposurePlan& plan = exposed.plan;
    ExposureSummary& summary = list.emplace_back();
    if (trials == 0 || !(exposed.radius > 0)) continue;
    summary.landings = exposed.landings;
    summary.trials = exposed.trials;
    if (told == Told::counts) continue;
    summary.radius = exposed.radius;
    summary.hits_per_m2 = exposed.density / static_cast<double>(trials);
    put_bounds(exposed, trials, summary);
    const double present = plan.has_traffic() ? 1 : plan.occupied;
    const auto per_year = [&](double p) {
      return -std::expm1(plan.blasts_per_year * std::log1p(-p * present));
    };
    summary.per_year = per_year(summary.per_blast.upper);
    summary.per_year_interval = {per_year(summary.per_blast.interval.lower),
                                 per_year(summary.per_blast.interval.upper)};
  }
  return list;
}

}  // namespace flyrock
