// Contacts and times of impact of spheres in 3D. Of one about its centre of mass, they are roots of
// polynomials.
#include <algorithm>
#include <array>

#include "collision/ground/along_path.h"
#include "collision/ground/facet_region.h"
#include "collision/round_path.h"
#include "collision/rules.h"
#include "math/polynomial.h"

namespace flyrock {

namespace {

/// Whether a sphere is centred at the body's centre of mass.
bool is_centred(const Contactor3& ball) { return ball.points[0].isZero(); }

/// The times of touch of a sphere with facets, edges and peaks: roots of polynomials of degree 2, 4 and 4.
class BallSearch {
 public:
  BallSearch(Workspace& work, double radius, FeatureId feature, const Motion3& motion, const Ground3& ground,
             double end, const TouchSearch& search)
      : radius_(radius),
        feature_(feature),
        motion_(motion),
        ground_(ground),
        end_(end),
        search_(search),
        seen_(work.vertices),
        edges_(work.edges) {
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

  Counts counts(FeatureId against) const { return search_.held.counts(feature_, against, 0); }

  void plane(const Facet& f, const TimeWindow& window, std::optional<double>& first) const {
    const Counts counted = counts(f.face_feature());
    if (counted == Counts::never) return;
    const std::array<double, 3> gap{search_.start_gap(f.distance(motion_.x) - radius_, counted),
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
    const Counts counted = counts(f.edge_feature(i));
    if (counted == Counts::never) return;
    const double length = f.along(i).norm();
    const Vec3 along = f.along(i) / length, away = motion_.x - f.corner[i];
    const auto across = [&](const Vec3& v) -> Vec3 { return v - along.dot(v) * along; };
    const Path<3> relative{across(away), across(motion_.v), across(motion_.a)};
    const auto gap = ball_gap(relative, radius_, search_.start_gap(relative.x.norm() - radius_, counted));
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
    edges_.clear();
    if (window.empty()) return;
    const Counts counted = counts(f.vertex_feature(i));
    if (counted == Counts::never || !ground_.peak(f.vertex[i], edges_)) return;
    const Path<3> relative{motion_.x - top, motion_.v, motion_.a};
    const auto gap = ball_gap(relative, radius_, search_.start_gap(relative.x.norm() - radius_, counted));
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
  std::vector<std::uint64_t>& seen_;
  std::vector<Vec3>& edges_;
};

}  // namespace

void ball_contacts(Workspace&, const Placed3& a, const Placed3& b, double reach, double, Contacts<3>& out) {
  const Vec3 away = a.point(0) - b.point(0);
  const double distance = away.norm(), gap = distance - a.shape.radius - b.shape.radius;
  if (gap > reach || a.shape.radius + b.shape.radius == 0) return;  // two points do not meet
  const Vec3 normal = distance > 0 ? Vec3(away / distance) : Vec3::UnitZ();
  out.push_back({b.point(0) + (b.shape.radius + 0.5 * gap) * normal, normal, gap, a.id({}), b.id({})});
}

std::optional<double> ball_touch_of_ground(Workspace& work, const Moving3& ball, const Ground3& ground,
                                           double t_max, const TouchSearch& search) {
  if (!is_centred(ball.shape))
    return core_touch_of_ground<CoreSearch::ball>(work, ball, ground, t_max, search);
  const BallSearch roots(work, ball.shape.radius, feature_id(ball.index, FeatureKind::vertex, 0), ball.motion,
                         ground, t_max, search);
  return along_path(work, ground, ball.motion, reach_on_path(ball.shape.bound), t_max,
                    [&](const Facet& facet, const TimeWindow& window, std::optional<double>& first) {
                      roots.facet(facet, window, first);
                    });
}

std::optional<double> ball_touch(Workspace& work, const Moving3& a, const Moving3& b, double t_max,
                                 const TouchSearch& search) {
  if (!is_centred(a.shape) || !is_centred(b.shape))
    return core_touch<CoreSearch::ball>(work, a, b, t_max, search);
  const Counts counts = search.held.counts(feature_id(a.index, FeatureKind::vertex, 0),
                                           feature_id(b.index, FeatureKind::vertex, 0), 0);
  if (counts == Counts::never) return std::nullopt;
  const Path<3> relative{a.motion.x - b.motion.x, a.motion.v - b.motion.v, a.motion.a - b.motion.a};
  const double radii = a.shape.radius + b.shape.radius;
  if (radii == 0) return std::nullopt;  // two points
  const auto gap = ball_gap(relative, radii, search.start_gap(relative.x.norm() - radii, counts));
  if (search.iterations) ++*search.iterations;
  return first_approach(gap, 0, t_max);
}

}  // namespace flyrock
