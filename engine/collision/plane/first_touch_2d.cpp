// Times of impact of balls, pills and hulls in 2D.

#include <algorithm>
#include <array>
#include <cmath>

#include "collision/plane/advancement_2d.h"
#include "collision/plane/steady_gaps.h"
#include "collision/round_path.h"
#include "collision/rules.h"
#include "math/polynomial.h"

namespace flyrock {

namespace {

FeatureId corner_of_ground(int base, int i) { return corner_id(base + i); }
FeatureId segment_of_ground(int base, int) { return segment_id(base); }

class DiskSearch {
 public:
  DiskSearch(double radius, FeatureId feature, const Motion2& motion, const Ground2& ground,
             const TouchSearch& search)
      : radius_(radius), feature_(feature), motion_(motion), ground_(ground), search_(search) {}

  void segment(int i, const TimeWindow& window, std::optional<double>& best) const {
    const Counts counts = search_.held.counts(feature_, segment_id(i), 0);
    if (counts == Counts::never) return;
    const Vec2& n = ground_.normal(i);
    const Swell& swell = motion_.swell;
    const std::array<double, 3> gap{
        search_.start_gap(n.dot(motion_.x - ground_.start(i)) - (radius_ + swell.by), counts),
        n.dot(motion_.v) - swell.rate, 0.5 * (n.dot(motion_.a) - swell.growth)};
    const auto t = first_approach(gap, window.a, window.b);
    if (!t || (best && *t >= *best)) return;
    const Vec2 from_start = motion_.position(*t) - ground_.start(i);
    const double s = from_start.dot(ground_.tangent(i));
    const bool beside =
        s < -beyond_end(i, i, i - 1, *t) || s > ground_.length(i) + beyond_end(i, i + 1, i + 1, *t);
    if (!beside && !is_behind(n.dot(from_start), *t)) best = t;
  }

  void corner(int i, const TimeWindow& window, std::optional<double>& best) const {
    if (ground_.corner(i) != Corner::convex || radius_ == 0) return;  // a point meets a segment first
    const Counts counts = search_.held.counts(feature_, corner_id(i), 0);
    if (counts == Counts::never) return;
    const Path<2> relative{motion_.x - ground_.point(i), motion_.v, motion_.a};
    const double start = radius_ + motion_.swell.by;
    const auto square =
        ball_gap(relative, start, motion_.swell, search_.start_gap(relative.x.norm() - start, counts));
    const auto t = first_approach(square, window.a, window.b);
    if (t && (!best || *t < *best)) best = t;
  }

 private:
  /// How far the strip of a segment extends beyond its end at `corner`, where `neighbour` begins, at time t
  /// [m]. At a concave corner a disk may have sunk into the neighbour, if only by rounding. It then meets the
  /// line of this segment before it reaches the strip.
  double beyond_end(int segment, int corner, int neighbour, double t) const {
    const double least = 1e-9 * ground_.length(segment);
    if (ground_.corner(corner) != Corner::concave) return least;
    if (radius_ > 0) return std::max(least, std::min(radius_, ground_.length(neighbour)));
    const double depth = ground_.normal(neighbour).dot(ground_.point(corner) - motion_.position(t));
    return depth <= point_sinks(motion_, t, search_) ? ground_.length(neighbour) : least;
  }

  /// Whether the centre, which is `height` [m] above the line of a segment, is free above another part of the
  /// polyline. A point that has sunk into the ground is below the line too.
  bool is_behind(double height, double t) const {
    if (height >= -1e-6 * search_.size) return false;
    const bool is_sunk =
        radius_ == 0 && height >= -shallow_share * search_.size && ground_.is_inside(motion_.position(t));
    return !is_sunk;
  }

  double radius_;
  FeatureId feature_;
  const Motion2& motion_;
  const Ground2& ground_;
  const TouchSearch& search_;
};

/// A time window in [0, t_max]. Outside it, a circle of radius r about the moving point does not meet the
/// segment. In the frame of the segment its box is flat: the box of a steep face in the world is mostly air.
TimeWindow segment_window(const Path<2>& path, double r, const Ground2& ground, int i, double t_max) {
  const auto local = [&](const Vec2& v) { return Vec2(v.dot(ground.tangent(i)), v.dot(ground.normal(i))); };
  const Box2 flat{Vec2::Zero(), {ground.length(i), 0}};
  return meeting_window(Path<2>{local(path.x - ground.start(i)), local(path.v), local(path.a)}, r, flat,
                        t_max);
}

MovingHull hull_of(const Moving2& moving) {
  const Contactor2& contactor = moving.shape;
  return {contactor.points.data(),
          contactor.normals.data(),
          static_cast<int>(contactor.points.size()),
          contactor.radius,
          contactor.bound,
          moving.motion,
          vertex_id,
          edge_id,
          moving.index};
}

/// Which segments a hull stays clear of, by the bounds of gaps in time_of_contact. In most steps a body moves
/// by a part of its size, and stays above nearly all segments. `travel` [m]: no place of the hull moves
/// farther.
class ClearSegments {
 public:
  ClearSegments(const MovingHull& hull, const Ground2& ground, const TouchSearch& search, double travel)
      : hull_(hull), ground_(ground), search_(search), travel_(travel) {}

  /// Whether the hull stays clear of segment i until t_max: above its line, or above that of a neighbour
  /// beyond a convex corner, if what stands on the neighbour does not reach the corner. t_max does not grow
  /// from call to call.
  bool contains(int i, double t_max) {
    const bool convex_start = ground_.corner(i) == Corner::convex,
               convex_end = ground_.corner(i + 1) == Corner::convex;
    // What is known of a neighbour first, because it costs nothing.
    if (convex_start && is_known(i - 1) && line(i - 1, t_max).shields_end()) return true;
    if (convex_end && is_known(i + 1) && line(i + 1, t_max).shields_start()) return true;
    return line(i, t_max).above || (convex_start && line(i - 1, t_max).shields_end()) ||
           (convex_end && line(i + 1, t_max).shields_start());
  }

