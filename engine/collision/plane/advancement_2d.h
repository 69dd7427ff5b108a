#pragma once
// Directed conservative advancement of two convex hulls.

#include <cstdint>
#include <optional>

#include "collision/motion.h"
#include "collision/touch_search.h"

namespace flyrock {

/// A moving convex hull of points, grown by a radius. A segment of the terrain is a hull of two points at
/// rest. normals[i] is the normal of the edge that starts at points[i].
struct MovingHull {
  const Vec2* points = nullptr;
  const Vec2* normals = nullptr;
  int count = 0;
  double radius = 0;
  double reach = 0;  ///< m, no point is farther from the origin; of a hull at rest it does not matter
  const Motion2& motion;
  FeatureId (*point_id)(int base, int i) = nullptr;
  FeatureId (*edge_id)(int base, int i) = nullptr;
  int base = 0;
  bool rests = false;  ///< as the ground does, in the frame of the world: `motion` is zero
  Rotation2 start = rests ? Rotation2() : motion.start();  ///< at t = 0
};

/// The first time in [window.a, window.b] at which the hulls touch and approach; see time_of_contact. In held
/// contacts, `feature` belongs to `a` and `against` to `b`.
std::optional<double> advance_to_contact(const MovingHull& a, const MovingHull& b, const TimeWindow& window,
                                         const TouchSearch& search);

}  // namespace flyrock
