#pragma once
// When a body is at rest.

#include "world/observe.h"

namespace flyrock {

/// A body is at rest when its speed, and its spin times its radius, stay under the stop speed for this long
/// in contact and do not grow over that time beyond a tenth of the stop speed: a box that begins to topple
/// about its edge is slow, but not at rest.
inline constexpr double rest_time = 0.2;  // s

/// Watches one body, step by step, and notes in its history since when it has been at rest.
class RestWatch {
 public:
  RestWatch(double stop_speed, BodyHistory& history) : stop_speed_(stop_speed), history_(&history) {}

  /// The body moves, or has no contact: it is not, or no longer, at rest.
  void moves();
  /// A step in contact from `start` to `end` [s] has ended at `speed` [m/s], the greater of |v| and |w|
  /// radius; `before`: what the body had travelled at the start.
  void rests(double start, double end, double speed, const Travel& before);
  /// What it had travelled when it came to rest.
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
