#pragma once
// Which places and directions belong to a facet, an edge or a peak of the ground.

#include <span>

#include "geometry/facet.h"

namespace flyrock {

/// Relative tolerance of the tests of regions: beyond the ends of an edge, and beside the strip of a facet.
inline constexpr double region_slack = 1e-9;

/// By how much the strip over a facet is wider than the facet at its rim i [m]. At a concave rim it is `sunk`
/// [m], because a place may have sunk into the neighbour. At a flat rim the strip overlaps that of the
/// neighbour, because the two normals may differ by what still counts as flat. At a convex rim it is `slack`
/// times the length of the rim.
inline double strip_margin(const Facet& f, int i, const Vec3& p, double sunk, double slack = region_slack) {
  constexpr double overlap = 1e-6;
  if (f.rim[i] == Rim::concave) return sunk;
  return f.rim[i] == Rim::flat ? overlap * (p - f.corner[i]).norm() : slack * f.along(i).norm();
}

/// Whether the strip over a facet, along its normal, contains p. At an open rim the strip has no side.
inline bool strip_contains(const Facet& f, const Vec3& p, double sunk, double slack) {
  for (int i = 0; i < 3; ++i) {
    if (f.rim[i] == Rim::open) continue;
    const Vec3 along = f.along(i);
    if (f.normal.cross(along).dot(p - f.corner[i]) < -strip_margin(f, i, p, sunk, slack) * along.norm())
      return false;
  }
  return true;
}

/// Whether p, below the plane of the facet, is nearer to the facet beyond a convex rim, or in the air behind
/// it. The contact is then the neighbour's, or none. On the rim itself, up to rounding, p has both.
inline bool nearer_beyond(const Facet& f, const Vec3& p, double distance) {
  for (int i = 0; i < 3; ++i)
    if (f.rim[i] == Rim::convex &&
        f.beyond[i].dot(p - f.corner[i]) > distance + region_slack * f.along(i).norm())
      return true;
  return false;
}

/// Whether a direction lies in the cone of normals of a convex rim, between the normals of its two facets:
/// both facets fall away from it, up to `slack` [rad]. The direction need not be exactly across the rim.
inline bool rim_cone_contains(const Facet& f, int i, const Vec3& direction, double slack) {
  const Vec3 along = f.along(i);
  const double most = slack * along.norm();
  return direction.dot(f.normal.cross(along)) <= most && direction.dot(along.cross(f.beyond[i])) <= most;
}

/// Whether all edges that leave a peak fall away from a direction, up to `slack` [rad].
inline bool peak_cone_contains(std::span<const Vec3> edges, const Vec3& direction, double slack) {
  for (const Vec3& edge : edges)
    if (direction.dot(edge) > slack * edge.norm()) return false;
  return true;
}

}  // namespace flyrock
