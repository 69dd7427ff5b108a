#include "collision/advancement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/safe_time.h"

namespace flyrock {

namespace {

constexpr double forever = std::numeric_limits<double>::infinity();
constexpr int most_iterations = 500;

/// A hull at one time, with bounds on its motion until the end of the window.
struct State {
  Rotation2 r;
  Vec2 x, v;
  double w;
  double w_max;           ///< greatest spin until the end
  double radius, swells;  ///< m and m/s, now
  explicit State(const MovingHull& hull, double t, double end)
      : r(hull.rests ? Rotation2() : Rotation2::from_angle(hull.motion.angle_at(t))),
        x(hull.motion.position(t)),
        v(hull.motion.velocity(t)),
        w(hull.motion.spin(t)),
        w_max(std::max(std::abs(w), std::abs(hull.motion.spin(end)))),
        radius(hull.radius + hull.motion.swell.at(t)),
        swells(hull.motion.swell.rate_at(t)) {}
};

class Search {
 public:
  Search(const MovingHull& a, const MovingHull& b, double end, const TouchSearch& search)
      : a_(a), b_(b), end_(end), search_(search), scale_(search.size) {}

  std::optional<double> run(double t) {
    Direction direction;
    bool chosen = false;
    State sa(a_, t, end_), sb(b_, t, end_);
    for (int i = 0; i < most_iterations; ++i) {
      if (search_.iterations) ++*search_.iterations;
      double step = chosen ? lasts(direction, sa, sb, t) : 0;
      if (step <= 0) {
        step = longest(sa, sb, t, direction);
        chosen = true;
      }
      if (step <= 0) return t;
      if (step >= end_ - t) return std::nullopt;
      const double next = t + step;
      if (next <= t) return t;  // below the resolution of time
      t = next;
      sa = State(a_, t, end_);
      if (!b_.rests) sb = State(b_, t, end_);
    }
    return t;
  }

 private:
  /// A separating direction: the normal of an edge of a (kind 0) or b (kind 1), or the line between the
  /// nearest points of two hulls, of which one is grown by a radius (kind 2).
  struct Direction {
    int kind = 0;
    int edge = 0;
    Vec2 fixed = Vec2::Zero();  ///< kind 2: from b to a, constant in the world frame
  };

  /// A test whether points of a hull surely stay clear of a line that does not turn, for some time. Gap and
  /// slope are linear in the point p, and |x| + |y| bounds its lever. Most points pass, and need no root.
  class Clearance {
   public:
    Clearance(const Vec2& normal, double gap, double slope, double fall, const MovingHull& hull,
              const State& state)
        : gap_(gap),
          slope_(slope),
          fall_(fall),
          bend_(state.w_max * state.w_max + std::abs(hull.motion.alpha)),
          rise_(state.r.inverse(normal)),
          change_(state.w * rise_.y(), -state.w * rise_.x()) {}

    bool of(const Vec2& p, double time) const {
      const double bend = fall_ + bend_ * (std::abs(p.x()) + std::abs(p.y()));
      return stays_open(gap_ + rise_.dot(p), slope_ + change_.dot(p), bend, time);
    }

   private:
    double gap_, slope_, fall_, bend_;
    Vec2 rise_, change_;
  };

  /// How long the edge `edge` of `reference` separates it from the points of `other` [s].
  double edge_lasts(const MovingHull& reference, const State& sr, const MovingHull& other, const State& so,
                    int edge, bool reference_is_a, double t) const {
    const Vec2 normal = sr.r * reference.normals[edge];
    const Vec2 turn = perpendicular(normal);
    const double offset = reference.normals[edge].dot(reference.points[edge]) + sr.radius + so.radius;
    const Vec2 relative_acceleration = other.motion.a - reference.motion.a;
    const double left = end_ - t, closing = (so.v - sr.v).norm() + relative_acceleration.norm() * left;
    const bool turns = sr.w_max != 0 || reference.motion.alpha != 0;
    const double swells = sr.swells + so.swells;  // the growth of the radii closes the gap
    const double growth = reference.motion.swell.growth + other.motion.swell.growth;
    const double fall = std::max(0.0, growth - normal.dot(relative_acceleration));
    const Clearance clear(normal, normal.dot(so.x - sr.x) - offset + search_.slack - 1e-9 * search_.size,
                          normal.dot(so.v - sr.v) - swells, fall, other, so);
    double least = forever;
    for (int j = 0; j < other.count && least > 0; ++j) {
      if (!turns && clear.of(other.points[j], std::min(least, left))) continue;
      const FeatureId edge_id = reference.edge_id(reference.base, edge);
      const FeatureId point_id = other.point_id(other.base, j);
      const bool is_held =
          reference_is_a ? search_.holds(edge_id, point_id) : search_.holds(point_id, edge_id);
      if (is_held && search_.held_are_solved) continue;
      const Vec2 arm = so.r * other.points[j];
      const Vec2 w = so.x + arm - sr.x;
      const Vec2 velocity = so.v + cross(so.w, arm) - sr.v;
      const double gap = normal.dot(w) - offset + search_.slack;
      const double slope = sr.w * turn.dot(w) + normal.dot(velocity) - swells;
      // M >= -gap'' until the end of the search. The horizon limits the growth of the lever |w| of a turning
      // normal.
      const double reach = arm.norm(), speed = closing + so.w_max * reach;
      double horizon = left;
      double bend = so.w_max * so.w_max * reach + std::abs(other.motion.alpha) * reach;
      if (!turns) {
        bend += fall;
      } else {
        const double lever = w.norm();
        if (speed > 0) horizon = std::min(horizon, (lever + search_.size) / speed);
        bend += std::max(0.0, growth) + relative_acceleration.norm() + 2 * sr.w_max * speed +
                (sr.w_max * sr.w_max + std::abs(reference.motion.alpha)) * (lever + speed * horizon);
      }
      least = std::min(least, within(horizon, left, safe_time(gap, slope, bend, scale_, is_held && t == 0)));
    }
    return least;
  }

