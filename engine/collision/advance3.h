#pragma once
// The loop of conservative advancement in 3D, and the state of a moving contactor that it uses.

#include <algorithm>

#include "collision/advancement3.h"
#include "math/polynomial.h"

namespace flyrock {

/// A contactor at one time, with bounds on its motion until the end of the search.
struct MovingState {
  Turn turn;
  Vec3 x, v;
  double w_max;   ///< greatest spin
  double w_rate;  ///< greatest rate of change of the spin
  MovingState(const MovingContactor& c, double t, double end)
      : turn(c.motion.turn(t)),
        x(c.motion.position(t)),
        v(c.motion.velocity(t)),
        w_max(c.motion.greatest_spin(end)),
        w_rate(c.motion.greatest_spin_rate(end)) {}

  Vec3 arm(const Vec3& local) const { return turn.rotation * local; }
  Vec3 velocity_at(const Vec3& arm) const { return v + turn.spin.cross(arm); }
  /// Bound on the acceleration of a point at a lever [m], in addition to the acceleration of the centre of
  /// mass.
  double bend(double lever) const { return (w_max * w_max + w_rate) * lever; }
  bool turns() const { return w_max > 0 || w_rate > 0; }
};

/// Advances a search from one safe time to the next until the contactors touch or `end` is reached.
/// search.lasts(t) returns how long the contactors stay apart from t on. If the polynomial search.clearance()
/// shows that their bounding balls are apart, the search advances directly to the time at which the balls
/// meet.
template <class Search>
std::optional<double> advance(Search&& search, double end, std::uint64_t* iterations) {
  const auto clearance = search.clearance();
  double t = 0;
  constexpr int most_iterations = 500;
  for (int i = 0; i < most_iterations; ++i) {
    if (evaluate(clearance, t) > 0) {
      const auto meet = first_fall(clearance, t, end);
      if (!meet) return std::nullopt;
      t = std::max(t, *meet);
    }
    if (iterations) ++*iterations;
    const double step = search.lasts(t);
    if (step <= 0) return t;
    if (step >= end - t) return std::nullopt;
    const double next = t + step;
    if (next <= t) return t;  // below the resolution of time
    t = next;
  }
  return t;
}

}  // namespace flyrock
