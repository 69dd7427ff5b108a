#pragma once
// The gap of a known pair of features, without a contact search.

#include "collision/contact.h"
#include "collision/placed.h"
#include "collision/terrain.h"
#include "collision/terrain3.h"

namespace flyrock {

/// The gap [m] between a feature of a contactor and a segment or corner of the terrain, with the feature ids
/// of terrain_contacts.
double feature_gap(const Placed2& contactor, FeatureId feature, const Terrain2& terrain, FeatureId against);

/// The gap [m] between features of two contactors, with the feature ids of body_contacts.
double feature_gap(const Placed2& candidate, FeatureId feature, const Placed2& antagonist, FeatureId against);

/// The same in 3D. An edge of a pill has no faces: its gap to a vertex or an edge is a distance.
double feature_gap(const Placed3& contactor, FeatureId feature, const Terrain3& terrain, FeatureId against);
double feature_gap(const Placed3& candidate, FeatureId feature, const Placed3& antagonist, FeatureId against);

}  // namespace flyrock
