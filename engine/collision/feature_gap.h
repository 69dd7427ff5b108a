#pragma once
// The gap of a known pair of features, without a search.

#include "collision/contact.h"
#include "collision/placed.h"
#include "collision/terrain.h"
#include "collision/terrain3.h"

namespace flyrock {

/// The gap between a feature of a contactor and a segment or corner of the terrain, as terrain_contacts names
/// them [m].
double feature_gap(const Placed2& contactor, std::uint32_t feature, const Terrain2& terrain,
                   std::uint32_t against);

/// The gap between features of two contactors, as body_contacts names them [m].
double feature_gap(const Placed2& candidate, std::uint32_t feature, const Placed2& antagonist,
                   std::uint32_t against);

double feature_gap(const Placed3& contactor, std::uint32_t feature, const Terrain3& terrain,
                   std::uint32_t against);
double feature_gap(const Placed3& candidate, std::uint32_t feature, const Placed3& antagonist,
                   std::uint32_t against);

}  // namespace flyrock
