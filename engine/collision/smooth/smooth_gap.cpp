// Gaps of known features where one contactor has circles.
#include <algorithm>
#include <limits>
#include <optional>

#include "collision/rules.h"
#include "collision/smooth/facing_pair.h"

namespace flyrock {

namespace {

constexpr double closed_share = 1e-9;  // of the size: features that are nearer touch

/// The place of a vertex or of a rim that faces a direction, if the feature is one.
std::optional<Vec3> place_of(const Placed3& shape, FeatureId feature, const Vec3& direction) {
  const int i = index_of(feature);
  if (kind_of(feature) == FeatureKind::vertex) return shape.point(i);
  if (kind_of(feature) == FeatureKind::face || shape.shape.circles.empty() || place_of_rim(i) >= rim_places)
    return std::nullopt;
  return rim_place(shape, i, direction);
}

/// The plane of a face or cap: a place on it and its normal.
struct FacePlane {
  Vec3 at, normal;
};
std::optional<FacePlane> plane_of(const Placed3& shape, FeatureId feature) {
  if (kind_of(feature) != FeatureKind::face) return std::nullopt;
  const int i = index_of(feature);
  if (shape.shape.circles.empty()) return FacePlane{shape.corner(i, 0), shape.normal(i)};
  if (i == side_face) return std::nullopt;
  const Contactor3::Circle& circle = shape.shape.circles[i];
  return FacePlane{shape.pose * circle.centre, shape.pose.r * circle.axis};
}

/// Whether a feature is the place where a rim crosses something.
bool is_crossing(const Placed3& shape, FeatureId feature) {
  return !shape.shape.circles.empty() && kind_of(feature) == FeatureKind::edge &&
         place_of_rim(index_of(feature)) >= rim_places;
}

/// The gap of the contact that has these features, if there is one.
std::optional<double> gap_of_contact(Workspace& work, const Placed3& a, FeatureId feature, const Placed3& b,
                                     FeatureId against) {
  work.found.clear();
  smooth_contacts(work, a, b, std::numeric_limits<double>::infinity(), 0, work.found);
  for (const ContactPoint<3>& c : work.found)
    if (c.feature == feature && c.against == against) return c.gap;
  return std::nullopt;
}

/// The height of a vertex, or of the place of a rim that faces a plane, over this plane.
std::optional<double> over_plane(const Placed3& shape, FeatureId feature,
                                 const std::optional<FacePlane>& plane) {
  if (!plane) return std::nullopt;
  const auto place = place_of(shape, feature, -plane->normal);
  if (!place) return std::nullopt;
  return plane->normal.dot(*place - plane->at);
}

}  // namespace

double smooth_gap(Workspace& work, const Placed3& a, FeatureId feature, const Placed3& b, FeatureId against,
                  const Vec3& near) {
  for (const auto& height :
       {over_plane(a, feature, plane_of(b, against)), over_plane(b, against, plane_of(a, feature))})
    if (height) return *height - a.shape.radius - b.shape.radius;
  const double radii = a.shape.radius + b.shape.radius;
  // Features that are apart may have passed the contact on to others, whose gap is smaller.
  const double closed = closed_share * std::min(a.shape.bound, b.shape.bound);
  if (const auto distance = distance_of_features(a, feature, b, against, near);
      distance && *distance - radii <= closed)
    return *distance - radii;
  if (is_crossing(a, feature) || is_crossing(b, against))
    if (const auto gap = gap_of_contact(work, a, feature, b, against)) return *gap;
  const FacingPair pair = facing_pair(a, b);
  const Vec3& normal = pair.apart.normal;
  if (const auto of_a = place_of(a, feature, -normal)) return normal.dot(*of_a - b.support(normal)) - radii;
  const auto of_b = place_of(b, against, normal);
  if (!of_b) return pair.apart.distance - radii;
  if (pair.of_a.is_plane())  // over a face or cap
    return pair.of_a.normal.dot(*of_b - place_on(pair.of_a)) - radii;
  return normal.dot(a.support(-normal) - *of_b) - radii;
}

Placed3 edge_piece(Workspace& work, const Facet& facet, int rim) {
  work.edge.points[1] = facet.along(rim);
  work.edge.bound = facet.along(rim).norm();
  return {work.edge, {facet.corner[rim], {}}};
}

Placed3 vertex_piece(const Vec3& at) {
  static const Contactor3 point = Contactor3::sphere(0);
  return {point, {at, {}}};
}

double smooth_gap_to_ground(Workspace& work, const Placed3& contactor, FeatureId feature,
                            const Ground3& ground, FeatureId against, const Vec3& near) {
  const Facet f = ground.facet(ground.facet_of(against));
  if (kind_of(against) == FeatureKind::face)
    return f.distance(*place_of(contactor, feature, -f.normal)) - contactor.shape.radius;
  if (kind_of(against) == FeatureKind::vertex)
    return smooth_gap(work, contactor, feature, vertex_piece(ground.vertex(ground_index(against))),
                      feature_id(0, FeatureKind::vertex, 0), near);
  return smooth_gap(work, contactor, feature,
                    edge_piece(work, f, static_cast<int>(ground_index(against) % 3)),
                    feature_id(0, FeatureKind::edge, 0), near);
}

}  // namespace flyrock
