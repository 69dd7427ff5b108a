#pragma once
// The gaps of the points of a moving hull to a line that does not turn.

#include <cmath>

#include "collision/safe_time.h"
#include "math/space.h"

namespace flyrock {

/// The gap of a point p and its derivatives, linear in p. In the frame of the hull, the point is at the
/// height rise . p along the normal of the line. By the spin w and its rate alpha of the hull, the height
/// changes as
///   height' = w side,   height'' = alpha side - w^2 height,   side = across . p,
/// where `across` is `rise` turned by -90 degrees.
struct SteadyGaps {
  GapBound centre;  ///< of the origin of the hull; its jerk and bend serve all points
  Vec2 rise;
  double w, alpha;  ///< rad/s, rad/s2

  Vec2 across() const { return {rise.y(), -rise.x()}; }
  GapBound of(const Vec2& p) const {
    const double height = rise.dot(p), side = across().dot(p);
    return {.gap = centre.gap + height,
            .slope = centre.slope + w * side,
            .curvature = centre.curvature + alpha * side - w * w * height,
            .jerk = centre.jerk,
            .bend = centre.bend};
  }
};

/// Whether the gap of a point stays open until a time. The bound with `bend` is linear in the point, and
/// mostly answers alone.
struct OpenUntil {
  const SteadyGaps& gaps;
  double time;
  double lowest, lowest_then;  ///< m, heights at which the bound is zero, now and at that time
  Vec2 rise_then;

  OpenUntil(const SteadyGaps& of, double until)
      : gaps(of),
        time(until),
        lowest(-gaps.centre.gap),
        lowest_then(lowest - time * (gaps.centre.slope - 0.5 * time * gaps.centre.bend)),
        rise_then(gaps.rise + time * gaps.w * gaps.across()) {}
  /// Of all points at this height or above it, at most `reach` from the origin of the hull.
  bool lasts_from(double height, double reach) const {
    return height > lowest && height - time * std::abs(gaps.w) * reach > lowest_then;
  }
  bool lasts(const Vec2& p) const {
    return gaps.rise.dot(p) > lowest && (rise_then.dot(p) > lowest_then || gaps.of(p).stays_open(time));
  }
};

}  // namespace flyrock
