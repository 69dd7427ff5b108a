#pragma once
// A profile, prepared for contact search.

#include <vector>

#include "collision/motion.h"
#include "geometry/profile.h"
#include "geometry/terrain_names.h"

namespace flyrock {

enum class Corner { flat, convex, concave };

/// The polyline with its normals, corners and a uniform grid over x. The ground is below it. The polyline
/// continues level for one kilometre beyond both ends of the profile, because a body whose centre is still
/// over the profile must not tip over its end. Segment and corner indices include these two extensions.
class Terrain2 {
 public:
  explicit Terrain2(Profile profile);

  const Profile& profile() const { return profile_; }
  /// The name of each part, as laws use it.
  const std::vector<std::string>& names() const { return names_; }
  int segments() const { return static_cast<int>(part_.size()); }
  const Vec2& start(int segment) const { return points_[segment]; }
  const Vec2& end(int segment) const { return points_[segment + 1]; }
  const Vec2& point(int i) const { return points_[i]; }
  const Vec2& tangent(int segment) const { return tangent_[segment]; }
  /// Unit normal out of the ground.
  const Vec2& normal(int segment) const { return normal_[segment]; }
  double length(int segment) const { return length_[segment]; }
  int part(int segment) const { return part_[segment]; }
  /// How the polyline bends at its point i. The end points are flat.
  Corner corner(int i) const { return corner_[i]; }
  Box2 box(int segment) const {
    return {start(segment).cwiseMin(end(segment)), start(segment).cwiseMax(end(segment))};
  }

  /// The height of the ground at x [m]; level beyond the profile.
  double height(double x) const;

  /// The first segment whose right end is at or right of x.
  int first_segment(double x) const;
  /// The contiguous run of segments that meet [x_low, x_high]; empty if first > last.
  struct Run {
    int first, last;
  };
  Run segments_between(double x_low, double x_high) const;

 private:
  Profile profile_;
  std::vector<std::string> names_;
  std::vector<Vec2> points_;
  std::vector<int> part_;
  std::vector<Vec2> tangent_, normal_;
  std::vector<double> length_;
  std::vector<Corner> corner_;
  std::vector<int> grid_;  ///< first segment that reaches into a cell
  double cell_ = 1;
};

}  // namespace flyrock
