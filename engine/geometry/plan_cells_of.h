#pragma once
// Things by the square cells in plan that their boxes touch, to find those near a place.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// Add all things, sort, then visit. A thing whose box touches several cells may be visited several times.
template <class Thing>
class PlanCellsOf {
 public:
  explicit PlanCellsOf(double cell) : cell_(cell) {}  ///< m

  void add(const Vec2& low, const Vec2& high, const Thing& thing) {
    for_cells(low, high, [&](std::int64_t column, std::int64_t row) {
      entries_.push_back({column, row, thing});
      return true;
    });
  }

  void sort() {
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
      return std::tie(a.column, a.row, a.thing) < std::tie(b.column, b.row, b.thing);
    });
  }

  /// Calls `see(thing)` for the things in the cells that a box touches.
  template <class See>
  void visit(const Vec2& low, const Vec2& high, See see) const {
    for_cells(low, high, [&](std::int64_t column, std::int64_t row) {
      auto entry =
          std::lower_bound(entries_.begin(), entries_.end(), std::tie(column, row),
                           [](const Entry& e, const auto& key) { return std::tie(e.column, e.row) < key; });
      for (; entry != entries_.end() && entry->column == column && entry->row == row; ++entry)
        see(entry->thing);
      return true;
    });
  }

 private:
  struct Entry {
    std::int64_t column, row;
    Thing thing;
  };

  template <class Use>
  void for_cells(const Vec2& low, const Vec2& high, Use use) const {
    const auto index = [this](double x) { return static_cast<std::int64_t>(std::floor(x / cell_)); };
    for (std::int64_t column = index(low.x()); column <= index(high.x()); ++column)
      for (std::int64_t row = index(low.y()); row <= index(high.y()); ++row) use(column, row);
  }

  double cell_;
  std::vector<Entry> entries_;
};

}  // namespace flyrock
