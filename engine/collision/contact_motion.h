#pragma once
// How a contact moves while its bodies move: the rate of its normal, and the walk of its place.
//
// The part of a body that touches is a core grown by a radius: a point (vertex, ball, corner of the ground),
// a line (edge, axis of a pill or a cylinder) or a plane (face). A drum has the radius -R about its centre.
// With the places A and B of the cores, A - B = rho n, rho = r_a + r_b, the normal turns by
//   n' = w x n                                  with the plane of one side
//   n' = (1 - n n^T) (A' - B') / rho            between two points
//   n'.d = -n.(w x d)                           with a line along d, whose body turns by w
// and the contact at B + r_b n = A - r_a n walks over both bodies. Two lines that cross give both conditions
// of a line; two that are parallel, and a line with a point, give one, and n' across the line is that of two
// points. Exact for gap 0, to the first order in time.

#include <optional>

#include "collision/placed.h"
#include "geometry/ground2.h"

namespace flyrock {

class Ground3;

/// The part of a contactor or of the ground that touches. World frame.
template <int D>
struct TouchingPart {
  /// `place`: nothing is known but the place; its normal counts as that of the other side's plane, or fixed.
  enum class Kind { point, line, plane, place };
  Kind kind = Kind::place;
  bool rolls = false;                ///< a part of a rim or side: its place walks around the body
  double radius = 0;                 ///< m, of the surface about the core; negative if it touches from inside
  Vec<D> line = Vec<D>::Zero();      ///< unit, of a line
  Vec<D> velocity = Vec<D>::Zero();  ///< m/s, of the place of the core that is nearest to the contact
  typename Space<D>::Spin spin = Space<D>::no_spin();  ///< rad/s, of the body
};

/// The part of the ground that a feature names, at rest. Of contactors: touching_part in pairs.h.
TouchingPart<2> touching_part(const Ground2& ground, FeatureId feature);
TouchingPart<3> touching_part(const Ground3& ground, FeatureId feature);

template <int D>
struct ContactMotion {
  Vec<D> normal_rate = Vec<D>::Zero();  ///< 1/s
  /// m/s, the velocity of the contact relative to the place of the core of each side
  Vec<D> over_candidate = Vec<D>::Zero(), over_antagonist = Vec<D>::Zero();
};

/// The motion of the contact of two parts. `normal` points from the antagonist to the candidate.
ContactMotion<2> contact_motion(const TouchingPart<2>& candidate, const TouchingPart<2>& antagonist,
                                const Vec2& normal);
ContactMotion<3> contact_motion(const TouchingPart<3>& candidate, const TouchingPart<3>& antagonist,
                                const Vec3& normal);

}  // namespace flyrock
