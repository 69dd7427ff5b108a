#pragma once
// Which contacts hold two contactors apart when a search for their time of impact begins, and what follows
// for the search.
//
// World::held_in_flight and World::held_in_step (world/held_contacts.cpp) fill the list. In flight, what it
// has counts from zero at the start. In a step the solver holds it:
//
//   search                  asks                                   in a step, what is held
//   plane/, balls, clouds   HeldContacts::counts, two features     never counts
//   pills, polyhedra        HeldPoints::hold, two points along a   never counts; where the normal drifts, for
//                             direction (hull/core_search)           1e-3 rad, or may sink by 5e-5
//   circles                 HeldPair::hold, two sets of pieces     may sink by 1e-5
//   hollow walls            2D as plane/, 3D HeldPair::counts      never counts; a rim does 60 degrees away
//
// Sinking is in shares of the size; docs/numerics.md, "The length of a step", says why. Lumped masses have a
// rule of their own: flight/face.h.

#include <span>

#include "geometry/facet.h"

namespace flyrock {

/// How a contact holds two points, or pieces of cores, apart along a direction. `exactly`: the direction is
/// the normal of the contact while the bodies move, because it belongs to the same face or the same two
/// edges. `for_now`: it is now, but it drifts from it.
enum class Hold { no, for_now, exactly };

/// How a gap counts in a search. In a step the solver keeps what is held apart, and the search passes over
/// it: `never`. In flight what is held has opened: at the start it counts `from_zero`, so that rounding is no
/// touch, and later `fully`, as what is not held always does.
enum class Counts { fully, from_zero, never };

/// A contact that exists when the search begins, by its feature ids.
struct HeldContact {
  FeatureId feature = 0;
  FeatureId against = 0;
  /// In a step: the last impact or step opened it, and this step holds no contact of the pair. HeldPair then
  /// counts as in flight.
  bool opened = false;
  bool yields = false;         ///< a spring: its bodies sink into each other
  Vec3 normal = Vec3::Zero();  ///< in 3D, from the antagonist; zero where it is not known

  /// As the antagonist sees it.
  HeldContact mirrored() const { return {against, feature, opened, yields, -normal}; }
};

/// The contacts of two bodies, or of one with the ground, when a search begins.
struct HeldContacts {
  std::span<const HeldContact> list;
  bool are_solved = false;  ///< in a step

  /// Two features that have a contact keep it while they exist.
  Hold hold(FeatureId feature, FeatureId against) const {
    for (const HeldContact& h : list)
      if (h.feature == feature && h.against == against) return Hold::exactly;
    return Hold::no;
  }
  /// How the gap of what is held like this counts at time t of the search.
  Counts counts(Hold hold, double t) const {
    if (hold == Hold::no) return Counts::fully;
    return are_solved ? Counts::never : t == 0 ? Counts::from_zero : Counts::fully;
  }
  /// The same for two features, which are looked up only if it matters.
  Counts counts(FeatureId feature, FeatureId against, double t) const {
    return are_solved || t == 0 ? counts(hold(feature, against), t) : Counts::fully;
  }
};

}  // namespace flyrock
