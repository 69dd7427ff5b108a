// Time of impact of a moving contactor with a facet of the ground.

#include <algorithm>
#include <array>
#include <limits>

#include "collision/advance_3d.h"
#include "collision/ground/facet_region.h"
#include "collision/pair_search.h"
#include "collision/safe_time.h"
#include "geometry/bound.h"

namespace flyrock {

namespace {

/// The points of a contactor over a facet. Of a cloud, the facet is a thin prism below its plane, which the
/// points enter from above: a point stays clear of it as long as it stays above the plane, or beyond one
/// side, or below the prism, whichever lasts longest.
class PointSearch {
 public:
  PointSearch(const Moving3& c, const Facet& facet, bool of_cloud, double end, const TouchSearch& search)
      : c_(c), facet_(facet), of_cloud_(of_cloud), end_(end), search_(search), scale_(search.size) {
    for (int i = 0; of_cloud && i < 3; ++i) outward_[i] = -facet.normal.cross(facet.along(i)).normalized();
  }

  double lasts(double t) const {
    const MovingState state(c_, t, end_);
    double least = forever;
    for (int i = 0; i < static_cast<int>(c_.shape.points.size()) && least > 0; ++i) {
      const FeatureId point = feature_id(c_.index, FeatureKind::vertex, i);
      const Counts counts = search_.held.counts(point, facet_.face_feature(), t);
      if (counts == Counts::never) continue;
      least = std::min(least, point_lasts(c_.shape.points[i], state, counts, end_ - t));
    }
    return least;
  }

  /// The height of the contactor's bounding ball over the plane, as a polynomial of t.
  std::array<double, 3> clearance() const {
    const Motion3& motion = c_.motion;
    return {facet_.distance(motion.x) - c_.shape.bound + search_.slack, facet_.normal.dot(motion.v),
            0.5 * facet_.normal.dot(motion.a)};
  }

 private:
  double point_lasts(const Vec3& point, const MovingState& state, Counts counts, double left) const {
    const Vec3 arm = state.arm(point), at = state.x + arm, speed = state.velocity_at(arm);
    const double turning = state.bend(arm.norm()), height = facet_.distance(at);
    const auto stays = [&](double gap, const Vec3& away, Counts counted) {
      return safe_time(gap, away.dot(speed), std::max(0.0, -away.dot(c_.motion.a)) + turning, scale_,
                       counted);
    };
    double most = stays(height - c_.shape.radius + search_.slack, facet_.normal, counts);
    if (!of_cloud_) return most;
    const auto try_outside = [&](double gap, const Vec3& away) {
      if (gap > 0 && most < left) most = std::max(most, stays(gap, away, Counts::fully));
    };
    try_outside(-height - scale_.deep, -facet_.normal);
    for (int i = 0; i < 3; ++i)
      if (facet_.rim[i] != Rim::open)
        try_outside(outward_[i].dot(at - facet_.corner[i]) - strip_margin(facet_, i, at, scale_.deep),
                    outward_[i]);
    return most;
  }

  const Moving3& c_;
  const Facet& facet_;
  bool of_cloud_;
  double end_;
  const TouchSearch& search_;
  GapScale scale_;
  std::array<Vec3, 3> outward_;  ///< of a cloud: unit, out of the sides
};

}  // namespace

FlatPolyhedron::FlatPolyhedron() {
  shape_.form = Form::hull;
  shape_.points.resize(3);
  shape_.loop = {0, 1, 2, 0, 2, 1};
  shape_.loop_edge = {0, 1, 2, 2, 1, 0};
  shape_.faces = {{Vec3::UnitZ(), 0, 3}, {-Vec3::UnitZ(), 3, 3}};
  for (int i = 0; i < 3; ++i) shape_.edges.push_back({i, Facet::next(i), 0, 1});
}

Moving3 FlatPolyhedron::of(const Facet& facet, double size, std::span<const HeldOnGround> held) {
  rest_.x = facet.corner[0];
  std::array<Vec3, 3> corner = facet.corner;
  for (int i = 0; i < 3; ++i) {
    if (facet.rim[i] != Rim::open) continue;
    const int j = Facet::next(i), opposite = Facet::next(j);
    const double wider = 2 * size / facet.inside(i, facet.corner[opposite]);
    for (const int end : {i, j}) corner[end] += wider * (corner[end] - corner[opposite]);
  }
  for (int i = 0; i < 3; ++i) shape_.points[i] = corner[i] - rest_.x;
  shape_.faces[0].normal = facet.normal;
  shape_.faces[1].normal = -facet.normal;
  shape_.bound = bound_of(shape_.points, 0);
  return {shape_, rest_, 0, &facet, held};
}

std::optional<double> core_touch_of_facet(Workspace& work, const Moving3& contactor, const Facet& facet,
                                          std::span<const HeldOnGround> held, CoreSearch by,
                                          const TimeWindow& window, const TouchSearch& search) {
  if (facet.unbounded)
    return advance(PointSearch(contactor, facet, false, window.b, search), window, search.iterations);
  return advance_cores(contactor, work.facet_hull.of(facet, contactor.shape.bound, held), by, window, search);
}

FeatureId Moving3::id(FeatureKind kind, int i) const {
  if (!facet) return feature_id(index, kind, i);
  switch (kind) {
    case FeatureKind::vertex:
      return facet->vertex_feature(i);
    case FeatureKind::edge:
      return facet->edge_feature(i);
    case FeatureKind::face:
      break;
  }
  return i == 0 ? facet->face_feature() : ~FeatureId{0};
}

std::optional<double> cloud_touch_of_facet(const Moving3& cloud, const Facet& facet, const TimeWindow& window,
                                           const TouchSearch& search) {
  return advance(PointSearch(cloud, facet, true, window.b, search), window, search.iterations);
}

std::optional<double> smooth_touch_of_facet(Workspace& work, const Moving3& shape, const Facet& facet,
                                            const TimeWindow& window, const TouchSearch& search) {
  if (!facet.unbounded)
    return advance_with_circles(work, shape, work.facet_hull.of(facet, shape.shape.bound, {}), window,
                                search);
  static const Contactor3 point = Contactor3::sphere(0);
  Motion3 rest;
  rest.x = facet.corner[0];
  return advance_with_circles(work, shape, {point, rest, 0, &facet, {}}, window, search);
}

}  // namespace flyrock
