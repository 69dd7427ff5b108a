#pragma once
// A moving hull at one time.

#include <algorithm>
#include <cmath>

#include "collision/advancement.h"

namespace flyrock {

/// A hull at one time, with bounds on its motion until the end of the window of a search.
struct HullState {
  Rotation2 r;
  Vec2 x = Vec2::Zero(), v = Vec2::Zero();
  double w = 0;
  /// Bounds of the first three derivatives of a unit vector that turns with the hull, until the end
  double turn1 = 0, turn2 = 0, turn3 = 0;
  double radius = 0, swells = 0;  ///< m and m/s, now

  HullState(const MovingHull& hull, double t, double end) : r(hull.start) {
    if (hull.rests) return;
    const Motion2& motion = hull.motion;
    if (t != 0) r = r.turned(motion.angle_at(t) - motion.angle);
    measure(hull, t);
    const double alpha = std::abs(motion.alpha);
    turn1 = std::max(std::abs(w), std::abs(motion.spin(end)));
    turn2 = turn1 * turn1 + alpha;
    turn3 = turn1 * (turn1 * turn1 + 3 * alpha);
  }
  void advance(const MovingHull& hull, double from, double to) {
    r = r.turned(hull.motion.angle_at(to) - hull.motion.angle_at(from));
    measure(hull, to);
  }

 private:
  void measure(const MovingHull& hull, double t) {
    x = hull.motion.position(t);
    v = hull.motion.velocity(t);
    w = hull.motion.spin(t);
    radius = hull.radius + hull.motion.swell.at(t);
    swells = hull.motion.swell.rate_at(t);
  }
};

}  // namespace flyrock
