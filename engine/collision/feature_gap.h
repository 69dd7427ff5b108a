#pragma once
// The gap of a known pair of features, without a search.

#include "collision/contact.h"
#include "collision/placed.h"
#include "collision/terrain.h"

namespace flyrock {

/// The gap between a feature of a contactor and a segment or corner of the terrain, as terrain_contacts names them [m].
double feature_gap(const Placed2& contactor, std::uint32_t feature, const Terrain2& terrain, std::uint32_t against);

/// The gap between features of two contactors, as body_contacts names them [m].
double feature_gap(const Placed2& candidate, std::uint32_t feature, const Placed2& antagonist, std::uint32_t against);

/// The contactor's index in a feature id.
inline int contactor_of(std::uint32_t feature) { return static_cast<int>(feature >> 16); }

}  // namespace flyrock
