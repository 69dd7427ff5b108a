#pragma once
// The step of conservative advancement.

#include <cmath>
#include <limits>

namespace flyrock {

/// What a search for the first touch takes as a gap of nothing, and as an overlap.
struct GapScale {
  double least;  ///< m, a gap that counts as closed
  double deep;   ///< m, an overlap beyond what opens again beside a held contact
  explicit GapScale(double size) : least(1e-12 * size), deep(1e-5 * size) {}
};

/// The time until gap + slope t - bend t^2 / 2 is zero, for gap > 0 or a pair that has just separated. A
/// direction along which the pair overlaps deeply separates nothing, however fast it opens; at the start a
/// held contact may, it has just opened.
inline double safe_time(double gap, double slope, double bend, const GapScale& scale, bool just_opened) {
  constexpr double forever = std::numeric_limits<double>::infinity();
  if (gap < -scale.deep && !just_opened) return 0;
  if (gap <= scale.least) {
    if (slope < 0) return 0;
    return bend > 0 ? 2 * slope / bend : forever;
  }
  if (bend <= 0) return slope >= 0 ? forever : gap / -slope;
  const double root = std::sqrt(slope * slope + 2 * bend * gap);
  return slope >= 0 ? (slope + root) / bend : 2 * gap / (root - slope);
}

/// A safe time whose bounds hold for `horizon`, where `left` is left until the end of the search: the horizon
/// ends the bounds' validity, not the search, unless it reaches that end.
inline double within(double horizon, double left, double time) {
  if (time < horizon) return time;
  return horizon >= left ? std::numeric_limits<double>::infinity() : horizon;
}

}  // namespace flyrock
