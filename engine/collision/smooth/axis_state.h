#pragma once
// The motion of a contactor of revolution without its turn about its own axis.

#include <algorithm>
#include <optional>

#include "collision/advance_3d.h"

namespace flyrock {

/// The state of a contactor in a frame that follows its axis of revolution and does not turn about it: such a
/// turn moves no place of the contactor, so it counts in no bound. For other contactors the state itself.
class AxisState {
 public:
  explicit AxisState(const Moving3& c) : axis_(c.shape.axis_of_revolution()) {
    if (const auto* free = std::get_if<FreeRotation>(&c.motion.rotation); free && axis_)
      precession_ = free->precession_of(*axis_);
  }

  /// With the axis a, the spin of the frame is w - (w.a) a. Its length changes no faster than w does. In a
  /// precession p it is constant, and its direction turns with p. Otherwise
  ///   |(w - (w.a) a)'| <= |w'| + |w| |w - (w.a) a|.
  MovingState of(const MovingState& body, double t, double end) const {
    if (!axis_) return body;
    MovingState state = body;
    const Vec3 axis = body.arm(*axis_);
    state.turn.spin = body.turn.spin - axis.dot(body.turn.spin) * axis;
    const double now = state.turn.spin.norm() * (1 + 1e-9);
    state.w_max = std::min(body.w_max, precession_ ? now : now + (end - t) * body.w_rate);
    state.w_rate = precession_ ? *precession_ * state.w_max : body.w_rate + body.w_max * state.w_max;
    return state;
  }

 private:
  std::optional<Vec3> axis_;
  std::optional<double> precession_;  ///< rad/s
};

}  // namespace flyrock
