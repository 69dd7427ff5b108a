#pragma once
// The gap of a known pair of features, without a contact search.

#include "collision/contact.h"
#include "collision/placed.h"
#include "geometry/ground.h"
#include "geometry/ground2.h"

namespace flyrock {

/// The gap [m] between a feature of a contactor and a segment or corner of the terrain, with the feature ids
/// of terrain_contacts.
double feature_gap(const Placed2& contactor, FeatureId feature, const Ground2& ground, FeatureId against);

/// The gap [m] between features of two contactors, with the feature ids of body_contacts.
double feature_gap(const Placed2& candidate, FeatureId feature, const Placed2& antagonist, FeatureId against);

/// The same in 3D. An edge of a pill has no faces: its gap to a vertex or an edge is a distance.
double feature_gap(const Placed3& contactor, FeatureId feature, const Ground3& ground, FeatureId against);
double feature_gap(const Placed3& candidate, FeatureId feature, const Placed3& antagonist, FeatureId against);

}  // namespace flyrock
