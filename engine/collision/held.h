#pragma once
// Which contacts hold two contactors apart when a search for their time of impact begins, and what follows
// for the search. This is the only place that answers it:
//
//   who fills the list   World::held_in_flight and World::held_in_step (world/held_contacts.cpp); on the
//                        ground of a 3D run, held_on (held_3d.h) adds where its features are
//   who asks             every search: two features by HeldContacts::hold; two points of cores along a
//                        direction by HeldPoints::hold, pieces of contactors with circles by HeldPair::hold
//                        (both in held_3d.h)
//   what it answers      Hold: no, for now, exactly
//   what follows         Counts: see there; docs/numerics.md, "The length of a step", says why
//
// Massless points have a rule of their own: flight/face.h.

#include <span>

#include "geometry/facet.h"

namespace flyrock {

/// How a contact holds two points, or pieces of cores, apart along a direction. `exactly`: the direction is
/// the normal of the contact while the bodies move, because it belongs to the same face or the same two
/// edges. `for_now`: it is now, but it drifts from it.
enum class Hold { no, for_now, exactly };

/// How a gap counts in a search. In a step the solver keeps what is held apart, and the search passes over
/// it: `never`. In flight what is held has just opened: at the start it counts `from_zero`, so that rounding
/// is no touch, and later `fully`, as what is not held always does.
enum class Counts { fully, from_zero, never };

/// A contact that exists when the search begins, by its feature ids.
struct HeldContact {
  FeatureId feature = 0;
  FeatureId against = 0;
  /// In a step: the last impact opened it, and the step holds no contact of the pair. Where there are rims,
  /// the pair then counts as in flight.
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
