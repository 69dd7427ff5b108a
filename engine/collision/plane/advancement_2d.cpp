#include "collision/plane/advancement_2d.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/plane/steady_gaps.h"
#include "collision/safe_time.h"

namespace flyrock {

namespace {

constexpr int most_iterations = 500;

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

class Search {
 public:
  Search(const MovingHull& a, const MovingHull& b, double end, const TouchSearch& search)
      : a_(a), b_(b), end_(end), search_(search), scale_(search.size) {}

  std::optional<double> run(double t) {
    Direction direction;
    bool chosen = false;
    HullState sa(a_, t, end_), sb(b_, t, end_);
    for (int i = 0; i < most_iterations; ++i) {
      if (search_.iterations) ++*search_.iterations;
      touches_ = false;
      touch_after_ = pass_after_ = -1;
      double step = chosen ? lasts(direction, sa, sb, t) : 0;
      if (step <= 0 || step == pass_after_) step = longest(sa, sb, t, direction, chosen, step);
      chosen = true;
      if (step <= 0) return t;
      if (step >= end_ - t) return std::nullopt;
      const double next = t + step;
      if (next <= t || step == touch_after_) return next;  // the first: below the resolution of time
      last_step_ = step;
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
  };

  /// An edge of one hull with the points of the other, which it may separate.
  struct Pair {
    const MovingHull& reference;
    const HullState& sr;
    const MovingHull& other;
    const HullState& so;
    int edge;
    bool reference_is_a;
    Vec2 normal = sr.r * reference.normals[edge];
    double offset = reference.normals[edge].dot(reference.points[edge]) + sr.radius + so.radius;
    Vec2 acceleration = other.motion.a - reference.motion.a;
    double swells = sr.swells + so.swells;  ///< m/s; the growth of the radii closes the gap
    double growth = reference.motion.swell.growth + other.motion.swell.growth;  ///< m/s2
  };

  /// How the gap of a point over the edge counts at time t.
  Counts counts(const Pair& pair, int point, double t) const {
    const FeatureId of_edge = pair.reference.edge_id(pair.reference.base, pair.edge);
    const FeatureId of_point = pair.other.point_id(pair.other.base, point);
    return pair.reference_is_a ? search_.held.counts(of_edge, of_point, t)
                               : search_.held.counts(of_point, of_edge, t);
  }

  /// Whether a point is now above the edge, between its ends.
  bool meets_edge(const Pair& pair, int point) const {
    const MovingHull& hull = pair.reference;
    const Vec2 start = hull.points[pair.edge], along = hull.points[(pair.edge + 1) % hull.count] - start;
    const Vec2 place = pair.so.x + pair.so.r * pair.other.points[point] - pair.sr.x;
    const double length = along.norm(), foot = along.dot(pair.sr.r.inverse(place) - start) / length;
    return foot > scale_.deep && foot < length - scale_.deep;
  }

  /// Notes a point that has closed on the edge itself, between its ends: then no direction separates. Close
  /// to an end, the next edge may.
  void note_touch(const Pair& pair, double gap, int point) {
    touches_ = touches_ || (gap >= -scale_.deep && meets_edge(pair, point));
  }

  /// Notes what a point that closes on the line of the edge after `time` does there. If it touches the edge
  /// between its ends, the search ends there. If it passes an end, another direction separates for longer; it
  /// is tried as soon as the steps converge, not only after the last one.
  void note_end(const Pair& pair, const GapBound& bound, int point, double time) {
    constexpr double converging = 0.6;
    const bool closes = bound.closes_by(time, scale_.least);
    if (!closes && time > converging * last_step_) return;
    if (meets_edge(pair, point)) {
      if (closes) touch_after_ = time;
    } else {
      pass_after_ = time;
    }
  }

  /// How long the edge separates the points of the other hull [s].
  double edge_lasts(const Pair& pair, double t) {
    const bool turns = pair.sr.turn1 != 0 || pair.reference.motion.alpha != 0;
    return turns ? turning_edge_lasts(pair, t) : steady_edge_lasts(pair, t);
  }

  /// The same for an edge that does not turn.
  double steady_edge_lasts(const Pair& pair, double t) {
    const double left = end_ - t;
    const MovingHull& other = pair.other;
    const HullState& so = pair.so;
    const SteadyGaps gaps{.centre = gap_of_centre(pair),
                          .rise = so.r.inverse(pair.normal),
                          .w = so.w,
                          .alpha = other.motion.alpha};
    double least = forever;
    GapBound closing{};
    int closing_point = 0;
    const auto see = [&](int j) {
      const GapBound bound = gaps.of(other.points[j]);
      if (bound.stays_open(std::min(least, left))) return;
      const Counts counted = counts(pair, j, t);
      if (counted == Counts::never) return;
      const double time = within(left, left, bound.safe_time(std::min(least, left), scale_, counted));
      if (time <= 0 && bound.slope < 0) note_touch(pair, bound.gap, j);
      if (time < least) least = time, closing = bound, closing_point = j;
    };
    // The nearest point first: most others then need only the question whether they stay open for as long.
    int nearest = 0;
    double lowest = forever, second = forever;
    for (int j = 0; j < other.count; ++j) {
      const double height = gaps.rise.dot(other.points[j]);
      second = std::min(second, std::max(height, lowest));
      if (height < lowest) lowest = height, nearest = j;
    }
    see(nearest);
    const OpenUntil open(gaps, std::min(least, left));
    if (least > 0 && !open.lasts_from(second, other.reach))
      for (int j = 0; j < other.count && least > 0; ++j)
        if (j != nearest && !open.lasts(other.points[j])) see(j);
    if (least > 0 && least < left) note_end(pair, closing, closing_point, least);
    return least;
  }

  /// The bound of the gap of the centre of the other hull to an edge that does not turn; its jerk and bend
  /// serve all points.
  GapBound gap_of_centre(const Pair& pair) const {
    const HullState& so = pair.so;
    const double curvature = pair.normal.dot(pair.acceleration) - pair.growth;
    return {.gap = pair.normal.dot(so.x - pair.sr.x) - pair.offset + search_.slack,
            .slope = pair.normal.dot(so.v - pair.sr.v) - pair.swells,
            .curvature = curvature,
            .jerk = so.turn3 * pair.other.reach,
            .bend = std::max(0.0, -curvature) + so.turn2 * pair.other.reach};
  }

  /// The same for an edge that turns: gap = n . w - offset, with w from the centre of its hull to the point.
  double turning_edge_lasts(const Pair& pair, double t) {
    const auto& [reference, sr, other, so, edge, reference_is_a, normal, offset, acceleration, swells,
                 growth] = pair;
    const Vec2 turn = perpendicular(normal), bent = reference.motion.alpha * turn - sr.w * sr.w * normal;
    const double left = end_ - t, pull = acceleration.norm(), reach = other.reach;
    const double speed = (so.v - sr.v).norm() + pull * left + so.turn1 * reach;  // |w'| is at most this
    const double bend = std::max(0.0, growth) + pull + so.turn2 * reach + 2 * sr.turn1 * speed;
    double least = forever;
    GapBound closing{};
    int closing_point = 0;
    for (int j = 0; j < other.count && least > 0; ++j) {
      const Counts counted = counts(pair, j, t);
      if (counted == Counts::never) continue;
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
                           bend + sr.turn2 * longest};
      const double time = within(horizon, left, bound.safe_time(horizon, scale_, counted));
      if (time <= 0 && bound.slope < 0) note_touch(pair, bound.gap, j);
      if (time < least) least = time, closing = bound, closing_point = j;
    }
    if (least > 0 && least < left) note_end(pair, closing, closing_point, least);
    return least;
  }

