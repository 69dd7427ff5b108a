#pragma once
// The direction that separates two convex cores best, by support points alone.

#include "collision/placed.h"

namespace flyrock {

/// How two cores are apart, or how they penetrate least next to the first guess. World frame, metres.
struct Separation {
  Vec3 normal = Vec3::UnitZ();  ///< unit, from b to a
  double distance = 0;       ///< of the cores along the normal, without their radii; negative: they overlap
  Vec3 on_a = Vec3::Zero();  ///< the place of the core of a that is nearest to b
};

/// How far two cores are apart along a unit normal from b to a [m].
inline double distance_along(const Placed3& a, const Placed3& b, const Vec3& normal) {
  return normal.dot(a.support(-normal) - b.support(normal));
}

/// The algorithm of Gilbert, Johnson and Keerthi (1988): the place of A - B nearest to the origin, from a
/// simplex of at most four support points. Cores that touch or overlap have no such place apart from the
/// origin. Then the best of some directions is the first guess, b is moved back by L along the last normal n,
/// and n becomes the direction of the nearest place of A - B + L n: the normal of the features that touch is
/// a fixed point of this, and errors shrink by L / (L + radius of curvature) each time. L is a thousandth of
/// the smaller core, longer where they overlap more. The normal is good to about 1e-6: facing_pair
/// (facing_pair.h) makes it exact. The distance is that of the two supports along n, so that it errs by
/// the square of n's error where the cores are smooth.
Separation separation(const Placed3& a, const Placed3& b);

}  // namespace flyrock
