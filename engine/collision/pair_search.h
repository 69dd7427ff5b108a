#pragma once
// Time of impact of two moving contactors in 3D by conservative advancement. The second may be a facet of
// the ground.

#include "collision/workspace.h"

namespace flyrock {

/// The first time in the window at which the contactors touch and approach; see time_of_contact.
std::optional<double> advance_cores(const Moving3& a, const Moving3& b, CoreSearch by,
                                    const TimeWindow& window, const TouchSearch& search);

/// The first touch in the window of two contactors one of which has circles. b may be a facet, or the
/// place of an unbounded one. See time_of_contact.
///
/// A direction n may turn in any known way: with a, with b, or as the cross product of a line of each. The
/// height of a place of one core over a place of the other is h(t) >= h + h' t - M t^2/2, with h and h'
/// linear in both places. So the least of h + h' t over all pairs is one support of each core
/// (piece_heights.h), and the pair stays apart along n until
///   lowest of a (t) - highest of b (t) - M t^2/2 = 0,
/// whose left side is concave in t: a chord is below it, so the search for its root stays on the safe side.
std::optional<double> advance_with_circles(Workspace& work, const Moving3& a, const Moving3& b,
                                           const TimeWindow& window, const TouchSearch& search);

/// The first time in the window at which the contactor touches the facet and approaches it; see
/// time_of_contact. `held`: its contacts with the ground.
std::optional<double> core_touch_of_facet(Workspace& work, const Moving3& core, const Facet& facet,
                                          std::span<const HeldOnGround> held, CoreSearch by,
                                          const TimeWindow& window, const TouchSearch& search);
std::optional<double> smooth_touch_of_facet(Workspace& work, const Moving3& shape, const Facet& facet,
                                            const TimeWindow& window, const TouchSearch& search);
/// A point of the cloud that is below the plane of the facet, but beside the facet or deeper than a contact
/// can be, comes from another side of the solid and does not touch this facet.
std::optional<double> cloud_touch_of_facet(const Moving3& cloud, const Facet& facet, const TimeWindow& window,
                                           const TouchSearch& search);

}  // namespace flyrock
