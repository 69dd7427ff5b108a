#pragma once
// A profile, prepared for contact search.

#include <vector>

#include "collision/motion.h"
#include "geometry/profile.h"

namespace flyrock {

enum class Corner { flat, convex, concave };

/// The poly-line with its normals, corners and a uniform grid over x. The ground is below.
class Terrain2 {
 public:
  explicit Terrain2(Profile profile);

  const Profile& profile() const { return profile_; }
  int segments() const { return profile_.segments(); }
  const Vec2& start(int segment) const { return profile_.points[segment]; }
  const Vec2& end(int segment) const { return profile_.points[segment + 1]; }
  const Vec2& point(int i) const { return profile_.points[i]; }
  const Vec2& tangent(int segment) const { return tangent_[segment]; }
  /// Out of the ground.
  const Vec2& normal(int segment) const { return normal_[segment]; }
  double length(int segment) const { return length_[segment]; }
  int part(int segment) const { return profile_.part[segment]; }
  /// How the poly-line bends at its point i; the end points are flat.
  Corner corner(int i) const { return corner_[i]; }
  Box2 box(int segment) const { return {start(segment).cwiseMin(end(segment)), start(segment).cwiseMax(end(segment))}; }

  /// The first segment whose right end is at or right of x.
  int first_segment(double x) const;
  /// The segments that meet [x_low, x_high]: a contiguous run, empty where first > last.
  struct Run {
    int first, last;
  };
  Run segments_between(double x_low, double x_high) const;

 private:
  Profile profile_;
  std::vector<Vec2> tangent_, normal_;
  std::vector<double> length_;
  std::vector<Corner> corner_;
  std::vector<int> grid_;  ///< first segment that reaches into a cell
  double cell_ = 1;
};

}  // namespace flyrock
