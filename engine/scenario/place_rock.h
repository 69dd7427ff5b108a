#pragma once
// Where a rock starts.

#include "geometry/profile.h"
#include "scenario/scenario.h"
#include "world/body.h"

namespace flyrock {

/// The place of a rock and the face it leaves.
struct Place {
  Vec2 position = Vec2::Zero();     ///< of the centre of mass
  Vec3 outward = Vec3::UnitX();     ///< horizontal, out of the face
  double face_angle = 0;            ///< rad; 0 where it leaves no face
};

/// Places a rock of given orientation by a release. `face`: uniform along the bench face, as far as the rock fits
/// between toe and crest, touching it. `inside`: uniform over a convex polygon. Throws PluginError where it does not
/// fit or there is no such bench.
Place place_rock(const Release& release, const Scenario& scenario, const DrawKey& key, RandomStream& rng,
                 const Body<2>& rock, const Profile& profile);

/// The profile with its segments cut at the ends of zones, whose names become parts.
Profile with_zones(Profile profile, const std::vector<Zone>& zones);

}  // namespace flyrock
