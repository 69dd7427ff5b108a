// Time of impact of balls, pills and polyhedra in 3D.

#include <algorithm>
#include <array>

#include "collision/advance_3d.h"
#include "collision/held_3d.h"
#include "collision/hull/separating_axis.h"
#include "collision/pair_search.h"
#include "collision/pill/closest.h"
#include "collision/rules.h"
#include "collision/safe_time.h"

namespace flyrock {

namespace {

constexpr double most_sinking = 5e-5;  // of the size: of a point that another contact holds for now

/// A normal that turns with a contactor (of_a, of_b), or the cross product of two edges.
struct SeparatingDirection {
  enum class Kind { of_a, of_b, edges } kind = Kind::of_a;
  Vec3 local = Vec3::UnitZ();  ///< of_a, of_b: in that body's frame, outward
  double support = 0;          ///< of_a, of_b: how far the contactor reaches along it from the body's origin
  FeatureId feature = 0;       ///< of_a, of_b: the feature to which the normal belongs
  int edge_a = 0, edge_b = 0;  ///< edges
  double sign = 1;             ///< edges: of the product that points from b to a
};

/// The normal of a face.
SeparatingDirection face_direction(const Moving3& c, SeparatingDirection::Kind kind, int f) {
  const Contactor3::Face& face = c.shape.faces[f];
  const double support = face.normal.dot(c.shape.points[c.shape.vertex(face, 0)]);
  return {kind, face.normal, support, c.id(FeatureKind::face, f), 0, 0, 1};
}

/// A direction in the world that is normal to a feature of the contactor, and turns with it.
SeparatingDirection attached_direction(const Moving3& c, const MovingState& state,
                                       SeparatingDirection::Kind kind, const Vec3& outward,
                                       const ShapeFeature& feature) {
  SeparatingDirection d;
  d.kind = kind;
  d.local = state.turn.rotation.inverse(outward);
  d.feature = c.id(feature.kind, feature.index);
  d.support = -std::numeric_limits<double>::infinity();
  for (const Vec3& p : c.shape.points) d.support = std::max(d.support, d.local.dot(p));
  return d;
}

/// The cross product of an edge of a and an edge of b.
SeparatingDirection across_edges(const EdgeAxis& axis, const Placed3& a, const Placed3& b) {
  const auto along = [](const Placed3& p, int e) {
    return Vec3(p.point(p.shape.edges[e].end) - p.point(p.shape.edges[e].start));
  };
  SeparatingDirection d;
  d.kind = SeparatingDirection::Kind::edges;
  d.edge_a = axis.of_a;
  d.edge_b = axis.of_b;
  d.sign = along(a, axis.of_a).cross(along(b, axis.of_b)).dot(axis.normal) > 0 ? -1 : 1;
  return d;
}

/// The corners of a facet in the frame of a polyhedron, compared with the planes of its faces.
class OutsideFaces {
 public:
  OutsideFaces(const Placed3& polyhedron, const Placed3& facet) : shape_(polyhedron.shape) {
    for (int i = 0; i < 3; ++i) corner_[i] = polyhedron.pose.r.inverse(facet.point(i) - polyhedron.pose.x);
  }

  /// The distance of the nearest corner outside the plane of a face [m].
  double of(int face) const {
    const Vec3& normal = shape_.faces[face].normal;
    const double nearest = std::min({normal.dot(corner_[0]), normal.dot(corner_[1]), normal.dot(corner_[2])});
    return nearest - normal.dot(shape_.points[shape_.vertex(shape_.faces[face], 0)]);
  }

  /// The face outside which the facet is farthest.
  int farthest() const {
    int best = 0;
    double most = -std::numeric_limits<double>::infinity();
    for (int f = 0; f < static_cast<int>(shape_.faces.size()); ++f)
      if (const double distance = of(f); distance > most) most = distance, best = f;
    return best;
  }