 private:
  /// What is known of the hull over the line of a segment.
  struct Line {
    int segment = -1;
    bool above = false;                             ///< the hull stays above the line
    bool start_is_free = true, end_is_free = true;  ///< nothing that stands on the segment reaches that end

    bool shields_start() const { return above && start_is_free; }
    bool shields_end() const { return above && end_is_free; }
  };

  bool is_known(int i) const { return lines_[i % lines_.size()].segment == i; }
  const Line& line(int i, double t_max) {
    Line& line = lines_[i % lines_.size()];
    if (line.segment != i) line = measure(i, t_max);
    return line;
  }

  /// Contacts that the solver holds may stand on the segment.
  Line measure(int i, double t_max) const {
    const Motion2& motion = hull_.motion;
    const Vec2& normal = ground_.normal(i);
    const double spin = motion.greatest_spin(t_max), alpha = std::abs(motion.alpha);
    const double curvature = normal.dot(motion.a);
    const SteadyGaps gaps{.centre = {.gap = normal.dot(motion.x - ground_.start(i)) - hull_.radius,
                                     .slope = normal.dot(motion.v),
                                     .curvature = curvature,
                                     .jerk = spin * (spin * spin + 3 * alpha) * hull_.reach,
                                     .bend = std::max(0.0, -curvature) + (spin * spin + alpha) * hull_.reach},
                          .rise = hull_.start.inverse(normal),
                          .w = motion.w,
                          .alpha = motion.alpha};
    const OpenUntil open(gaps, t_max);
    Line line{.segment = i, .above = open.lasts_from(-hull_.reach, hull_.reach)};
    if (line.above) return line;
    for (int k = 0; k < hull_.count; ++k) {
      const Vec2& p = hull_.points[k];
      if (open.lasts(p)) continue;
      if (search_.held.counts(hull_.point_id(hull_.base, k), segment_id(i), 0) != Counts::never) return line;
      const Vec2 place = motion.x + hull_.start * p;
      line.start_is_free = line.start_is_free && (place - ground_.start(i)).norm() > travel_;
      line.end_is_free = line.end_is_free && (place - ground_.end(i)).norm() > travel_;
    }
    line.above = true;
    return line;
  }

  const MovingHull& hull_;
  const Ground2& ground_;
  const TouchSearch& search_;
  double travel_;
  std::array<Line, 4> lines_;  ///< the last ones that were asked for
};

}  // namespace

std::optional<double> hull_touch_of_ground(Workspace&, const Moving2& moving, const Ground2& ground,
                                           double t_max, const TouchSearch& search) {
  const Contactor2& contactor = moving.shape;
  const Motion2& motion = moving.motion;
  const double reach = contactor.bound + motion.swell.greatest(t_max);
  const bool round = contactor.points.size() == 1 && contactor.points[0].isZero();
  const DiskSearch disk(contactor.radius, vertex_id(moving.index, 0), motion, ground, search);
  const MovingHull hull = hull_of(moving);
  const double travel = greatest_travel(motion, contactor.bound, t_max);
  const bool is_slow = !round && travel < contactor.bound;
  ClearSegments clear(hull, ground, search, travel);

  // Visit the segments in the order in which the body passes over them. Segments that it reaches after the
  // best time cannot matter.
  const Box2 swept = swept_box(motion, reach, t_max);
  const auto run = ground.segments_between(swept.low.x(), swept.high.x());
  const bool leftwards = motion.v.x() < 0;
  std::optional<double> best;
  for (int k = 0; k <= run.last - run.first; ++k) {
    const int i = leftwards ? run.last - k : run.first + k;
    const double limit = best ? *best : t_max;
    if (best && motion.a.x() == 0 && !ground.closed()) {
      const double ahead =
          leftwards ? motion.x.x() - reach - ground.end(i).x() : ground.start(i).x() - motion.x.x() - reach;
      if (ahead > std::abs(motion.v.x()) * limit) break;
    }
    if (is_slow && clear.contains(i, limit)) continue;
    const TimeWindow window = round ? meeting_window(motion, reach, ground.box(i), limit)
                                    : segment_window(motion, reach, ground, i, limit);
    if (window.empty()) continue;
    if (round) {
      if (search.iterations) ++*search.iterations;
      disk.segment(i, window, best);
      disk.corner(i, window, best);
    } else {
      const Vec2 ends[2] = {ground.start(i), ground.end(i)};
      const Vec2 normals[2] = {ground.normal(i), -ground.normal(i)};
      static const Motion2 at_rest;
      const MovingHull segment{ends, normals, 2, 0, 0, at_rest, corner_of_ground, segment_of_ground, i, true};
      const auto t = advance_to_contact(hull, segment, window, search);
      if (t && (!best || *t < *best)) best = t;
    }
  }
  return best;
}

std::optional<double> ball_touch(Workspace& work, const Moving2& a, const Moving2& b, double t_max,
                                 const TouchSearch& search) {
  if (a.shape.radius + b.shape.radius == 0) return std::nullopt;  // two points
  return hull_touch(work, a, b, t_max, search);
}

std::optional<double> hull_touch(Workspace&, const Moving2& a, const Moving2& b, double t_max,
                                 const TouchSearch& search) {
  return advance_to_contact(hull_of(a), hull_of(b), {0, t_max}, search);
}

}  // namespace flyrock
