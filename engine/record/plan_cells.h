#pragma once
// The extremes of one body's path in square cells in plan. Maps over many rocks are built from these cells.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// Square cells in rows from the south, each row from the west: the cell of column c and row r has the index
/// r columns + c and covers [low + (c, r) cell, low + (c + 1, r + 1) cell).
struct PlanGrid {
  Vec2 low = Vec2::Zero();  ///< m, the south-western corner
  double cell = 0;          ///< m
  std::int32_t columns = 0, rows = 0;

  bool empty() const { return columns <= 0 || rows <= 0; }
  std::uint32_t cells() const {
    return static_cast<std::uint32_t>(columns) * static_cast<std::uint32_t>(rows);
  }
  /// The same cells, counted from another origin.
  PlanGrid moved(const Vec2& by) const { return {low + by, cell, columns, rows}; }
  /// The cell of a place; nothing outside of the grid.
  std::optional<std::uint32_t> index(const Vec2& place) const;
  bool operator==(const PlanGrid&) const = default;
};

/// The greatest values of a body while its centre of mass was over a cell.
struct PlanCell {
  std::uint32_t index = 0;
  double height = 0;  ///< m, of the centre of mass above the ground below it; not below 0
  double speed = 0;   ///< m/s
  double energy = 0;  ///< J, kinetic
};

/// The cells that one body passed.
class PlanCells {
 public:
  /// Records nothing.
  PlanCells() = default;
  explicit PlanCells(const PlanGrid& grid) : grid_(grid) {}

  bool records() const { return !grid_.empty(); }

  /// Calls see(PlanCell&, t0, t1) for each cell over which p(t) = place + t rate passes in [from, to]. t0 and
  /// t1 are the times of entry and exit, exact on the straight line. Parts outside of the grid are left out.
  /// A line through a corner of four cells also passes one of the other two, for a time of 0.
  template <class See>
  void visit(const Vec2& place, const Vec2& rate, double from, double to, See see) {
    if (!clip(place, rate, from, to)) return;
    const Vec2 start = (place + from * rate - grid_.low) / grid_.cell,
               end = (place + to * rate - grid_.low) / grid_.cell;
    std::int32_t column = within(start.x(), grid_.columns), row = within(start.y(), grid_.rows);
    const std::int32_t last_column = within(end.x(), grid_.columns), last_row = within(end.y(), grid_.rows);
    for (double t = from;;) {
      const double at_x = leave(place.x() - grid_.low.x(), rate.x(), column, last_column);
      const double at_y = leave(place.y() - grid_.low.y(), rate.y(), row, last_row);
      const bool last = column == last_column && row == last_row;
      const double until = last ? to : std::clamp(std::min(at_x, at_y), t, to);
      see(at(static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(grid_.columns) +
             static_cast<std::uint32_t>(column)),
          t, until);
      if (last) return;
      t = until;
      if (at_x <= at_y)
        column += column < last_column ? 1 : -1;
      else
        row += row < last_row ? 1 : -1;
    }
  }

  /// The cells in the order of their indices, each once.
  const std::vector<PlanCell>& cells();

 private:
  /// Cuts [from, to] to the times within the grid. False if nothing is left.
  bool clip(const Vec2& place, const Vec2& rate, double& from, double& to) const;
  static std::int32_t within(double index, std::int32_t count) {
    return static_cast<std::int32_t>(std::clamp(std::floor(index), 0.0, static_cast<double>(count - 1)));
  }
  /// When a place `from` [m] from the low side leaves the column (or row) `at` towards `last`; infinity if it
  /// stays there.
  double leave(double from, double rate, std::int32_t at, std::int32_t last) const {
    if (at == last) return infinite;
    const double time = (static_cast<double>(at + (at < last ? 1 : 0)) * grid_.cell - from) / rate;
    return std::isfinite(time) ? time : 0;  // the ends differ by rounding only
  }
  PlanCell& at(std::uint32_t index);
  void compact();

  PlanGrid grid_;
  std::vector<PlanCell> cells_;  ///< a cell may stand there several times
  std::size_t sorted_ = 0;       ///< that many at the front are in order, each once
};

}  // namespace flyrock
