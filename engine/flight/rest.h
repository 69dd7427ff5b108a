#pragma once
// When a body is at rest.

#include <limits>

#include "world/observe.h"

namespace flyrock {

/// A body is at rest if, for this long in contact, its speed and its spin times its radius stay below the
/// stop speed and do not grow by more than a tenth of the stop speed. The second condition is needed because
/// a box that begins to topple about its edge is slow, but not at rest.
inline constexpr double rest_time = 0.2;  // s

/// Follows one body, step by step, and records in its history since when it has been at rest.
class RestWatch {
 public:
  RestWatch(double stop_speed, BodyHistory& history) : stop_speed_(stop_speed), history_(&history) {}

  /// Reports that the body moves or has no contact, so it is not at rest.
  void moves() {
    since_ = -1;
    history_->stop_time = std::numeric_limits<double>::quiet_NaN();
  }
  /// Reports a contact step from `start` to `end` [s] that began at the speed `from` and ended at `speed`
  /// [m/s], the greater of |v| and |w| radius. The body is slow from the time at which the speed, taken as
  /// linear, falls below the stop speed. `before` is the travel of the body at the start of the step.
  void rests(double start, double end, double from, double speed, const Travel& before);
  /// The time until a body that stays slow is at rest [s]; infinite if it is not slow.
  double time_to_rest(double now) const {
    return since_ < 0 ? std::numeric_limits<double>::infinity() : since_ + rest_time - now;
  }
  /// The travel of the body until it came to rest.
  const Travel& travel() const { return travel_; }

 private:
  void begin(double time, double speed, const Travel& travel);

  double stop_speed_;
  BodyHistory* history_;
  double since_ = -1;  ///< s; -1: not at rest
  double speed_ = 0;   ///< m/s, at `since_`
  Travel travel_;      ///< until `since_`
};

}  // namespace flyrock
