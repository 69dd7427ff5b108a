#pragma once
// When a body is at rest.

#include <limits>

#include "record/observe.h"

namespace flyrock {

/// A body is at rest if, for rest_time in contact, its speed and its spin times its radius stay below the
/// stop speed, and then are not greater than at first or below a tenth of the stop speed. The second
/// condition is needed because a box that begins to topple about its edge is slow, but not at rest.
///
/// Slow is not yet still: a body that passes over its corner is slow there and then gains speed. The speed of
/// such a body changes all the time, as cosh(k t) with k of about sqrt(g / size), while a body that its
/// contacts hold or that rolls on level ground keeps its speed. Therefore the speed of a body must also be
/// steady for rest_time, which means that it changes by less than a thousandth of itself and of the stop
/// speed together. A body that stays slow for `settling_time` and has been faster meanwhile, as one that
/// rocks in a dip, is at rest without that. A point has no corners to pass over.
inline constexpr double rest_time = 0.2;    // s
inline constexpr double settling_time = 5;  // s

/// How fast a body in contact moves, in m/s.
struct Pace {
  double speed = 0;      ///< the greater of |v| and |w| radius
  double unpivoted = 0;  ///< the same without the spin about the normal of its only contact
  double pivot = 0;      ///< that spin times the radius, signed; 0 in 2D, and of a body with several contacts

  static Pace without_pivot(double speed) { return {.speed = speed, .unpivoted = speed}; }
};

/// Follows one body, step by step, and records in its history since when it has been at rest.
class RestWatch {
 public:
  enum class Kind { point, body };
  RestWatch(Kind kind, double stop_speed, BodyHistory& history)
      : kind_(kind), stop_speed_(stop_speed), history_(&history) {}

  /// Reports that the body moves or has no contact, so it is not at rest.
  void moves() {
    slow_since_ = -1;
    history_->stop_time = std::numeric_limits<double>::quiet_NaN();
  }
  /// Reports a contact step from `start` to `end` [s] that began at the pace `from` and ended at `pace`. The
  /// body is slow from the time at which the speed, taken as linear, falls below the stop speed. `before` is
  /// the travel of the body at the start of the step.
  void rests(double start, double end, const Pace& from, const Pace& pace, const Travel& before);
  /// The time until a body that stays slow and steady is at rest [s]; infinite if it is not slow.
  double time_to_rest(double now) const {
    return slow_since_ < 0 ? infinite : steady_since_ + rest_time - now;
  }
  /// The travel of the body until it came to rest.
  const Travel& travel() const { return travel_; }

 private:
  bool only_pivots(const Pace& pace) const;
  void begin(double time, double speed, const Travel& travel);

  Kind kind_;
  double stop_speed_;
  BodyHistory* history_;
  double slow_since_ = -1;                       ///< s; -1: it is not slow
  double pivot_ = 0;                             ///< m/s, when it became slow
  double greatest_ = 0;                          ///< m/s, speed since it has been slow
  double since_ = -1;                            ///< s; from when it is at rest if it does not gain speed
  double speed_ = 0;                             ///< m/s, at `since_`
  double steady_since_ = -1, steady_speed_ = 0;  ///< s and m/s: from then on the speed has been steady
  Travel travel_;                                ///< until `since_`
};

}  // namespace flyrock
