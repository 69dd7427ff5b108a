#pragma once
// Numbers at the nodes of a square grid in plan, bilinear between them, and the region where they are large.

#include <vector>

#include "geometry/plan_region.h"

namespace flyrock {

class PlanField {
 public:
  PlanField() = default;
  /// Zero on a grid that covers the box from `low` to `high` with a margin of one cell at least. The cell is
  /// coarser than asked where it takes more than `most_nodes`.
  PlanField(const Vec2& low, const Vec2& high, double cell);
  static constexpr double most_nodes = 1e6;

  double cell() const { return cell_; }
  /// Bilinear; outside of the grid that of the nearest place on it.
  double at(const Vec2& place) const;

  /// Adds weight (1 - s^2 / radius^2) at distances s < radius from a place: Epanechnikov's kernel without its
  /// factor 2 / (pi radius^2).
  void add_kernel(const Vec2& place, double radius, double weight);
  /// Adds a field of the same grid.
  void add(const PlanField& other);

  /// The same where it is above 0; elsewhere minus the distance [m] from the nearest node where it is, as far
  /// as `margin` beyond the grid. At least one node must be above 0.
  PlanField with_distances(double margin) const;
  /// Lifts all nodes of the cells that meet a convex hull above every other value.
  void lift(const std::vector<Vec2>& hull);

  /// The outlines, counter-clockwise, of the region where the field is at least `level`, with its holes
  /// filled; linear along the edges of cells (marching squares). What reaches the border of the grid ends
  /// there.
  std::vector<PlanRing> region_above(double level) const;

 private:
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(i);
  }
  Vec2 place_of(int i, int j) const { return corner_ + cell_ * Vec2(i, j); }
  std::vector<char> outside_of(double level) const;

  Vec2 corner_ = Vec2::Zero();
  double cell_ = 0;
  int nx_ = 0, ny_ = 0;
  std::vector<float> values_;  ///< row by row, from the corner
};

/// The area of rings that do not overlap [m2].
double area_of(const std::vector<PlanRing>& rings);

}  // namespace flyrock
