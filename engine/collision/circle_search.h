#pragma once
// Time of impact of contactors with circles: conservative advancement by support alone.

#include "collision/advancement3.h"

namespace flyrock {

/// The first touch in the window of two contactors one of which has circles. b may be a facet, or the
/// place of an unbounded one. See time_of_contact.
///
/// A direction n may turn in any known way: with a, with b, or as the cross product of a line of each. The
/// height of a place of one core over a place of the other is h(t) >= h + h' t - M t^2/2, with h and h'
/// linear in both places. So the least of h + h' t over all pairs is one support of each core
/// (piece_heights.h), and the pair stays apart along n until
///   lowest of a (t) - highest of b (t) - M t^2/2 = 0,
/// whose left side is concave in t: a chord is below it, so the search for its root stays on the safe side.
/// Held contacts: along their normal, which all contacts of two convex contactors share, the pieces that
/// their features contain may sink by no more than a hundred-thousandth of the size. A rim that is held at
/// one place counts as touching elsewhere when this place has walked a quarter of a turn around it, too.
std::optional<double> advance_with_circles(const MovingContactor& a, const MovingContactor& b,
                                           const TimeWindow& window, const TouchSearch& search);

}  // namespace flyrock
