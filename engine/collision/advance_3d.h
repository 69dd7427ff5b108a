#pragma once
// The loop of conservative advancement in 3D, and what its searches share.

#include <algorithm>
#include <limits>

#include "collision/round_path.h"
#include "collision/safe_time.h"
#include "collision/touch_search.h"
#include "math/polynomial.h"

namespace flyrock {

/// A contactor at one time, with bounds on its motion until the end of the search.
struct MovingState {
  Turn turn;
  Vec3 x, v;
  double w_max;   ///< greatest spin
  double w_rate;  ///< greatest rate of change of the spin
  MovingState(const Moving3& c, double t, double end)
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

/// A normal that turns, with bounds on |n'| and |n''| that hold for the time `horizon`.
struct TurningNormal {
  Vec3 normal, rate;
  double turn, turn_rate, horizon = std::numeric_limits<double>::infinity();

  static TurningNormal with(const MovingState& s, const Vec3& normal) {
    return {normal, s.turn.spin.cross(normal), s.w_max, s.w_max * s.w_max + s.w_rate};
  }
  /// The normal n = N/|N| with N = sign E x F of a line of each body, unit vectors whose angle has the sine
  /// s = |N|. With the sum W of the spins, |N'| <= W and |N''| <= W^2 + the spin rates. Therefore
  ///   |n'| <= W/s,  |n''| <= |N''|/s + 3 W^2/s^2.
  /// These bounds, taken with s/2, are valid for a time s/(2 W).
  static TurningNormal across(const Vec3& e, const MovingState& sa, const Vec3& f, const MovingState& sb,
                              double sign, double sine) {
    const double w = sa.w_max + sb.w_max, least = 0.5 * sine, turn = w / least;
    const Vec3 normal = Vec3(sign * e.cross(f)) / sine;
    const Vec3 rate = sign / sine * (sa.turn.spin.cross(e).cross(f) + e.cross(sb.turn.spin.cross(f)));
    TurningNormal n{normal, rate - normal * normal.dot(rate), turn,
                    (w * w + sa.w_rate + sb.w_rate) / least + 3 * turn * turn};
    if (w > 0) n.horizon = least / w;
    return n;
  }
};

/// The heights of a body's points along a direction that may turn, and their rates. Both are linear in the
/// point, which is in the body's frame.
class Heights {
 public:
  /// Measured from a point that is at `from` and moves with `velocity`; `turning` is the direction's rate.
  Heights(const Vec3& direction, const Vec3& turning, const MovingState& body, const Vec3& from,
          const Vec3& velocity)
      : height_(direction.dot(body.x - from)),
        rate_(turning.dot(body.x - from) + direction.dot(body.v - velocity)),
        rise_(body.turn.rotation.inverse(direction)),
        change_(body.turn.rotation.inverse(turning + direction.cross(body.turn.spin))) {}

  double of(const Vec3& p) const { return height_ + rise_.dot(p); }
  double rate(const Vec3& p) const { return rate_ + change_.dot(p); }
  /// The direction and its rate, as the body sees them.
  const Vec3& rise() const { return rise_; }
  const Vec3& change() const { return change_; }

 private:
  double height_, rate_;
  Vec3 rise_, change_;
};

/// As a polynomial of t that is not greater than the gap of the contactors near 0 [m]; for a facet, the gap
/// between the ball and its plane.
inline std::array<double, 5> ball_clearance(const Moving3& a, const Moving3& b, const TouchSearch& search) {
  if (const Facet* f = b.facet)
    return {f->distance(a.motion.x) - a.shape.bound + search.slack, f->normal.dot(a.motion.v),
            0.5 * f->normal.dot(a.motion.a), 0, 0};
  Path<3> relative = a.motion;
  relative.x -= b.motion.x;
  relative.v -= b.motion.v;
  relative.a -= b.motion.a;
  const double balls = a.shape.bound + b.shape.bound;
  return ball_gap(relative, balls, relative.x.norm() - balls + search.slack);
}

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
  constexpr double still = 1e-15;  // s, in which no body moves by the accuracy of the search
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
    if (step <= still || t + step <= t) return t;
    t += step;
  }
  return t;
}

}  // namespace flyrock