 private:
  const Contactor3& shape_;
  std::array<Vec3, 3> corner_;
};

class PairSearch {
 public:
  PairSearch(const Moving3& a, const Moving3& b, CoreSearch by, double end, const TouchSearch& search)
      : a_(a),
        b_(b),
        end_(end),
        search_(search),
        held_(a, b, by, search),
        scale_(search.size),
        by_(by),
        by_pairs_(b.facet && by == CoreSearch::pill && !search.held.list.empty()) {}

  /// How long the direction of the last call separates the pair [s]. If it no longer does, the best direction
  /// is used.
  double lasts(double t) {
    const MovingState sa(a_, t, end_);
    if (!sb_ || !b_.facet) sb_.emplace(b_, t, end_);  // a facet is at rest
    const double step = chosen_ ? lasts(direction_, sa, *sb_, t) : 0;
    return step > 0 ? step : longest(sa, *sb_, t);
  }

  std::array<double, 5> clearance() const { return ball_clearance(a_, b_, search_); }

 private:
  using Direction = SeparatingDirection;

  static bool is_ball(const Placed3& core) { return core.count() == 1; }
  HeldPoints::Features features_of(const Direction& d) const {
    if (d.kind == Direction::Kind::of_a) return {d.feature, {}};
    if (d.kind == Direction::Kind::of_b) return {{}, d.feature};
    return {a_.id(FeatureKind::edge, d.edge_a), b_.id(FeatureKind::edge, d.edge_b)};
  }

  /// Bounds on the relative motion of two points while a normal turns.
  struct Bounds {
    double horizon;       ///< s, duration for which the bounds hold
    double speed;         ///< of the difference
    double acceleration;  ///< of the difference
  };

  /// The safe time for one pair of points. `turn` and `turn_rate` are bounds on |n'| and |n''|.
  double point_lasts(double gap, double slope, double lever, double turn, double turn_rate, const Bounds& b,
                     Counts counts, double t) const {
    const double bend = bend_of(turn, turn_rate, lever, b);
    return within(b.horizon, end_ - t, safe_time(gap + search_.slack, slope, bend, scale_, counts));
  }

  static double bend_of(double turn, double turn_rate, double lever, const Bounds& b) {
    return turn_rate * (lever + b.speed * b.horizon) + 2 * turn * b.speed + b.acceleration;
  }

  /// Added to a gap for a test that rounding must not pass.
  double margin() const { return search_.slack - 1e-9 * search_.size; }

  /// How far the points of the reference reach along a direction, apart for those whose pairs with the point
  /// j of the other contactor are held.
  struct Supports {
    double free = -forever, held = -forever;
    bool drifts = false;  ///< the normals of held contacts drift from the direction
  };
  Supports supports_of(const Direction& d, const Vec3& normal, const Moving3& reference,
                       const MovingState& sr, const MovingState& so, int j) const {
    const auto hold_of = [&](int i) {
      return &reference == &a_ ? held_.hold(-normal, features_of(d), i, j, sr)
                               : held_.hold(normal, features_of(d), j, i, so);
    };
    Supports supports;
    if (!by_pairs_) {  // a contact with a feature holds all of its points
      (hold_of(0) == Hold::no ? supports.free : supports.held) = d.support;
      return supports;
    }
    for (int i = 0; i < static_cast<int>(reference.shape.points.size()); ++i) {
      const Hold hold = hold_of(i);
      double& support = hold == Hold::no ? supports.free : supports.held;
      support = std::max(support, d.local.dot(reference.shape.points[i]));
      supports.drifts = supports.drifts || hold == Hold::for_now;
    }
    return supports;
  }

  /// The time in which a direction and the normal of a held contact drift apart by a small angle.
  double drift_time(const MovingState& sa, const MovingState& sb, double speed) const {
    const double rate = sa.w_max + sb.w_max + speed / (a_.shape.radius + b_.shape.radius);
    return rate > 0 ? drift_angle / rate : forever;
  }

