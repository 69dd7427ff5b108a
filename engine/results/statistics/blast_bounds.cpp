#include "results/statistics/blast_bounds.h"

#include <algorithm>
#include <cmath>

#include "math/space.h"

namespace flyrock {

double carried(double p, double weight) {
  return weight == 1 ? p : -std::expm1(weight * std::log1p(-std::min(p, 1.0)));
}

bool BlastBounds::tells() const { return !(upper > telling_ratio * lower); }

BlastBounds bounds_of(const SimulatedBlasts& rocks) {
  const WeightRange& all = rocks.weights;
  const WeightRange& doing = rocks.doing.any_rock() ? rocks.doing : all;
  if (!all.any_rock()) return {rocks.share, rocks.share, rocks.share_interval, 1};
  BlastBounds bounds;
  bounds.weight = doing.greatest();
  bounds.lower = doing.least() < 1 ? carried(rocks.share, doing.least()) : rocks.product;
  bounds.upper = doing.greatest() < 1 ? rocks.product : carried(rocks.share, doing.greatest());
  bounds.interval.lower =
      all.least() < 1 ? carried(rocks.share_interval.lower, all.least()) : rocks.product_interval.lower;
  bounds.interval.upper =
      all.greatest() < 1 ? rocks.product_interval.upper : carried(rocks.share_interval.upper, all.greatest());
  return bounds;
}

BlastBounds over_groups(const BlastBounds& all, std::span<const BlastBounds> groups) {
  if (groups.empty()) return all;
  BlastBounds bounds = groups.front();
  for (const BlastBounds& group : groups.subspan(1)) {
    bounds.upper += group.upper;
    bounds.interval.upper += group.interval.upper;
    if (!(group.lower > bounds.lower)) continue;
    bounds.lower = group.lower;
    bounds.interval.lower = group.interval.lower;
  }
  bounds.upper = std::min(all.upper, bounds.upper);
  bounds.interval.upper = std::min(all.interval.upper, bounds.interval.upper);
  bounds.weight = all.weight;
  return bounds;
}

double telling_weight(const BlastBounds& bounds) {
  const auto& [lower, upper, interval, weight] = bounds;
  if (weight <= 1) return 1;
  double least = harmless_weight;
  if (lower > 0 && lower < 1) least = std::log1p(-lower) / std::log1p(-lower / telling_ratio);
  const double excess = lower > 0 ? upper / lower - 1 : infinite;
  const double inverse = 1 - (telling_ratio - 1) * (1 - 1 / weight) / excess;
  const double spread = inverse > 0 ? 1 / inverse : weight;
  return std::floor(10 *
                    std::clamp(std::max(least, spread), harmless_weight, std::max(weight, harmless_weight))) /
         10;
}

}  // namespace flyrock
