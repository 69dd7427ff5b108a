#include "survey/fill_voids.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

namespace {

class VoidFiller {
 public:
  VoidFiller(HeightGrid& grid, int most) : grid_(grid), most_(most), seen_(grid.heights.size(), false) {}

  FilledVoids fill() {
    FilledVoids filled;
    for (std::size_t seed = 0; seed < grid_.heights.size(); ++seed) {
      if (seen_[seed] || !is_void(seed)) continue;
      gather(seed);
      if (!is_small_) continue;
      stretch_membrane();
      ++filled.count;
      filled.cells += static_cast<int>(cells_.size());
    }
    return filled;
  }

 private:
  bool is_void(std::size_t cell) const { return std::isnan(grid_.heights[cell]); }
  int column(std::size_t cell) const {
    return static_cast<int>(cell % static_cast<std::size_t>(grid_.columns));
  }
  int row(std::size_t cell) const { return static_cast<int>(cell / static_cast<std::size_t>(grid_.columns)); }
  std::size_t cell(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns) +
           static_cast<std::size_t>(column);
  }

  /// The cells of a void, and whether it is small and inside.
  void gather(std::size_t seed) {
    cells_.assign(1, seed);
    seen_[seed] = true;
    int west = column(seed), east = west, south = row(seed), north = south;
    for (std::size_t next = 0; next < cells_.size(); ++next) {
      const int i = column(cells_[next]), j = row(cells_[next]);
      west = std::min(west, i);
      east = std::max(east, i);
      south = std::min(south, j);
      north = std::max(north, j);
      for (int y = std::max(0, j - 1); y <= std::min(grid_.rows - 1, j + 1); ++y)
        for (int x = std::max(0, i - 1); x <= std::min(grid_.columns - 1, i + 1); ++x) {
          const std::size_t other = cell(x, y);
          if (seen_[other] || !is_void(other)) continue;
          seen_[other] = true;
          cells_.push_back(other);
        }
    }
    const bool is_inside = west > 0 && south > 0 && east + 1 < grid_.columns && north + 1 < grid_.rows;
    is_small_ = is_inside && east - west < most_ && north - south < most_;
  }

  /// Successive over-relaxation from the mean height of the edge. Source: Young, D. (1954): Iterative methods
  /// for solving partial difference equations of elliptic type. Trans. Amer. Math. Soc. 76.
  void stretch_membrane() {
    std::sort(cells_.begin(), cells_.end());
    const auto width = static_cast<std::size_t>(grid_.columns);
    auto& z = grid_.heights;
    double sum = 0;
    int edge = 0;
    for (const std::size_t c : cells_)
      for (const std::size_t other : {c - 1, c + 1, c - width, c + width})
        if (!std::isnan(z[other])) {
          sum += z[other];
          ++edge;
        }
    for (const std::size_t c : cells_) z[c] = sum / edge;
    const double factor = 2 / (1 + std::sin(pi / (most_ + 1)));
    constexpr double close = 1e-6;  // m, of a pass; 100 passes are still to come at most
    double change = 1;
    for (int pass = 0; change > close && pass < 100'000; ++pass) {
      change = 0;
      for (const std::size_t c : cells_) {
        const double step = factor * (0.25 * (z[c - 1] + z[c + 1] + z[c - width] + z[c + width]) - z[c]);
        z[c] += step;
        change = std::max(change, std::abs(step));
      }
    }
  }

  HeightGrid& grid_;
  int most_;
  std::vector<bool> seen_;
  std::vector<std::size_t> cells_;
  bool is_small_ = false;
};

}  // namespace

FilledVoids fill_voids(HeightGrid& grid, int most) { return VoidFiller(grid, most).fill(); }

}  // namespace flyrock
