#include "record/plan_cells.h"

namespace flyrock {

std::optional<std::uint32_t> PlanGrid::index(const Vec2& place) const {
  if (empty()) return std::nullopt;
  const Vec2 at = (place - low) / cell;
  if (!(at.x() >= 0 && at.x() < columns && at.y() >= 0 && at.y() < rows)) return std::nullopt;
  return static_cast<std::uint32_t>(at.y()) * static_cast<std::uint32_t>(columns) +
         static_cast<std::uint32_t>(at.x());
}

bool PlanCells::clip(const Vec2& place, const Vec2& rate, double& from, double& to) const {
  if (grid_.empty() || !place.allFinite() || !rate.allFinite()) return false;
  const Vec2 size(grid_.columns * grid_.cell, grid_.rows * grid_.cell);
  for (int k = 0; k < 2; ++k) {
    const double start = place[k] - grid_.low[k];
    if (rate[k] == 0) {
      if (start < 0 || start > size[k]) return false;
      continue;
    }
    const double low = -start / rate[k], high = (size[k] - start) / rate[k];
    from = std::max(from, std::min(low, high));
    to = std::min(to, std::max(low, high));
  }
  return from <= to;
}

PlanCell& PlanCells::at(std::uint32_t index) {
  if (!cells_.empty() && cells_.back().index == index) return cells_.back();
  constexpr std::size_t least_room = 256;
  if (cells_.size() >= std::max(least_room, 2 * sorted_)) compact();
  return cells_.emplace_back(PlanCell{.index = index});
}

void PlanCells::compact() {
  std::sort(cells_.begin(), cells_.end(),
            [](const PlanCell& a, const PlanCell& b) { return a.index < b.index; });
  std::size_t kept = 0;
  for (const PlanCell& cell : cells_) {
    if (kept == 0 || cells_[kept - 1].index != cell.index) {
      cells_[kept++] = cell;
      continue;
    }
    PlanCell& known = cells_[kept - 1];
    known.height = std::max(known.height, cell.height);
    known.speed = std::max(known.speed, cell.speed);
    known.energy = std::max(known.energy, cell.energy);
  }
  cells_.resize(kept);
  sorted_ = kept;
}

const std::vector<PlanCell>& PlanCells::cells() {
  compact();
  return cells_;
}

}  // namespace flyrock
