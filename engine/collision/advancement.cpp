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
  Vec2 x = Vec2::Zero(), v = Vec2::Zero();
  double w = 0;
  /// Bounds of the first three derivatives of a unit vector that turns with the hull, until the end
  double turn1 = 0, turn2 = 0, turn3 = 0;
  double radius = 0, swells = 0;  ///< m and m/s, now

  State(const MovingHull& hull, double t, double end) : r(hull.start) {
    if (hull.rests) return;
    const Motion2& motion = hull.motion;
    if (t != 0) r = Rotation2::from_angle(motion.angle_at(t));
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
      touches_ = false;
      double step = chosen ? lasts(direction, sa, sb, t) : 0;
      if (step <= 0) {
        step = longest(sa, sb, t, direction, chosen);
        chosen = true;
      }
      if (step <= 0) return t;
      if (step >= end_ - t) return std::nullopt;
      const double next = t + step;
      if (next <= t) return t;  // below the resolution of time
      sa.advance(a_, t, next);
      if (!b_.rests) sb.advance(b_, t, next);
      t = next;
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
    std::uint64_t clear = 0;    ///< of the edge, which points stay clear of it until the end: a bit for each
  };

  static constexpr int most_marks = 64;
  static bool is_marked(std::uint64_t marks, int i) { return i < most_marks && (marks >> i & 1) != 0; }
  static void mark(std::uint64_t& marks, int i) {
    if (i < most_marks) marks |= std::uint64_t{1} << i;
  }

  /// An edge of one hull with the points of the other, which it may separate.
  struct Pair {
    const MovingHull& reference;
    const State& sr;
    const MovingHull& other;
    const State& so;
    int edge;
    bool reference_is_a;
    Vec2 normal = sr.r * reference.normals[edge];
    double offset = reference.normals[edge].dot(reference.points[edge]) + sr.radius + so.radius;
    Vec2 acceleration = other.motion.a - reference.motion.a;
    double swells = sr.swells + so.swells;  ///< m/s; the growth of the radii closes the gap
    double growth = reference.motion.swell.growth + other.motion.swell.growth;  ///< m/s2
  };

  bool is_held(const Pair& pair, int point) const {
    const FeatureId of_edge = pair.reference.edge_id(pair.reference.base, pair.edge);
    const FeatureId of_point = pair.other.point_id(pair.other.base, point);
    return pair.reference_is_a ? search_.holds(of_edge, of_point) : search_.holds(of_point, of_edge);
  }

  /// Notes a point that has closed on the edge itself, between its ends: then no direction separates. Close
  /// to an end, the next edge may.
  void note_touch(const Pair& pair, double gap, int point) {
    if (touches_ || gap < -scale_.deep) return;
    const MovingHull& hull = pair.reference;
    const Vec2 start = hull.points[pair.edge], along = hull.points[(pair.edge + 1) % hull.count] - start;
    const Vec2 place = pair.so.x + pair.so.r * pair.other.points[point] - pair.sr.x;
    const double length = along.norm(), foot = along.dot(pair.sr.r.inverse(place) - start) / length;
    touches_ = foot > scale_.deep && foot < length - scale_.deep;
  }

  /// How long the edge separates the points of the other hull [s].
  double edge_lasts(const Pair& pair, double t, std::uint64_t& clear) {
    const bool turns = pair.sr.turn1 != 0 || pair.reference.motion.alpha != 0;
    return turns ? turning_edge_lasts(pair, t) : steady_edge_lasts(pair, t, clear);
  }

  /// The same for an edge that does not turn. The gap and its derivatives are then linear in the point p.
  /// Points that stay clear until the end of the search are added to `clear`, and those in it are passed
  /// over.
  double steady_edge_lasts(const Pair& pair, double t, std::uint64_t& clear) {
    const State& so = pair.so;
    const double left = end_ - t, alpha = pair.other.motion.alpha, square = so.w * so.w;
    const double gap0 = pair.normal.dot(so.x - pair.sr.x) - pair.offset + search_.slack;
    const double slope0 = pair.normal.dot(so.v - pair.sr.v) - pair.swells;
    const double curvature0 = pair.normal.dot(pair.acceleration) - pair.growth;
    const double bend = std::max(0.0, -curvature0) + so.turn2 * pair.other.reach;
    const double jerk = so.turn3 * pair.other.reach;
    const Vec2 rise = so.r.inverse(pair.normal), across(rise.y(), -rise.x());
    double least = forever;
    const auto see = [&](int j) {
      const Vec2& p = pair.other.points[j];
      const double height = rise.dot(p), side = across.dot(p);
      const GapBound bound{gap0 + height, slope0 + so.w * side, curvature0 + alpha * side - square * height,
                           jerk, bend};
      if (bound.stays_open(std::min(least, left))) {
        if (least >= left) mark(clear, j);
        return;
      }
      const bool held = is_held(pair, j);
      if (held && search_.held_are_solved) return;
      const double time = within(left, left, bound.safe_time(std::min(least, left), scale_, held && t == 0));
      if (time <= 0 && bound.slope < 0) note_touch(pair, bound.gap, j);
      least = std::min(least, time);
    };
    // The nearest point first: most others then need only the question whether they stay open for as long.
    int nearest = 0;
    for (int j = 1; j < pair.other.count; ++j)
      if (rise.dot(pair.other.points[j]) < rise.dot(pair.other.points[nearest])) nearest = j;
    if (!is_marked(clear, nearest)) see(nearest);
    // GapBound::stays_open with either curvature, as linear functions of the place of the point: at the end
    // of the time asked for, and of its bend.
    const double open_for = std::min(least, left), half_square = 0.5 * open_for * open_for;
    const double second = gap0 + open_for * slope0 - half_square * bend, second_of_side = open_for * so.w;
    const double third = gap0 + open_for * slope0 + half_square * (curvature0 - jerk * open_for);
    const double third_of_height = 1 - half_square * square;
    const double third_of_side = second_of_side + half_square * alpha;
    const double most_curvature = jerk * open_for - curvature0;
    for (int j = 0; j < pair.other.count && least > 0; ++j) {
      if (j == nearest || is_marked(clear, j)) continue;
      const double height = rise.dot(pair.other.points[j]), side = across.dot(pair.other.points[j]);
      if (gap0 + height > 0 && (second + height + second_of_side * side > 0 ||
                                (third + third_of_height * height + third_of_side * side > 0 &&
                                 alpha * side - square * height <= most_curvature))) {
        if (open_for >= left) mark(clear, j);
      } else {
        see(j);
      }
    }
    return least;
  }

  /// The same for an edge that turns: gap = n . w - offset, with w from the centre of its hull to the point.
  double turning_edge_lasts(const Pair& pair, double t) {
    const auto& [reference, sr, other, so, edge, reference_is_a, normal, offset, acceleration, swells,
                 growth] = pair;
    const Vec2 turn = perpendicular(normal), bent = reference.motion.alpha * turn - sr.w * sr.w * normal;
    const double left = end_ - t, pull = acceleration.norm(), reach = other.reach;
    const double speed = (so.v - sr.v).norm() + pull * left + so.turn1 * reach;  // |w'| is at most this
    const double closing = std::max(0.0, growth) + pull + so.turn2 * reach + 2 * sr.turn1 * speed;
    double least = forever;
    for (int j = 0; j < other.count && least > 0; ++j) {
      const bool held = is_held(pair, j);
      if (held && search_.held_are_solved) continue;
      const Vec2 arm = so.r * other.points[j];
      const Vec2 w = so.x + arm - sr.x;
      const Vec2 velocity = so.v + cross(so.w, arm) - sr.v;
      const Vec2 rate = acceleration + cross(other.motion.alpha, arm) - so.w * so.w * arm;
      // The horizon limits the growth of the lever |w| of a turning normal.
      const double lever = w.norm();
      const double horizon = speed > 0 ? std::min(left, (lever + search_.size) / speed) : left;
      const double longest = lever + speed * horizon;
      const GapBound bound{normal.dot(w) - offset + search_.slack,
                           sr.w * turn.dot(w) + normal.dot(velocity) - swells,
                           bent.dot(w) + 2 * sr.w * turn.dot(velocity) + normal.dot(rate) - growth,
                           sr.turn3 * longest + 3 * sr.turn2 * speed +
                               3 * sr.turn1 * (pull + so.turn2 * reach) + so.turn3 * reach,
                           closing + sr.turn2 * longest};
      const double time = within(horizon, left, bound.safe_time(horizon, scale_, held && t == 0));
      if (time <= 0 && bound.slope < 0) note_touch(pair, bound.gap, j);
      least = std::min(least, time);
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
        const double bend = along + sa.turn2 * ra.norm() + sb.turn2 * rb.norm();
        least = std::min(least, safe_time(gap, slope, bend, scale_, is_held && t == 0));
      }
    }
    return least;
  }

  double lasts(Direction& direction, const State& sa, const State& sb, double t) {
    if (direction.kind == 0) return edge_lasts({a_, sa, b_, sb, direction.edge, true}, t, direction.clear);
    if (direction.kind == 1) return edge_lasts({b_, sb, a_, sa, direction.edge, false}, t, direction.clear);
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
  /// edges that are farthest now mostly last; all others are tried only if these do not separate. `ended`:
  /// `direction` separates no longer.
  double longest(const State& sa, const State& sb, double t, Direction& direction, bool ended) {
    double best = 0;
    const double enough = end_ - t;
    const int ended_kind = ended ? direction.kind : -1, ended_edge = direction.edge;
    const auto try_direction = [&](int kind, int edge, const Vec2& fixed = Vec2::Zero()) {
      if (kind == ended_kind && edge == ended_edge && kind != 2) return;
      Direction candidate{kind, edge, fixed};
      if (const double time = lasts(candidate, sa, sb, t); time > best) best = time, direction = candidate;
    };
    if (b_.count > 1) try_direction(1, b_.count > 2 ? farthest_edge(b_, sb, a_, sa) : 0);
    // The normal of a segment of the ground mostly lasts longer than that of an edge that turns.
    const bool goes_on = b_.rests ? best <= 0 : best < enough;
    if (a_.count > 1 && goes_on && !touches_) try_direction(0, farthest_edge(a_, sa, b_, sb));
    if (a_.radius + b_.radius > 0 && best < enough && !touches_) try_direction(2, 0, between_points(sa, sb));
    if (best > 0 || touches_) return best;
    for (int e = 0; b_.count > 1 && e < b_.count && best < enough && !touches_; ++e) try_direction(1, e);
    for (int e = 0; a_.count > 1 && e < a_.count && best < enough && !touches_; ++e) try_direction(0, e);
    return best;
  }

  const MovingHull& a_;
  const MovingHull& b_;
  double end_;
  const TouchSearch& search_;
  GapScale scale_;
  bool touches_ = false;  ///< a vertex has closed on an edge, between its ends: no direction separates
};

}  // namespace

std::optional<double> advance_to_contact(const MovingHull& a, const MovingHull& b, const TimeWindow& window,
                                         const TouchSearch& search) {
  return Search(a, b, window.b, search).run(window.a);
}

}  // namespace flyrock
