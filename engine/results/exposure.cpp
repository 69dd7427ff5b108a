#include "results/exposure.h"

#include <algorithm>
#include <boost/math/distributions/gamma.hpp>
#include <cmath>

namespace flyrock {

namespace {

constexpr std::size_t landings_held = 100;  ///< by a kernel whose radius nobody gave
constexpr double most_of_way = 0.1;         ///< of its radius

Vec2 landing_of(const RockRecord& rock) { return {rock.stop_x, rock.stop_y}; }
Vec2 release_of(const RockRecord& rock) { return {rock.start_x, rock.start_y}; }

/// The place of the line from a to b that is nearest to `place`.
Vec2 nearest_on(const Vec2& a, const Vec2& b, const Vec2& place) {
  const Vec2 way = b - a;
  return a + std::clamp((place - a).dot(way) / way.squaredNorm(), 0.0, 1.0) * way;
}

double length_of(const std::vector<Vec2>& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return length;
}

/// Epanechnikov's kernel over a line [1/m] and over a plane [1/m2].
double kernel_in_line(double s, double radius) {
  const double u = s / radius;
  return 0.75 / radius * std::max(0.0, 1 - u * u);
}
double kernel_in_plan(double s, double radius) {
  const double u = s / radius;
  return 2 / (pi * radius * radius) * std::max(0.0, 1 - u * u);
}

/// The integral of the kernel over a plane about `place` along the line from a to b [1/m].
double kernel_along(const Vec2& a, const Vec2& b, const Vec2& place, double radius) {
  const double length = (b - a).norm();
  const Vec2 along = (b - a) / length;
  const double middle = along.dot(place - a), aside = std::abs(cross(along, Vec2(place - a))) / radius;
  if (aside >= 1) return 0;
  const double half = std::sqrt(1 - aside * aside);
  const auto integral = [&](double at) {  // of 1 - aside^2 - u^2 from 0
    const double u = std::clamp((at - middle) / radius, -half, half);
    return u * (half * half - u * u / 3);
  };
  return 2 / (pi * radius) * (integral(length) - integral(0));
}

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
  for (const ExposurePlan& plan : scenario.exposures)
    exposed_.push_back({.plan = plan, .radius = plan.radius});
  if (exposed_.empty()) stage_ = Stage::done;
}

double ExposureTally::distance(const ExposurePlan& plan, const Vec2& place) const {
  if (dimension_ == 2) return std::abs(place.x() - plan.at.x());
  if (plan.line.empty()) return (place - plan.at).norm();
  double least = infinite;
  for (std::size_t i = 1; i < plan.line.size(); ++i)
    least = std::min(least, (nearest_on(plan.line[i - 1], plan.line[i], place) - place).norm());
  return least;
}

double ExposureTally::part_of_area(const ExposurePlan& plan, double way) const {
  if (dimension_ == 2) return plan.area / (plan.spread * way);
  if (plan.line.empty()) return plan.area;
  return plan.area / (plan.length > 0 ? plan.length : length_of(plan.line));
}

double ExposureTally::kernel_at(const Exposed& exposed, const Vec2& landing) const {
  const ExposurePlan& plan = exposed.plan;
  if (dimension_ == 2) return kernel_in_line(landing.x() - plan.at.x(), exposed.radius);
  if (plan.line.empty()) return kernel_in_plan((landing - plan.at).norm(), exposed.radius);
  double along = 0;
  for (std::size_t i = 1; i < plan.line.size(); ++i)
    along += kernel_along(plan.line[i - 1], plan.line[i], landing, exposed.radius);
  return along;
}

double ExposureTally::kernel_peak(const Exposed& exposed) const {
  if (dimension_ == 2) return kernel_in_line(0, exposed.radius);
  return exposed.plan.line.empty() ? kernel_in_plan(0, exposed.radius) : 8 / (3 * pi * exposed.radius);
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
    if (exposed.radius > 0 || rock.end_energy < exposed.plan.energy) continue;
    const double s = distance(exposed.plan, landing_of(rock));
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
    const double way = distance(exposed.plan, release);
    if (!(exposed.radius > 0)) {
      const bool enough = exposed.nearest.size() == landings_held;
      exposed.radius = enough ? std::min(exposed.nearest.front(), most_of_way * way) : most_of_way * way;
      exposed.radius = std::max(exposed.radius, exposed.plan.least_radius());
      exposed.nearest = {};
    }
    const double greatest = std::min(1.0, part_of_area(exposed.plan, way) * kernel_peak(exposed));
    exposed.greatest = -std::expm1(heaviest_ * std::log1p(-greatest));
  }
}

void ExposureTally::count(const RockRecord& rock) {
  for (Exposed& exposed : exposed_) {
    if (rock.end_energy < exposed.plan.energy) continue;
    // The landing that gives the radius lies on the edge of the kernel and counts, with the weight 0.
    if (distance(exposed.plan, landing_of(rock)) > exposed.radius) continue;
    const double way = distance(exposed.plan, release_of(rock));
    const double q = std::min(1.0, part_of_area(exposed.plan, way) * kernel_at(exposed, landing_of(rock)));
    ++exposed.landings;
    exposed.has_landing = true;
    exposed.density += rock.weight * q / exposed.plan.area;
    exposed.log_missed += rock.weight * std::log1p(-q);
  }
}

void ExposureTally::close_trial() {
  for (Exposed& exposed : exposed_) {
    if (!exposed.has_landing) continue;
    const double hit = -std::expm1(exposed.log_missed);
    ++exposed.trials;
    exposed.sum += hit;
    exposed.squares += hit * hit;
    exposed.greatest = std::max(exposed.greatest, hit);
    exposed.log_missed = 0;
    exposed.has_landing = false;
  }
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

std::vector<ExposureSummary> ExposureTally::summaries(std::uint64_t trials) const {
  std::vector<ExposureSummary> list;
  for (const Exposed& exposed : exposed_) {
    const ExposurePlan& plan = exposed.plan;
    ExposureSummary& summary = list.emplace_back();
    if (trials == 0 || !(exposed.radius > 0)) continue;
    summary.radius = exposed.radius;
    summary.landings = exposed.landings;
    summary.trials = exposed.trials;
    summary.hits_per_m2 = exposed.density / static_cast<double>(trials);
    summary.per_blast = exposed.sum / static_cast<double>(trials);
    summary.interval =
        rare_interval(exposed.sum, exposed.squares, exposed.greatest, trials, stated_confidence);
    const auto per_year = [&](double p) {
      return -std::expm1(plan.blasts_per_year * std::log1p(-p * plan.occupied));
    };
    summary.per_year = per_year(summary.per_blast);
    summary.per_year_interval = {per_year(summary.interval.lower), per_year(summary.interval.upper)};
  }
  return list;
}

}  // namespace flyrock
