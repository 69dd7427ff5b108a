#pragma once
// Contacts and time of impact with a body whose surface is a line of segments or a mesh of triangles.

#include <optional>
#include <vector>

#include "collision/contact.h"
#include "collision/geometry.h"
#include "collision/time_of_contact.h"

namespace flyrock {

// A surface (Contactor2::surface, Contactor3::surface) is a ground of its own, fixed or driven without spin.
// In its frame the other contactor meets it as it meets the terrain, so the rules for internal edges, rims
// and peaks are the same. One of the two contactors below is a surface; two surfaces do not touch.
//
// A feature of a surface has the id of the ground (geometry/facet.h, collision/contact.h), without the index
// of a contactor: it is the only one of its body.

/// Appends the contacts whose gap is at most `reach`. `turn` [rad] as in terrain_contacts, of the body that
/// is no surface.
template <int D>
void surface_contacts(const typename Geometry<D>::Placed& candidate, int candidate_index,
                      const typename Geometry<D>::Placed& antagonist, int antagonist_index, double reach,
                      double turn, std::vector<ContactPoint<D>>& out);

/// The gap of a feature that surface_contacts gave [m].
template <int D>
double surface_gap(const typename Geometry<D>::Placed& candidate, FeatureId feature,
                   const typename Geometry<D>::Placed& antagonist, FeatureId against);

/// The first touch in [0, t_max]; see time_of_contact.
template <int D>
std::optional<double> surface_touch(const typename Geometry<D>::Contactor& a, int a_index,
                                    const typename Geometry<D>::Motion& a_motion,
                                    const typename Geometry<D>::Contactor& b, int b_index,
                                    const typename Geometry<D>::Motion& b_motion, double t_max,
                                    const TouchSearch& search);

/// How deep a place lies in the solid of a surface; 0 outside. In 3D it is measured upwards [m].
double depth_in_surface(const Placed2& surface, const Vec2& place);
double depth_in_surface(const Placed3& surface, const Vec3& place);

}  // namespace flyrock
