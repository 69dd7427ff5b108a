#pragma once
// The time step of conservative advancement.

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/held.h"

namespace flyrock {

inline constexpr double forever = std::numeric_limits<double>::infinity();  ///< s

/// The gaps at which a search for the time of impact treats a pair as closed or as deeply penetrating.
struct GapScale {
  double least;  ///< m, a gap that counts as closed
  double deep;   ///< m, a penetration too deep to recover from while another contact holds
  explicit GapScale(double size) : least(1e-12 * size), deep(1e-5 * size) {}
};

/// The time until gap + slope t - bend t^2 / 2 is zero, for gap > 0 or a pair that has just separated. If the
/// pair penetrates deeply along a direction, that direction does not separate it, however fast the gap opens.
/// The exception is what counts from zero.
inline double safe_time(double gap, double slope, double bend, const GapScale& scale, Counts counts) {
  if (gap < -scale.deep && counts != Counts::from_zero) return 0;
  if (gap <= scale.least) {
    if (slope < 0) return 0;
    return bend > 0 ? 2 * slope / bend : forever;
  }
  if (bend <= 0) return slope >= 0 ? forever : gap / -slope;
  const double root = std::sqrt(slope * slope + 2 * bend * gap);
  return slope >= 0 ? (slope + root) / bend : 2 * gap / (root - slope);
}

/// Whether gap + rate t - bend t^2 / 2 is positive until `time`.
inline bool stays_open(double gap, double rate, double bend, double time) {
  return gap > 0 && gap + time * (rate - 0.5 * time * bend) > 0;
}

/// A lower bound of a gap over time: gap + slope t + curvature t^2/2 - jerk t^3/6, where jerk >= |gap'''|,
/// and gap + slope t - bend t^2/2, where bend >= -gap''.
struct GapBound {
  double gap, slope, curvature, jerk, bend;

  double bend_until(double time) const { return std::max(0.0, std::min(bend, jerk * time - curvature)); }
  bool stays_open(double time) const { return flyrock::stays_open(gap, slope, bend_until(time), time); }
  /// Whether the gap is closed at a time, and still closing, however much the curvature changes.
  bool closes_by(double time, double least) const {
    return gap + time * (slope + 0.5 * time * (curvature + time * jerk / 3)) <= least &&
           slope + time * (curvature + 0.5 * time * jerk) < 0;
  }
  /// The time until the bound is zero, as safe_time, but at most `longest`: first with its bend until
  /// `longest`, then with the one over twice the time that this gives, in which the curvature changes little.
  double safe_time(double longest, const GapScale& scale, Counts counts) const {
    const auto safe = [&](double horizon) {
      return std::min(horizon, flyrock::safe_time(gap, slope, bend_until(horizon), scale, counts));
    };
    const double first = safe(longest);
    return first > 0 && 2 * first <= longest ? std::max(first, safe(2 * first)) : first;
  }
};

/// Limits a safe time to the `horizon` for which its bounds hold. `left` is the time until the end of the
/// search. The horizon ends the search only if it reaches that end.
inline double within(double horizon, double left, double time) {
  if (time < horizon) return time;
  return horizon >= left ? forever : horizon;
}

}  // namespace flyrock