  double face_lasts(const Direction& d, const Moving3& reference, const MovingState& sr, const Moving3& other,
                    const MovingState& so, double t) const {
    const Vec3 normal = sr.arm(d.local), normal_rate = sr.turn.spin.cross(normal);
    const Vec3 relative_a = other.motion.a - reference.motion.a;
    const double offset = d.support + reference.shape.radius + other.shape.radius, left = end_ - t;
    const double turn = sr.w_max, turn_rate = turn * turn + sr.w_rate;
    const double away = (so.x - sr.x).norm(), speed = (so.v - sr.v).norm() + relative_a.norm() * left;
    // The horizon limits the growth of the lever of a turning normal.
    const auto bounds_of = [&](double arm, double lever) {
      Bounds b{left, speed + so.w_max * arm, so.bend(arm)};
      if (sr.turns() && b.speed > 0) b.horizon = std::min(left, (lever + search_.size) / b.speed);
      b.acceleration += sr.turns() ? relative_a.norm() : std::max(0.0, -normal.dot(relative_a));
      return b;
    };
    const double greatest = other.shape.bound;
    const Bounds of_all = bounds_of(greatest, std::max(0.0, away - greatest));
    const double bend = bend_of(turn, turn_rate, away + greatest, of_all);
    const Heights heights(normal, normal_rate, so, sr.x, sr.v);
    const Counts of_held = search_.held.counts(Hold::exactly, t);
    double least = forever;
    for (int j = 0; j < static_cast<int>(other.shape.points.size()) && least > 0; ++j) {
      const Vec3& p = other.shape.points[j];
      const double gap = heights.of(p) - offset, slope = heights.rate(p), time = std::min(least, left);
      if (time <= of_all.horizon && stays_open(gap + margin(), slope, bend, time)) continue;
      const Supports supports = supports_of(d, normal, reference, sr, so, j);
      if (supports.held > -forever && of_held == Counts::never && supports.free == -forever &&
          !supports.drifts)
        continue;
      const Vec3 arm = so.arm(p);
      const double lever = (so.x + arm - sr.x).norm();
      const Bounds bounds = bounds_of(arm.norm(), lever);
      const auto see = [&](double support, Counts counts) {
        least = std::min(least, point_lasts(gap + (d.support - support), slope, lever, turn, turn_rate,
                                            bounds, counts, t));
      };
      if (supports.free > -forever) see(supports.free, Counts::fully);
      if (supports.held > -forever && of_held != Counts::never) see(supports.held, of_held);
      if (supports.drifts && of_held == Counts::never)
        least = std::min(least, within(drift_time(sr, so, bounds.speed), left, forever));
    }
    return least;
  }

