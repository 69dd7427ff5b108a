#pragma once
// An edge or a vertex of the ground as a contactor, for shapes that are known by their support only.

#include "collision/placed.h"
#include "geometry/facet.h"

namespace flyrock {

/// A segment without a radius, with the vertices 0, 1 and the edge 0. Valid until the next call.
inline Placed3 edge_piece(const Facet& facet, int rim) {
  thread_local Contactor3 segment = Contactor3::pill(Vec3::Zero(), Vec3::Zero(), 0);
  segment.points[1] = facet.along(rim);
  segment.bound = facet.along(rim).norm();
  return {segment, {facet.corner[rim], {}}};
}

inline Placed3 vertex_piece(const Vec3& at) {
  static const Contactor3 point = Contactor3::sphere(0);
  return {point, {at, {}}};
}

}  // namespace flyrock
