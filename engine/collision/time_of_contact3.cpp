#include <algorithm>
#include <array>

#include "collision/advance3.h"
#include "collision/along_path.h"
#include "collision/cloud_touch.h"
#include "collision/facet_region.h"
#include "collision/feature_gap.h"
#include "collision/piece_heights.h"
#include "collision/room_search.h"
#include "collision/round_path.h"
#include "collision/surface.h"
#include "collision/terrain_contact.h"
#include "collision/time_of_contact.h"
#include "math/polynomial.h"

namespace flyrock {

namespace {

// A contact of a pill that has opened by more than this share of the size is not held any more.
constexpr double opened_share = 1e-4;

/// Whether the contactor is a sphere centred at the body's centre of mass.
bool rolls(const Contactor3& contactor) { return contactor.round() && contactor.points[0].isZero(); }

/// The times of touch of a sphere with facets, edges and peaks: roots of polynomials of degree 2, 4 and 4.
class BallSearch {
 public:
  BallSearch(double radius, FeatureId feature, const Motion3& motion, const Ground3& ground, double end,
             const TouchSearch& search)
      : radius_(radius), feature_(feature), motion_(motion), ground_(ground), end_(end), search_(search) {
    seen_.clear();
  }

  void facet(const Facet& f, const TimeWindow& window, std::optional<double>& first) const {
    if (search_.iterations) ++*search_.iterations;
    plane(f, window, first);
    if (f.unbounded || radius_ == 0) return;  // a point meets a facet first
    for (int i = 0; i < 3; ++i) {
      if (f.rim[i] == Rim::convex && f.names_edge(i)) edge(f, i, window, first);
      peak(f, i, first);
    }
  }

 private:
  static constexpr double generous = 1e-6;  // rad or share: regions of neighbours overlap, and none is missed

  bool solved(FeatureId against, bool& held) const {
    held = search_.holds(feature_, against);
    return held && search_.held_are_solved;
  }

  void plane(const Facet& f, const TimeWindow& window, std::optional<double>& first) const {
    bool held = false;
    if (solved(f.face_feature(), held)) return;
    const std::array<double, 3> gap{search_.start_gap(f.distance(motion_.x) - radius_, held),
                                    f.normal.dot(motion_.v), 0.5 * f.normal.dot(motion_.a)};
    const auto t = first_approach(gap, window.a, window.b);
    if (!t || (first && *t >= *first)) return;
    if (f.unbounded || over(f, *t)) {
      first = t;
      return;
    }
    // A sphere that has sunk into the neighbour of a concave rim, if only by rounding, is below the plane of
    // this facet when it comes over it.
    for (int i = 0; i < 3; ++i) {
      if (f.rim[i] != Rim::concave) continue;
      const Vec3 outward = f.along(i).cross(f.normal);
      const std::array<double, 3> outside{outward.dot(motion_.x - f.corner[i]), outward.dot(motion_.v),
                                          0.5 * outward.dot(motion_.a)};
      const auto enters = first_fall(outside, *t, first ? std::min(*first, window.b) : window.b);
      if (enters && evaluate(gap, *enters) <= 0 && over(f, *enters)) first = enters;
    }
  }

  /// Whether the sphere is over a facet, and not far below it: then it is free, above another part of the
  /// ground.
  bool over(const Facet& f, double t) const {
    const Vec3 at = motion_.position(t);
    if (radius_ == 0) return point_over(f, t, at);
    return f.distance(at) >= -generous * search_.size &&
           strip_contains(f, at, generous * radius_, region_slack);
  }

  /// The same for a point. Where it has sunk into the ground, the strip is longer at concave rims, because
  /// the point meets the plane before it reaches the strip.
  bool point_over(const Facet& f, double t, const Vec3& at) const {
    constexpr double least_turn = 0.01;  // rad, at a rim; flatter ones are passed
    const double shallow = shallow_share * search_.size, height = f.distance(at);
    if (height < -shallow) return false;
    double sunk = shallow;
    bool is_free = height < -generous * search_.size;
    if (is_free || !strip_contains(f, at, sunk, region_slack)) {
      const double depth = ground_.depth(at);
      is_free = is_free && depth <= 0;
      if (depth <= point_sinks(motion_, t, search_)) sunk = std::max(sunk, depth / least_turn);
    }
    return !is_free && strip_contains(f, at, sunk, region_slack);
  }

  void edge(const Facet& f, int i, const TimeWindow& window, std::optional<double>& first) const {
    bool held = false;
    if (solved(f.edge_feature(i), held)) return;
    const double length = f.along(i).norm();
    const Vec3 along = f.along(i) / length, away = motion_.x - f.corner[i];
    const auto across = [&](const Vec3& v) -> Vec3 { return v - along.dot(v) * along; };
    const Path<3> relative{across(away), across(motion_.v), across(motion_.a)};
    const auto gap = ball_gap(relative, radius_, search_.start_gap(relative.x.norm() - radius_, held));
    touch(gap, window, first, [&](double t) {
      const Vec3 at = motion_.position(t) - f.corner[i];
      const double share = at.dot(along) / length;
      return share >= -generous && share <= 1 + generous &&
             rim_cone_contains(f, i, across(at).normalized(), generous);
    });
  }

