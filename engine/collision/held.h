#pragma once
// Which contacts hold a contactor when a search for its time of impact begins, and what follows for the
// search.
//
// World::held_in_flight and World::held_in_step (world/held_contacts.cpp) fill the list: in flight with what
// the last step or impact left, in a step on the ground with what the solver keeps and what has hardly
// opened. A search asks it for a Hold, and makes Counts of it. In flight, what is held counts from zero at
// the start, then fully. In a step it is passed over, or may sink:
//
//   search on the ground          asks                   held for now     held exactly
//   2D; balls; one plane          HeldContacts::counts   -                passed over
//   pills, polyhedra in 3D        HeldPoints::hold       (1)              passed over
//
//   (1) a pill: passed over, and looked at again before the normal drifts by 1e-3 rad; an edge on an edge of
//       the ground: may sink by 5e-5 of the size
//
// Bodies that touch each other, and rims and clouds that touch the ground, are not searched in a step
// (world/close_pairs.cpp). docs/numerics.md, "The length of a step", says why. Lumped masses have a rule of
// their own: flight/face.h.

#include <span>

#include "geometry/facet.h"

namespace flyrock {

/// Whether a contact keeps two places apart along a direction. `no`: none does. `exactly`: one does while the
/// bodies move, because the direction is the normal of its face or of its two edges. `for_now`: one does now,
/// but its normal drifts from the direction. Searches that know no directions ask only whether the two have a
/// contact: `exactly`.
enum class Hold { no, for_now, exactly };

/// How a gap counts in a search. In a step what is held does not: `never`; a search that lets it sink a
/// little looks for that apart. In flight what is held has opened: at the start it counts `from_zero`, so
/// that rounding is no touch, and later `fully`, as what is not held always does.
enum class Counts { fully, from_zero, never };

/// A contact that exists when the search begins, by its feature ids.
struct HeldContact {
  FeatureId feature = 0;
  FeatureId against = 0;
  Vec3 normal = Vec3::Zero();  ///< in 3D, from the antagonist; zero where it is not known

  /// As the antagonist sees it.
  HeldContact mirrored() const { return {against, feature, -normal}; }
};

/// The contacts of two bodies, or of one with the ground, when a search begins.
struct HeldContacts {
  std::span<const HeldContact> list;
  bool are_solved = false;  ///< in a step

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