  /// How long the cross product of two edges separates the pair [s].
  double edges_last(const Direction& d, const MovingState& sa, const MovingState& sb, double t) const {
    const Contactor3::Edge &ea = a_.shape.edges[d.edge_a], &eb = b_.shape.edges[d.edge_b];
    const auto along = [](const Moving3& c, const MovingState& s, const Contactor3::Edge& e) {
      return s.arm((c.shape.points[e.end] - c.shape.points[e.start]).normalized());
    };
    const Vec3 e = along(a_, sa, ea), f = along(b_, sb, eb);
    const double sine = e.cross(f).norm();
    if (sine < 1e-6) return 0;
    const auto [normal, normal_rate, turn, turn_rate, valid] =
        TurningNormal::across(e, sa, f, sb, d.sign, sine);
    const Vec3 relative_a = a_.motion.a - b_.motion.a;
    const double size_a = a_.shape.bound, size_b = b_.shape.bound;
    Bounds bounds{
        end_ - t,
        (sa.v - sb.v).norm() + relative_a.norm() * (end_ - t) + sa.w_max * size_a + sb.w_max * size_b,
        sa.bend(size_a) + sb.bend(size_b) + relative_a.norm()};
    bounds.horizon = std::min(bounds.horizon, valid);
    if (bounds.speed > 0)
      bounds.horizon = std::min(bounds.horizon, ((sa.x - sb.x).norm() + search_.size) / bounds.speed);
    const double bend = bend_of(turn, turn_rate, (sa.x - sb.x).norm() + size_a + size_b, bounds);
    const Heights of_a(normal, normal_rate, sa, sb.x, sb.v), of_b(normal, normal_rate, sb, sb.x, sb.v);
    double least = within(bounds.horizon, end_ - t, forever);
    const double radii = a_.shape.radius + b_.shape.radius;
    const auto try_pair = [&](int i, int j) {
      const Vec3 &pa = a_.shape.points[i], &pb = b_.shape.points[j];
      const double gap = of_a.of(pa) - of_b.of(pb) - radii, slope = of_a.rate(pa) - of_b.rate(pb);
      if (stays_open(gap + margin(), slope, bend, std::min(least, end_ - t))) return;
      const Hold hold = held_.hold(normal, features_of(d), i, j, sa);
      Counts counts = search_.held.counts(hold, t);
      double sinking = 0;
      if (counts == Counts::never) {
        // The contact of a pill drifts from the direction; that of an edge on an edge has this normal only
        // now, so its point may sink along it by so much.
        if (hold == Hold::for_now && by_ == CoreSearch::pill)
          least = std::min(least, within(drift_time(sa, sb, bounds.speed), end_ - t, forever));
        if (hold == Hold::exactly || by_ == CoreSearch::pill) return;
        sinking = most_sinking * search_.size;
        counts = t == 0 ? Counts::from_zero : Counts::fully;
      }
      const Vec3 away = sa.x + sa.arm(pa) - sb.x - sb.arm(pb);
      least =
          std::min(least, point_lasts(gap + sinking, slope, away.norm(), turn, turn_rate, bounds, counts, t));
    };
    // The ends of the two edges are nearest. After them, most points of a cannot shorten the time, whichever
    // point of b they are compared with.
    for (const int i : {ea.start, ea.end})
      for (const int j : {eb.start, eb.end}) try_pair(i, j);
    double top = -forever, fastest = -forever;  // of b
    for (const Vec3& pb : b_.shape.points) {
      top = std::max(top, of_b.of(pb));
      fastest = std::max(fastest, of_b.rate(pb));
    }
    for (int i = 0; i < static_cast<int>(a_.shape.points.size()) && least > 0; ++i) {
      const Vec3& pa = a_.shape.points[i];
      const double gap = of_a.of(pa) - top - radii + margin(), slope = of_a.rate(pa) - fastest;
      if (stays_open(gap, slope, bend, std::min(least, end_ - t))) continue;
      for (int j = 0; j < static_cast<int>(b_.shape.points.size()) && least > 0; ++j) try_pair(i, j);
    }
    return least;
  }

  double lasts(const Direction& d, const MovingState& sa, const MovingState& sb, double t) const {
    switch (d.kind) {
      case Direction::Kind::of_a:
        return face_lasts(d, a_, sa, b_, sb, t);
      case Direction::Kind::of_b:
        return face_lasts(d, b_, sb, a_, sa, t);
      case Direction::Kind::edges:
        break;
    }
    return edges_last(d, sa, sb, t);
  }

