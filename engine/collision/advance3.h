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

/// A test whether points of a moving body surely stay clear of a plane that does not turn, for some time. Gap
/// and slope are linear in the point, and its lever is at most the bound of the contactor. Most points pass,
/// and need no root.
class PlaneClearance {
 public:
  /// The plane is normal . x = height and moves by `velocity`; `acceleration` is that of the body against it.
  PlaneClearance(const Vec3& normal, double height, const Vec3& velocity, const Vec3& acceleration,
                 const MovingState& body, double left, double bound, const TouchSearch& search)
      : gap_(normal.dot(body.x) - height + search.slack - 1e-9 * search.size),
        later_(left * normal.dot(body.v - velocity) -
               0.5 * left * left * (std::max(0.0, -normal.dot(acceleration)) + body.bend(bound))),
        now_(body.turn.rotation.inverse(normal)),
        change_(left * body.turn.rotation.inverse(normal.cross(body.turn.spin))) {}

  /// For a point in the body's frame.
  bool of(const Vec3& p) const {
    const double here = gap_ + now_.dot(p);
    return here > 0 && here + later_ + change_.dot(p) > 0;
  }

 private:
  double gap_, later_;
  Vec3 now_, change_;
};

/// Advances a search from one safe time to the next until the contactors touch or the window ends.
/// search.lasts(t) returns how long the contactors stay apart from t on. If the polynomial search.clearance()
/// shows that their bounding balls are apart, the search advances directly to the time at which the balls
/// meet.
template <class Search>
std::optional<double> advance(Search&& search, const TimeWindow& window, std::uint64_t* iterations) {
  const auto clearance = search.clearance();
  const double end = window.b;
  double t = window.a;
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