  /// How long the fixed direction d separates all points of a from those of b [s].
  double fixed_lasts(const Vec2& d, const State& sa, const State& sb, double t) const {
    const double swells = sa.swells + sb.swells;
    const double along =
        std::max(0.0, a_.motion.swell.growth + b_.motion.swell.growth + d.dot(b_.motion.a - a_.motion.a));
    double least = forever;
    for (int i = 0; i < a_.count; ++i) {
      for (int j = 0; j < b_.count && least > 0; ++j) {
        const FeatureId feature = a_.point_id(a_.base, i), against = b_.point_id(b_.base, j);
        const bool is_held = search_.holds(feature, against);
        if (is_held && search_.held_are_solved) continue;
        const Vec2 ra = sa.r * a_.points[i], rb = sb.r * b_.points[j];
        const double gap = d.dot(sa.x + ra - sb.x - rb) - sa.radius - sb.radius + search_.slack;
        const double slope = d.dot(sa.v + cross(sa.w, ra) - sb.v - cross(sb.w, rb)) - swells;
        const double bend = along + (sa.w_max * sa.w_max + std::abs(a_.motion.alpha)) * ra.norm() +
                            (sb.w_max * sb.w_max + std::abs(b_.motion.alpha)) * rb.norm();
        least = std::min(least, safe_time(gap, slope, bend, scale_, is_held && t == 0));
      }
    }
    return least;
  }

  double lasts(const Direction& direction, const State& sa, const State& sb, double t) const {
    if (direction.kind == 0) return edge_lasts(a_, sa, b_, sb, direction.edge, true, t);
    if (direction.kind == 1) return edge_lasts(b_, sb, a_, sa, direction.edge, false, t);
    return fixed_lasts(direction.fixed, sa, sb, t);
  }

  /// The unit vector between the nearest points, from b to a.
  Vec2 between_points(const State& sa, const State& sb) const {
    Vec2 best = Vec2::UnitY();
    double nearest = forever;
    for (int i = 0; i < a_.count; ++i)
      for (int j = 0; j < b_.count; ++j) {
        const Vec2 away = sa.x + sa.r * a_.points[i] - sb.x - sb.r * b_.points[j];
        if (const double distance = away.norm(); distance < nearest && distance > 0)
          nearest = distance, best = away / distance;
      }
    return best;
  }

  /// The edge of `reference` from which the points of `other` are now farthest.
  static int farthest_edge(const MovingHull& reference, const State& sr, const MovingHull& other,
                           const State& so) {
    int farthest = 0;
    double most = -forever;
    // In the frame of `reference`
    const Vec2 x = sr.r.inverse(so.x - sr.x);
    const Rotation2 r{sr.r.c * so.r.c + sr.r.s * so.r.s, sr.r.c * so.r.s - sr.r.s * so.r.c};
    for (int e = 0; e < reference.count; ++e) {
      const Vec2& normal = reference.normals[e];
      const Vec2 towards = r.inverse(normal);
      double gap = forever;
      for (int j = 0; j < other.count; ++j) gap = std::min(gap, towards.dot(other.points[j]));
      gap += normal.dot(x - reference.points[e]);
      if (gap > most) most = gap, farthest = e;
    }
    return farthest;
  }

  /// Finds a direction that separates for long. Returns for how long [s]; 0 if no direction separates. The
  /// edges that are farthest now mostly last; all others are tried only if these do not separate.
  double longest(const State& sa, const State& sb, double t, Direction& direction) const {
    double best = 0;
    const double enough = end_ - t;
    const auto try_direction = [&](int kind, int edge, const Vec2& fixed = Vec2::Zero()) {
      const Direction candidate{kind, edge, fixed};
      if (const double time = lasts(candidate, sa, sb, t); time > best) best = time, direction = candidate;
    };
    if (b_.count > 1) try_direction(1, b_.count > 2 ? farthest_edge(b_, sb, a_, sa) : 0);
    if (a_.count > 1 && best < enough) try_direction(0, farthest_edge(a_, sa, b_, sb));
    if (a_.radius + b_.radius > 0 && best < enough) try_direction(2, 0, between_points(sa, sb));
    if (best > 0) return best;
    for (int e = 0; b_.count > 1 && e < b_.count && best < enough; ++e) try_direction(1, e);
    for (int e = 0; a_.count > 1 && e < a_.count && best < enough; ++e) try_direction(0, e);
    return best;
  }

  const MovingHull& a_;
  const MovingHull& b_;
  double end_;
  const TouchSearch& search_;
  GapScale scale_;
};

}  // namespace

std::optional<double> advance_to_contact(const MovingHull& a, const MovingHull& b, const TimeWindow& window,
                                         const TouchSearch& search) {
  return Search(a, b, window.b, search).run(window.a);
}

}  // namespace flyrock
