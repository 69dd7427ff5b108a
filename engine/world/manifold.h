#pragma once
// What the contacts of one manifold share.

#include <algorithm>

#include "collision/contact.h"
#include "collision/geometry.h"

namespace flyrock {

/// Whether two normals lie within 15 degrees: contacts of one pair of bodies are then of one manifold.
template <int D>
bool same_direction(const Vec<D>& a, const Vec<D>& b) {
  constexpr double cos_15_degrees = 0.9659258262890683;
  return a.dot(b) > cos_15_degrees;
}

/// The part of the terrain that a contact's `against` names; a corner belongs to the segment on its right.
inline int part_of(const Terrain2& terrain, std::uint32_t against) {
  return terrain.part(std::min(terrain_index(against), terrain.segments() - 1));
}

}  // namespace flyrock
