#pragma once
// Which contacts hold two contactors apart when a search for their time of impact begins, and what follows
// for the search.
//
// World::held_in_flight and World::held_in_step (world/held_contacts.cpp) fill the list: in flight with what
// the last step or impact left, in a step with what the solver keeps and what has hardly opened. A search
// asks it for a Hold, and makes Counts of it. In flight, what is held counts from zero at the start, then
// fully. In a step it is passed over, or may sink:
//
//   search                                  asks                   held for now     held exactly
//   2D; centred balls; clouds; one plane    HeldContacts::counts   -                passed over
//   other balls, pills, polyhedra in 3D     HeldPoints::hold       (1)              passed over
//   with circles                            HeldPair::hold         (2), (3)         (2)
//   hollow, half space in 3D                HeldPair::counts       -                passed over, (4)
//
//   (1) a pill: passed over, and (3); an edge on an edge of the ground, and a vertex beyond a side of a face,
//       whose edge crosses this side in a contact: may sink by 5e-5 of the size
//   (2) may sink by 1e-5 of the size deeper than when the search first met it; springs as they like
//   (3) looked at again before the normal drifts by 1e-3 rad
//   (4) a rim that is held at one place is searched 60 degrees away from it
//
// An outline is searched in its frame, as the ground is. docs/numerics.md, "The length of a step", says why.
// Lumped masses have a rule of their own: flight/face.h.

#include <span>

#include "geometry/facet.h"

namespace flyrock {

/// Whether a contact keeps two places apart along a direction. `no`: none does. `exactly`: one does while the
/// bodies move, because the direction is the normal of its face or of its two edges. `for_now`: one does now,
/// but its normal drifts from the direction. Searches that know no directions, and those of balls, ask only
/// whether the two have a contact: `exactly`.
enum class Hold { no, for_now, exactly };

/// How a gap counts in a search. In a step what is held does not: `never`; a search that lets it sink a
/// little looks for that apart. In flight what is held has opened: at the start it counts `from_zero`, so
/// that rounding is no touch, and later `fully`, as what is not held always does.
enum class Counts { fully, from_zero, never };

/// A contact that exists when the search begins, by its feature ids.
struct HeldContact {
  FeatureId feature = 0;
  FeatureId against = 0;
  /// In a step: the last impact or step opened it, and this step holds no contact of the two bodies. HeldPair
  /// then counts as in flight.
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
  double sunk = 0;          ///< m, the deepest overlap of their springs at the start or end of the step

  /// Whether the list has a contact of these two features.
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
