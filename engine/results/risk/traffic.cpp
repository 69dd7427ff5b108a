#include "results/risk/traffic.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "results/statistics/blast_bounds.h"

namespace flyrock {

VehicleHits vehicle_hits(std::span<const StoneOnRoad> stones, double vehicle, double per_metre) {
  VehicleHits hits;
  double none = 1;                          // W: no vehicle is hit by the stones so far
  std::vector<double> last(stones.size());  // A: the same where it is the last one
  const double missed_alone = std::exp(-per_metre * vehicle);
  for (std::size_t j = 0; j < stones.size(); ++j) {
    double miss = 1, recent = 0, with_recent = 0, added = 0;
    for (std::size_t k = j; k-- > 0;) {
      const double gap = stones[j].at - stones[k].at;
      if (gap >= vehicle) break;
      recent += last[k] * miss;
      with_recent += last[k] * miss * std::exp(-per_metre * gap);
      added += stones[k].chance * miss * gap;
      miss *= 1 - stones[k].chance;
    }
    added += miss * vehicle;
    const double p = stones[j].chance;
    last[j] = p * (missed_alone * (none - recent) + with_recent);
    none = (1 - p) * none + last[j];
    hits.covered += p * added;
  }
  hits.chance = 1 - none;
  return hits;
}

namespace {

constexpr double cells_a_vehicle = 16;

}  // namespace

CoveredRoad::CoveredRoad(double line, double vehicle) : vehicle_(vehicle) {
  const double whole = line + vehicle;
  const double cells = std::ceil(cells_a_vehicle * whole / vehicle);
  cell_ = whole / cells;
  log_missed_.assign(static_cast<std::size_t>(cells), 0);
  sum_.assign(static_cast<std::size_t>(cells), 0);
}

void CoveredRoad::add(std::span<const StoneOnRoad> stones) {
  const auto cells = static_cast<double>(sum_.size());
  // The cells whose middles a stone covers: the first cell begins half a vehicle before the line.
  const auto range = [&](const StoneOnRoad& stone) {
    const auto from = static_cast<std::size_t>(std::clamp(std::ceil(stone.at / cell_ - 0.5), 0.0, cells));
    const auto to =
        static_cast<std::size_t>(std::clamp(std::ceil((stone.at + vehicle_) / cell_ - 0.5), 0.0, cells));
    return std::pair{from, to};
  };
  for (const StoneOnRoad& stone : stones) {
    const auto [from, to] = range(stone);
    for (std::size_t c = from; c < to; ++c) log_missed_[c] += std::log1p(-stone.chance);
  }
  for (const StoneOnRoad& stone : stones) {
    const auto [from, to] = range(stone);
    for (std::size_t c = from; c < to; ++c) sum_[c] -= std::expm1(std::exchange(log_missed_[c], 0));
  }
}

double CoveredRoad::covered(std::uint64_t trials, double factor, double weight) const {
  double length = 0;
  for (const double sum : sum_)
    length += cell_ * carried(std::min(1.0, factor * sum / static_cast<double>(trials)), weight);
  return length;
}

}  // namespace flyrock