  /// How long the fixed direction d separates all points of a from those of b [s].
  double fixed_lasts(const Vec2& d, const HullState& sa, const HullState& sb, double t) const {
    const double swells = sa.swells + sb.swells;
    const double along =
        std::max(0.0, a_.motion.swell.growth + b_.motion.swell.growth + d.dot(b_.motion.a - a_.motion.a));
    double least = forever;
    for (int i = 0; i < a_.count; ++i) {
      for (int j = 0; j < b_.count && least > 0; ++j) {
        const FeatureId feature = a_.point_id(a_.base, i), against = b_.point_id(b_.base, j);
        const Counts counted = search_.held.counts(feature, against, t);
        if (counted == Counts::never) continue;
        const Vec2 ra = sa.r * a_.points[i], rb = sb.r * b_.points[j];
        const double gap = d.dot(sa.x + ra - sb.x - rb) - sa.radius - sb.radius + search_.slack;
        const double slope = d.dot(sa.v + cross(sa.w, ra) - sb.v - cross(sb.w, rb)) - swells;
        const double bend = along + sa.turn2 * ra.norm() + sb.turn2 * rb.norm();
        least = std::min(least, safe_time(gap, slope, bend, scale_, counted));
      }
    }
    return least;
  }

  double lasts(const Direction& direction, const HullState& sa, const HullState& sb, double t) {
    if (direction.kind == 0) return edge_lasts({a_, sa, b_, sb, direction.edge, true}, t);
    if (direction.kind == 1) return edge_lasts({b_, sb, a_, sa, direction.edge, false}, t);
    return fixed_lasts(direction.fixed, sa, sb, t);
  }

  /// The unit vector between the nearest points, from b to a.
  Vec2 between_points(const HullState& sa, const HullState& sb) const {
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
  static int farthest_edge(const MovingHull& reference, const HullState& sr, const MovingHull& other,
                           const HullState& so) {
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
  /// edges that are farthest now mostly last; all others are tried only if these do not separate. `known`:
  /// `direction` separates for the time `best`, and is kept if no other one separates for longer.
  double longest(const HullState& sa, const HullState& sb, double t, Direction& direction, bool known,
                 double best) {
    const double enough = end_ - t, of_known = best;
    const int known_kind = known ? direction.kind : -1, known_edge = direction.edge;
    const auto try_direction = [&](int kind, int edge, const Vec2& fixed = Vec2::Zero()) {
      if (kind == known_kind && edge == known_edge && kind != 2) return;
      const Direction candidate{kind, edge, fixed};
      if (const double time = lasts(candidate, sa, sb, t); time > best) best = time, direction = candidate;
    };
    if (b_.count > 1) try_direction(1, b_.rests ? 0 : farthest_edge(b_, sb, a_, sa));
    // The normal of a segment of the ground mostly lasts longer than that of an edge that turns.
    const bool goes_on = b_.rests ? best <= of_known : best < enough;
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
  double last_step_ = forever;  ///< s
  /// Of the direction that was asked last: how long it separates if a point then touches the edge, or passes
  /// an end of it [s]; -1 if neither is known.
  double touch_after_ = -1, pass_after_ = -1;
  bool touches_ = false;  ///< a vertex has closed on an edge, between its ends: no direction separates
};

}  // namespace

std::optional<double> advance_to_contact(const MovingHull& a, const MovingHull& b, const TimeWindow& window,
                                         const TouchSearch& search) {
  return Search(a, b, window.b, search).run(window.a);
}

}  // namespace flyrock
