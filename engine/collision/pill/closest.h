#pragma once
// The nearest places of the cores of two contactors. The core of a sphere is its centre, that of a pill its
// axis.

#include "collision/contact.h"
#include "collision/placed.h"

namespace flyrock {

/// The parameters in [0, 1] of the nearest places p + s dp and q + t dq of two segments. A point is a segment
/// of length 0. Of two parallel segments: a place at the end of one of them.
struct NearestOfSegments {
  double s = 0, t = 0;
};
NearestOfSegments nearest_of_segments(const Vec3& p, const Vec3& dp, const Vec3& q, const Vec3& dq);

/// The nearest places of the cores of a and b. If the cores overlap, the direction in which they penetrate
/// least. World frame, metres.
struct Closest {
  double distance = 0;          ///< of the cores, without their radii; negative if they overlap
  Vec3 normal = Vec3::UnitZ();  ///< unit, from b to a
  Vec3 on_a = Vec3::Zero();     ///< the place on the core of a
  ShapeFeature of_a, of_b;
};

/// At least one of the two has no faces.
Closest closest(const Placed3& a, const Placed3& b);

}  // namespace flyrock