  void peak(const Facet& f, int i, std::optional<double>& first) const {
    if (std::find(seen_.begin(), seen_.end(), f.vertex[i]) != seen_.end()) return;
    seen_.push_back(f.vertex[i]);
    const Vec3& top = f.corner[i];
    const TimeWindow window = meeting_window<3>(motion_, radius_ * (1 + generous), {top, top},
                                                first ? std::min(*first, end_) : end_);
    bool held = false;
    edges_.clear();
    if (window.empty() || solved(f.vertex_feature(i), held) || !ground_.peak(f.vertex[i], edges_)) return;
    const Path<3> relative{motion_.x - top, motion_.v, motion_.a};
    const auto gap = ball_gap(relative, radius_, search_.start_gap(relative.x.norm() - radius_, held));
    touch(gap, window, first,
          [&](double t) { return peak_cone_contains(edges_, relative.position(t).normalized(), generous); });
  }

  /// The first fall of a gap at which the sphere is in the region of the feature. After a fall outside of it,
  /// the gap must open before it can close there.
  template <class Inside>
  static void touch(const std::array<double, 5>& gap, const TimeWindow& window, std::optional<double>& first,
                    const Inside& inside) {
    std::array<double, 5> opposite;
    std::transform(gap.begin(), gap.end(), opposite.begin(), std::negate());
    const double end = first ? std::min(*first, window.b) : window.b;
    for (double from = window.a; from < end;) {
      const auto t = first_approach(gap, from, end);
      if (!t) return;
      if (inside(*t)) {
        if (!first || *t < *first) first = t;
        return;
      }
      const auto opens = first_fall(opposite, std::nextafter(*t, end), end);
      if (!opens || *opens <= from) return;
      from = *opens;
    }
  }

  double radius_;
  FeatureId feature_;
  const Motion3& motion_;
  const Ground3& ground_;
  double end_;
  const TouchSearch& search_;
  std::vector<std::uint64_t>& seen_ = vertex_buffer();
  std::vector<Vec3>& edges_ = edge_buffer();

  static std::vector<std::uint64_t>& vertex_buffer() {
    thread_local std::vector<std::uint64_t> seen;  // keeps its memory between calls
    return seen;
  }
  static std::vector<Vec3>& edge_buffer() {
    thread_local std::vector<Vec3> edges;
    return edges;
  }
};

/// The contacts that exist at the start, with the vertices of their features. Valid until the next call.
const std::vector<HeldOnGround>& held_on(const Ground3& ground, std::span<const HeldContact> held) {
  thread_local std::vector<HeldOnGround> found;  // keeps its memory between calls
  found.clear();
  for (const HeldContact& contact : held) {
    HeldOnGround on{contact.feature, contact.against, contact.opened, contact.yields, {}, 1};
    if (kind_of(contact.against) == FeatureKind::vertex) {
      on.vertex[0] = ground_index(contact.against);
      on.place = ground.vertex(on.vertex[0]);
    } else {
      const Facet facet = ground.facet(ground.facet_of(contact.against));
      const int rim = static_cast<int>(ground_index(contact.against) % 3);
      on.vertex = facet.vertex;
      on.vertices = 3;
      on.normal = facet.normal;
      on.place = facet.corner[0];
      if (kind_of(contact.against) == FeatureKind::edge) {
        on.vertex = {facet.vertex[rim], facet.vertex[Facet::next(rim)]};
        on.vertices = 2;
        on.place = facet.corner[rim];
        on.along = facet.along(rim);
      }
    }
    found.push_back(on);
  }
  return found;
}

/// The contacts of a search without those of a pill that have opened: its axis may leave an edge and come
/// back to it elsewhere, which is a new touch. Valid until the next call.
std::span<const HeldContact> still_held(const MovingContactor& c, const Ground3& ground,
                                        const TouchSearch& search) {
  if (c.shape.has_faces() || c.shape.round()) return search.held;
  thread_local std::vector<HeldContact> closed;  // keeps its memory between calls
  closed.clear();
  const Placed3 start{c.shape, {c.motion.x, c.motion.turn(0).rotation}};
  for (const HeldContact& h : search.held)
    if (contactor_of(h.feature) != c.index ||
        feature_gap(start, h.feature, ground, h.against) <= opened_share * search.size)
      closed.push_back(h);
  return closed;
}

/// The first touch of a contactor that moves by `travel` at most, a small part of its size. Only the facets
/// in its box matter, and of these the ones whose planes it does not surely stay above.
template <class See>
std::optional<double> near_start(const Ground3& ground, const MovingContactor& c, double travel, double end,
                                 const TouchSearch& search, const See& see) {
  const MovingState start(c, 0, end);
  Box3 box{c.motion.x, c.motion.x};
  for (const Vec3& point : c.shape.points) {
    const Vec3 place = start.x + start.arm(point);
    box = &point == &c.shape.points.front() ? Box3{place, place}
                                            : Box3{box.low.cwiseMin(place), box.high.cwiseMax(place)};
  }
  if (c.shape.has_circles()) box = core_box({c.shape, {start.x, start.turn.rotation}});
  const double grow = c.shape.radius + travel + 1e-6 * c.shape.bound;
  box.low.array() -= grow;
  box.high.array() += grow;
  thread_local std::vector<Facet> facets;  // keeps its memory between calls
  facets.clear();
  ground.facets(box, facets);
  thread_local std::vector<PieceHeight> pieces;
  std::optional<double> first;
  for (const Facet& facet : facets) {
    const Heights heights(facet.normal, Vec3::Zero(), start, facet.corner[0], Vec3::Zero());
    const double bend = std::max(0.0, -facet.normal.dot(c.motion.a)) + start.bend(c.shape.bound);
    const double room = search.slack - c.shape.radius - 1e-9 * search.size;
    const auto& points = c.shape.points;
    const bool clear = std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
      return stays_open(heights.of(p) + room, heights.rate(p), bend, first.value_or(end));
    });
    const double until = first.value_or(end);
    piece_heights(c.shape, heights, pieces);
    const bool circles_clear = std::all_of(pieces.begin() + points.size(), pieces.end(), [&](const auto& p) {
      return p.at(0) + room > 0 && p.at(until) + room - 0.5 * until * until * bend > 0;  // it is concave
    });
    if (facet.unbounded || !clear || !circles_clear) see(facet, {0, first.value_or(end)}, first);
  }
  return first;
}

}  // namespace

