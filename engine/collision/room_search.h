#pragma once
// Time of impact with the wall of a room.

#include <optional>

#include "collision/advance3.h"
#include "collision/time_of_contact.h"

namespace flyrock {

/// A moving contactor in 2D. Shape and motion must outlive it.
struct MovingContactor2 {
  const Contactor2& shape;
  const Motion2& motion;
  int index = 0;  ///< of the contactor in its body, for feature ids
};

/// The first touch in the window of a room (room.h) and another contactor, one of which is a room; see
/// time_of_contact. Of two rooms there is none.
///
/// In a frame that follows the room but does not turn about its axis, a place q of the other contactor is at
/// q0 + q' t + e with |e| <= M t^2/2. The gap is a concave function of the place and changes no faster than
/// the place moves, so
///   gap(q0 + q' t) - M t^2/2
/// is a concave lower bound of the gap (safe_root.h). Of a rim, it is the least over its places, all of which
/// are linear in t. A rim that is held at one place is searched for another touch 60 degrees away from it.
/// Features that are deep in the wall have come from outside, which the wall does not touch: they count once
/// they are inside.
std::optional<double> advance_in_room(const MovingContactor2& a, const MovingContactor2& b,
                                      const TimeWindow& window, const TouchSearch& search);
std::optional<double> advance_in_room(const MovingContactor& a, const MovingContactor& b,
                                      const TimeWindow& window, const TouchSearch& search);

}  // namespace flyrock
