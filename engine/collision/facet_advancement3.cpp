// Time of impact of a moving contactor with a facet of the ground.

#include <algorithm>
#include <array>
#include <limits>

#include "collision/advance3.h"
#include "collision/circle_search.h"
#include "collision/safe_time.h"
#include "geometry/bound.h"

namespace flyrock {

namespace {

class PlaneSearch {
 public:
  PlaneSearch(const MovingContactor& c, const Facet& plane, double end, const TouchSearch& search)
      : c_(c), plane_(plane), end_(end), search_(search), scale_(search.size), ball_(c.shape.bound) {}

  /// How long all vertices stay clear of the plane, from t on [s].
  double lasts(double t) const {
    const MovingState s(c_, t, end_);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < static_cast<int>(c_.shape.points.size()) && least > 0; ++i) {
      const bool held = search_.holds(feature_id(c_.index, FeatureKind::vertex, i), plane_.face_feature());
      if (held && search_.held_are_solved) continue;
      const Vec3 arm = s.arm(c_.shape.points[i]);
      const double gap = plane_.distance(s.x + arm) - c_.shape.radius + search_.slack;
      const double slope = plane_.normal.dot(s.velocity_at(arm));
      const double bend = std::max(0.0, -plane_.normal.dot(c_.motion.a)) + s.bend(arm.norm());
      least = std::min(least, safe_time(gap, slope, bend, scale_, held && t == 0));
    }
    return least;
  }

  /// The height of the contactor's bounding ball over the plane, as a polynomial of t.
  std::array<double, 3> clearance() const {
    return {plane_.distance(c_.motion.x) - ball_ + search_.slack, plane_.normal.dot(c_.motion.v),
            0.5 * plane_.normal.dot(c_.motion.a)};
  }

 private:
  const MovingContactor& c_;
  const Facet& plane_;
  double end_;
  const TouchSearch& search_;
  GapScale scale_;
  double ball_;
};

/// A facet as a polyhedron of two faces. Where it has an open rim, it reaches as far beyond as a contactor of
/// this size can, because the ground continues there.
class FlatPolyhedron {
 public:
  FlatPolyhedron() {
    shape_.points.resize(3);
    shape_.loop = {0, 1, 2, 0, 2, 1};
    shape_.loop_edge = {0, 1, 2, 2, 1, 0};
    shape_.faces = {{Vec3::UnitZ(), 0, 3}, {-Vec3::UnitZ(), 3, 3}};
    for (int i = 0; i < 3; ++i) shape_.edges.push_back({i, Facet::next(i), 0, 1});
  }

  MovingContactor of(const Facet& facet, double size) {
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
    return {shape_, rest_, 0, &facet};
  }

 private:
  Contactor3 shape_;
  Motion3 rest_;
};

}  // namespace

FeatureId MovingContactor::id(FeatureKind kind, int i) const {
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

std::optional<double> advance_to_facet(const MovingContactor& contactor, const Facet& facet,
                                       std::span<const HeldOnGround> held, const TimeWindow& window,
                                       const TouchSearch& search) {
  if (facet.unbounded && contactor.shape.has_circles()) {
    static const Contactor3 point = Contactor3::sphere(0);
    Motion3 rest;
    rest.x = facet.corner[0];
    MovingContactor ground{point, rest, 0, &facet};
    ground.held = held;
    return advance_with_circles(contactor, ground, window, search);
  }
  if (facet.unbounded)
    return advance(PlaneSearch(contactor, facet, window.b, search), window, search.iterations);
  thread_local FlatPolyhedron flat;  // keeps its memory between calls
  MovingContactor ground = flat.of(facet, contactor.shape.bound);
  ground.held = held;
  return advance_to_contact(contactor, ground, window, search);
}

}  // namespace flyrock
