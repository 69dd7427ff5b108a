#pragma once
// Lines that bodies touch in 2D: the profile of a terrain, or the outline of a body that is not convex.

#include <vector>

#include "geometry/box.h"
#include "math/space.h"

namespace flyrock {

enum class Corner { flat, convex, concave };

/// Segments one after the other, with normals and corners. The solid is on the right of their direction. An
/// open line runs from left to right (x never decreases) and has a uniform grid over x. A closed one ends
/// where it begins: clockwise it is solid inside, counter-clockwise outside. Corner i lies between the
/// segments i - 1 and i. Metres.
class Ground2 {
 public:
  /// An open line; `part` of each segment.
  Ground2(std::vector<Vec2> points, std::vector<int> part);
  /// The outline of a solid, of one part. The last point is followed by the first.
  static Ground2 outline(const std::vector<Vec2>& points);

  int segments() const { return static_cast<int>(part_.size()); }
  const Vec2& start(int segment) const { return points_[segment]; }
  const Vec2& end(int segment) const { return points_[segment + 1]; }
  const Vec2& point(int i) const { return points_[i]; }
  const Vec2& tangent(int segment) const { return tangent_[segment]; }
  /// Unit normal out of the solid.
  const Vec2& normal(int segment) const { return normal_[segment]; }
  double length(int segment) const { return length_[segment]; }
  /// dy/dx; of an upright segment, whatever the division by 0 gives.
  double slope(int segment) const { return slope_[segment]; }
  int part(int segment) const { return part_[segment]; }
  /// How the line bends at its point i. The end points are flat.
  Corner corner(int i) const { return corner_[i]; }
  Box2 box(int segment) const {
    return {start(segment).cwiseMin(end(segment)), start(segment).cwiseMax(end(segment))};
  }
  bool closed() const { return closed_; }

  /// The contiguous run of segments that may meet [x_low, x_high]; empty if first > last. Of a closed line it
  /// is the whole line, or nothing.
  struct Run {
    int first, last;
  };
  Run segments_between(double x_low, double x_high, int near = -1) const;
  /// The first segment of an open line whose right end is at or right of x. The search is short if it starts
  /// `near` it (-1: nothing is known).
  int first_segment(double x, int near = -1) const {
    const bool is_near = near > 0 && end(near - 1).x() < x && x <= end(near).x();
    return is_near ? near : find_segment(x, near);
  }
  /// The highest y of an open line at x; that of its ends beyond them.
  double top(double x, int near = -1) const;
  /// Whether a place lies in the solid and not on its surface.
  bool is_inside(const Vec2& p) const;
  /// A run with the segment that is nearest to a place in the solid.
  Run near_inside(const Vec2& p) const;

 private:
  explicit Ground2(bool closed) : closed_(closed) {}
  void measure();
  int find_segment(double x, int near) const;

  std::vector<Vec2> points_;
  std::vector<int> part_;
  std::vector<Vec2> tangent_, normal_;
  std::vector<double> length_, slope_;
  std::vector<Corner> corner_;
  bool closed_ = false, solid_outside_ = false;
  Box2 extent_{Vec2::Zero(), Vec2::Zero()};
  std::vector<int> grid_;  ///< of an open line: the first segment that reaches into a cell
  double cell_ = 1;
};

}  // namespace flyrock