std::optional<double> time_of_contact(const Contactor3& contactor, int contactor_index, const Motion3& motion,
                                      const Ground3& ground, double t_max, const TouchSearch& search) {
  if (contactor.is_room()) return std::nullopt;
  const double reach =
      contactor.bound * (1 + 1e-6);  // rounding must not exclude a facet that is just touched
  if (rolls(contactor)) {
    const BallSearch ball(contactor.radius, feature_id(contactor_index, FeatureKind::vertex, 0), motion,
                          ground, t_max, search);
    return along_path(ground, motion, reach, t_max,
                      [&](const Facet& facet, const TimeWindow& window, std::optional<double>& first) {
                        ball.facet(facet, window, first);
                      });
  }
  const MovingContactor moving{contactor, motion, contactor_index};
  const auto first_touch = [&](const auto& see) {
    if (const double travel = greatest_travel(motion, contactor.bound, t_max); travel < 0.25 * reach)
      return near_start(ground, moving, travel, t_max, search, see);
    return along_path(ground, motion, reach, t_max, see);
  };
  if (contactor.is_cloud())
    return first_touch([&](const Facet& facet, const TimeWindow& window, std::optional<double>& first) {
      const auto t = advance_cloud_to_facet(moving, facet, window, search);
      if (t && (!first || *t < *first)) first = t;
    });
  TouchSearch of_this = search;
  of_this.held = still_held(moving, ground, search);
  const auto& held = held_on(ground, of_this.held);
  return first_touch([&](const Facet& facet, const TimeWindow& window, std::optional<double>& first) {
    const auto t = advance_to_facet(moving, facet, held, window, of_this);
    if (t && (!first || *t < *first)) first = t;
  });
}

std::optional<double> time_of_contact(const Contactor3& a, int a_index, const Motion3& a_motion,
                                      const Contactor3& b, int b_index, const Motion3& b_motion, double t_max,
                                      const TouchSearch& search) {
  if (a.is_surface() || b.is_surface())
    return surface_touch<3>(a, a_index, a_motion, b, b_index, b_motion, t_max, search);
  if (!a.meets(b)) return std::nullopt;
  if (a.is_room() || b.is_room())
    return advance_in_room(MovingContactor{a, a_motion, a_index}, MovingContactor{b, b_motion, b_index},
                           {0, t_max}, search);
  if (!rolls(a) || !rolls(b))
    return advance_to_contact({a, a_motion, a_index}, {b, b_motion, b_index}, {0, t_max}, search);
  const bool held =
      search.holds(feature_id(a_index, FeatureKind::vertex, 0), feature_id(b_index, FeatureKind::vertex, 0));
  if (held && search.held_are_solved) return std::nullopt;
  const Path<3> relative{a_motion.x - b_motion.x, a_motion.v - b_motion.v, a_motion.a - b_motion.a};
  const double radii = a.radius + b.radius;
  if (radii == 0) return std::nullopt;  // two points
  const auto gap = ball_gap(relative, radii, search.start_gap(relative.x.norm() - radii, held));
  if (search.iterations) ++*search.iterations;
  return first_approach(gap, 0, t_max);
}

}  // namespace flyrock