  /// Selects the direction that separates longest. Returns for how long [s]; 0 if no direction separates.
  double longest(const MovingState& sa, const MovingState& sb, double t) {
    double best = 0;
    const double enough = end_ - t;
    const auto try_direction = [&](const Direction& candidate) {
      if (best >= enough) return;
      if (const double time = lasts(candidate, sa, sb, t); time > best) best = time, direction_ = candidate;
    };
    const auto try_face = [&](const Moving3& c, Direction::Kind kind, int f) {
      try_direction(face_direction(c, kind, f));
    };
    const auto try_faces = [&](const Moving3& c, Direction::Kind kind) {
      for (int f = 0; f < static_cast<int>(c.shape.faces.size()); ++f) try_face(c, kind, f);
    };
    const Placed3 a{a_.shape, {sa.x, sa.turn.rotation}}, b{b_.shape, {sb.x, sb.turn.rotation}};
    if (by_ != CoreSearch::hull) {
      if (b_.facet && by_ == CoreSearch::pill) try_faces(b_, Direction::Kind::of_b);
      if (best < enough) try_nearest(a, sa, b, sb, try_direction);
      if (by_pairs_ && best <= 0) {
        try_held_edges(a, b, try_direction);
        try_faces(a_, Direction::Kind::of_a);
      }
    } else {
      try_faces(b_, Direction::Kind::of_b);
      if (!b_.facet) try_faces(a_, Direction::Kind::of_a);
      // A facet is mostly cleared by its own plane or by the face of the body that separates most. The others
      // are tried where these two soon fail.
      if (b_.facet && best < enough) {
        const OutsideFaces outside(a, b);
        try_face(a_, Direction::Kind::of_a, outside.farthest());
        for (int f = 0; f < a.faces() && best <= 0; ++f)
          if (outside.of(f) + search_.slack >= -scale_.deep || held_.is_on_ground(f))
            try_face(a_, Direction::Kind::of_a, f);
      }
      constexpr double soon = 0.1;  // of the time that is left
      const bool is_clear = b_.facet && best > soon * enough;
      if (b_.facet && !is_clear) try_held_edges(a, b, try_direction);
      const EdgeAxis axis = is_clear || best >= enough ? EdgeAxis{} : best_edge_axis(a, b);
      if (axis.of_a >= 0) try_direction(across_edges(axis, a, b));
    }
    chosen_ = true;
    return best;
  }

  /// The directions of the contacts of edges of a with edges of the facet b.
  template <class Try>
  void try_held_edges(const Placed3& a, const Placed3& b, const Try& try_direction) const {
    held_.for_edges([&](int of_a, int of_b) {
      const Vec3 outward = b_.facet->normal + b_.facet->beyond[of_b];
      try_direction(across_edges({of_a, of_b, -outward, 0}, a, b));
    });
  }

  /// The directions of the line between the nearest places of two cores. It turns with either contactor, or
  /// with both where two edges are nearest. A sphere does not take it along.
  template <class Try>
  void try_nearest(const Placed3& a, const MovingState& sa, const Placed3& b, const MovingState& sb,
                   const Try& try_direction) const {
    const Closest nearest = closest(a, b);
    if (is_ball(a) || !is_ball(b))
      try_direction(attached_direction(b_, sb, Direction::Kind::of_b, nearest.normal, nearest.of_b));
    if (!is_ball(a))
      try_direction(attached_direction(a_, sa, Direction::Kind::of_a, -nearest.normal, nearest.of_a));
    if (nearest.of_a.kind == FeatureKind::edge && nearest.of_b.kind == FeatureKind::edge)
      try_direction(across_edges({nearest.of_a.index, nearest.of_b.index, -nearest.normal, 0}, a, b));
  }

  const Moving3& a_;
  const Moving3& b_;
  double end_;
  const TouchSearch& search_;
  HeldPoints held_;
  GapScale scale_;
  std::optional<MovingState> sb_;
  Direction direction_;
  bool chosen_ = false;
  CoreSearch by_;
  bool by_pairs_;  ///< a pill touches the ground at the start: contacts hold pairs of points
};

}  // namespace

std::optional<double> advance_cores(const Moving3& a, const Moving3& b, CoreSearch by,
                                    const TimeWindow& window, const TouchSearch& search) {
  return advance(PairSearch(a, b, by, window.b, search), window, search.iterations);
}

template <CoreSearch by>
std::optional<double> core_touch(Workspace&, const Moving3& a, const Moving3& b, double t_max,
                                 const TouchSearch& search) {
  return advance_cores(a, b, by, {0, t_max}, search);
}
template FindTouch<3> core_touch<CoreSearch::ball>;
template FindTouch<3> core_touch<CoreSearch::pill>;
template FindTouch<3> core_touch<CoreSearch::hull>;

}  // namespace flyrock
