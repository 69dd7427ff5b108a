#pragma once
// The walls of contactors that are solid outside of a convex region, such as a drum. They touch from inside:
// at each vertex of the other contactor, and at the one or two places of each of its rims that are nearest.

#include <boost/container/static_vector.hpp>

#include "collision/contact.h"
#include "collision/placed.h"

namespace flyrock {

/// A circle of places centre + cos phi a + sin phi b. In the world, from the origin of the hollow contactor.
struct Ring {
  Vec3 centre, a, b;

  Vec3 at(double angle) const { return centre + std::cos(angle) * a + std::sin(angle) * b; }
};

/// The wall of a hollow disk about the origin of its frame. `from` is a place, seen from the centre.
class HollowWall2 {
 public:
  /// `swell` [m]: by how much its radius is larger than given.
  explicit HollowWall2(const Placed2& hollow, double swell = 0) : radius_(hollow.shape.radius + swell) {}

  /// How far a place is from the wall [m]: R - rho. The region is convex, so the gap is a concave function of
  /// the place, and over a hull it is least at one of its points.
  double gap(const Vec2& from) const { return radius_ - from.norm(); }
  /// Unit, out of the wall at the place of it that is nearest.
  Vec2 normal(const Vec2& from) const;
  /// Whether a contactor touches the wall: its middle is inside. That of a point may be on the wall, and in
  /// it by what a step leaves.
  bool contains(const Vec2& middle) const { return middle.norm() < radius_ * (1 + wall_share); }
  static constexpr double wall_share = 1e-4;

 private:
  double radius_;
};

/// The wall of a hollow cylinder, whose axis goes through the origin of its frame, or the plane through the
/// origin that bounds a half space. `axis`: of the cylinder, or the normal of the plane; unit, world frame.
class HollowWall3 {
 public:
  explicit HollowWall3(const Placed3& hollow);

  /// As in 2D; rho is the distance from the axis. Over a plane it is the height.
  double gap(const Vec3& from) const;
  Vec3 normal(const Vec3& from) const;
  /// Where the gap over a ring is least locally, the least first: one or two angles.
  boost::container::static_vector<double, 2> nearest(const Ring& ring) const;
  double least_gap(const Ring& ring) const { return gap(ring.at(nearest(ring)[0])); }
  /// Whether a contactor touches the wall: its middle is inside, between the ends of a hollow cylinder.
  bool contains(const Vec3& middle) const;
  const Vec3& axis() const { return axis_; }
  bool is_plane() const { return plane_; }
  /// Between the middle and each end of a hollow cylinder, along the axis; infinite for a plane [m].
  double half_length() const { return half_; }
  /// On the axis, where the gap has no slope; infinite for a plane [m].
  double greatest_gap() const { return radius_; }

 private:
  bool plane_;
  Vec3 axis_, first_, second_;  ///< a right-handed frame of unit vectors
  double radius_, half_;
};

/// The mean of the points and circles of a core, in its frame.
Vec2 middle_of(const Contactor2& shape);
Vec3 middle_of(const Contactor3& shape);

/// The rim of a contactor's circle, as a ring seen from `origin`.
Ring ring_of(const Placed3& shape, const Contactor3::Circle& circle, const Vec3& origin);

}  // namespace flyrock
