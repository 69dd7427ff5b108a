#pragma once
// Where a rock starts.

#include "geometry/plane.h"
#include "geometry/profile.h"
#include "scenario/scenario.h"
#include "world/body.h"

namespace flyrock {

/// The place of a rock and the face it leaves.
template <int D>
struct Place {
  Vec<D> position = Vec<D>::Zero();  ///< of the centre of mass
  Vec3 outward = Vec3::UnitX();      ///< horizontal, out of the face
  double face_angle = 0;             ///< rad; 0 where it leaves no face
};

/// Places a rock of given orientation by a release. `face`: uniform along the bench face, as far as the rock
/// fits between toe and crest, touching it. `collar`: on the bench above, at the collar of the hole of `key`;
/// `bench_top`: uniform from the crest to the last row of holes. `inside`: uniform over a convex polygon.
/// Throws StartError where it does not fit or there is no such bench.
Place<2> place_rock(const Release& release, const Scenario& scenario, const DrawKey& key, RandomStream& rng,
                    const Body<2>& rock, const Profile& profile);

/// In 3D there are no faces: a rock is placed at a position, along a poly-line, inside a flat polygon or
/// above the ground.
Place<3> place_rock(const Release& release, const Scenario& scenario, const DrawKey& key, RandomStream& rng,
                    const Body<3>& rock, const Plane& plane);

/// The rotation that a scenario asks for. Throws StartError where a draw has left it without an axis.
Rotation3 rotation_of(const TurnPlan& turn, const Scenario& scenario, const DrawKey& key);

/// A rotation of which none is more likely than another.
Rotation3 random_rotation(RandomStream& rng);

/// The profile with its segments cut at the ends of zones, whose names become parts.
Profile with_zones(Profile profile, const std::vector<Zone>& zones);

}  // namespace flyrock
