#pragma once
// Places rocks where they start.

#include "geometry/plane.h"
#include "geometry/profile.h"
#include "scenario/scenario.h"
#include "world/body.h"

namespace flyrock {

/// The place of a rock and the face that it leaves.
template <int D>
struct Place {
  Vec<D> position = Vec<D>::Zero();  ///< of the centre of mass
  Vec3 outward = Vec3::UnitX();      ///< horizontal, pointing out of the face
  double face_angle = 0;             ///< rad; 0 if it leaves no face
};

/// Places a rock of given orientation. The kinds of release: `face` is uniform along the bench face, as far
/// as the rock fits between toe and crest, and touches it. `collar` is on the bench above, at the collar of
/// the hole of `key`; a measured hole has a place of its own, and in 3D its rocks leave a face in front of
/// it. `bench_top` is uniform from the crest to the last row of holes. `inside` is uniform over a polygon. In
/// 3D, faces and bench tops are in addition uniform along the crest as far as the rock fits, and holes stand
/// side by side along it; a face that is a zone is uniform in plan. Places in plan are at a height above the
/// ground, or on it. Throws StartError if the rock does not fit or there is no such bench.
Place<2> place_rock(const Release& release, const Scenario& scenario, const DrawKey& key, RandomStream& rng,
                    const Body<2>& rock, const Terrain2& terrain);
Place<3> place_rock(const Release& release, const Scenario& scenario, const DrawKey& key, RandomStream& rng,
                    const Body<3>& rock, const Terrain3& terrain);

/// How far behind the crest a rock may start [m]: the row of its hole for `collar`, the last row for
/// `bench_top`. Throws StartError if the blast does not say.
double depth_of_holes(const Release& release, const Scenario& scenario, const DrawKey& key,
                      const Blast& blast);

/// The measured hole of a key; null if the blast has none.
const Hole* measured_hole(const Scenario& scenario, const DrawKey& key);

/// Raises a rock that rests on the ground at a hole, of that height, by what the collar lies above it. A
/// collar that a survey puts a little below the ground is on it; 1 m below is a StartError.
void raise_to_collar(const Hole& hole, double ground, double origin, double& height);

/// The rotation that a scenario gives. Throws StartError if a draw leaves it without an axis.
Rotation3 rotation_of(const TurnPlan& turn, const Scenario& scenario, const DrawKey& key);

/// A uniformly distributed random rotation.
Rotation3 random_rotation(RandomStream& rng);

}  // namespace flyrock
