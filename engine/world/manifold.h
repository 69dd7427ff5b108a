#pragma once
// Which contacts form one manifold, and which part of the terrain a contact lies on.

#include <algorithm>

#include "collision/contact.h"
#include "collision/geometry.h"

namespace flyrock {

/// Whether the angle between two normals is less than 15 degrees. Contacts of one pair of bodies whose
/// normals satisfy this belong to one manifold.
template <int D>
bool same_direction(const Vec<D>& a, const Vec<D>& b) {
  constexpr double cos_15_degrees = 0.9659258262890683;
  return a.dot(b) > cos_15_degrees;
}

/// The part of the terrain that a contact's `against` names. A corner belongs to the segment on its right.
inline int part_of(const Terrain2& terrain, FeatureId against) {
  return terrain.part(std::min(terrain_index(against), terrain.segments() - 1));
}
inline int part_of(const Terrain3& terrain, FeatureId against) { return terrain.part(against); }

/// The names of the parts of the terrain.
inline const std::vector<std::string>& parts_of(const Terrain2& terrain) { return terrain.profile().parts; }
inline const std::vector<std::string>& parts_of(const Terrain3& terrain) { return terrain.parts(); }

/// Whether two features of the terrain, or of a surface, are neighbours: a segment and a corner at its end,
/// or two segments that share a corner.
inline bool next_to(const Ground2&, FeatureId a, FeatureId b) {
  // Counted in half segments, because corner i lies half-way between the segments i - 1 and i.
  const auto place = [](FeatureId id) { return 2 * terrain_index(id) + (is_corner(id) ? -1 : 0); };
  return std::abs(place(a) - place(b)) <= 2;
}
/// In 3D a vertex on ground of the same direction carries its contact on, however many small facets it has
/// passed in one step.
inline bool next_to(const Ground3&, FeatureId, FeatureId) { return true; }

}  // namespace flyrock
