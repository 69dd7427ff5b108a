#include "collision/smooth/facing_pair.h"

#include <algorithm>
#include <array>

#include "collision/rules.h"

namespace flyrock {

namespace {

/// Of the size: a smaller distance counts as this in Newton's steps, which are singular at 0.
constexpr double least_share = 1e-4;

/// How the farthest place of a core moves as the direction turns: R/s t t^T for a rim and a side.
Eigen::Matrix3d give_of(const Placed3& shape, const Patch& patch, const Vec3& normal) {
  const ShapeFeature& feature = patch.places.front().feature;
  if (shape.shape.circles.empty() || feature.kind != FeatureKind::edge) return Eigen::Matrix3d::Zero();
  const Contactor3::Circle& circle = shape.shape.circles[circle_of_rim(feature.index)];
  const Vec3 tangent = (shape.pose.r * circle.axis).cross(normal);  // as long as the sine
  const double sine = tangent.norm();
  return circle.radius / (sine * sine * sine) * tangent * tangent.transpose();
}

/// One Newton step for the normal of two patches that are not plane; `with_lines`: lines stay across it.
Vec3 next_normal(const Placed3& a, const Patch& of_a, const Placed3& b, const Patch& of_b, const Vec3& n,
                 double least, bool with_lines) {
  std::array<Vec3, 2> lines;
  int count = 0;
  for (const Patch* patch : {&of_a, &of_b})
    if (with_lines && patch->kind == Patch::Kind::segment)
      lines[count++] = (patch->places[1].at - patch->places[0].at).normalized();
  Vec3 normal = n;
  if (count == 2) {
    const Vec3 across = lines[0].cross(lines[1]);
    if (across.norm() > flush_angle) return (across.dot(n) < 0 ? -1 : 1) * across.normalized();
  }
  if (count > 0) normal = (n - lines[0].dot(n) * lines[0]).normalized();
  const Vec3 between = place_on(of_a) - place_on(of_b);
  const double distance = normal.dot(between);
  Vec3 miss = between - distance * normal;
  Eigen::Matrix3d give = give_of(a, of_a, normal) + give_of(b, of_b, normal);
  give.diagonal().array() += std::max(distance, least);
  if (count == 0) {
    // Across the tangent plane the step is 0.
    give += give.trace() * normal * normal.transpose();
    return (normal + give.ldlt().solve(miss)).normalized();
  }
  const Vec3 across = lines[0].cross(normal);
  return (normal + across * (across.dot(miss) / across.dot(give * across))).normalized();
}

/// The parts that face each other along the normal of a pair.
void find_parts(const Placed3& a, const Placed3& b, FacingPair& pair, Planes planes) {
  pair.of_a = support_feature(a, -pair.apart.normal, planes);
  pair.of_b = support_feature(b, pair.apart.normal, planes);
}

/// Newton's method for the normal of a pair, until one of the parts is plane.
void make_exact(const Placed3& a, const Placed3& b, FacingPair& pair, Planes planes) {
  constexpr int most_steps = 10;
  constexpr double exact = 1e-15;
  Vec3& normal = pair.apart.normal;
  const double size = std::max(a.shape.bound, b.shape.bound);
  find_parts(a, b, pair, planes);
  for (const bool with_lines : {true, false}) {
    bool better = false;
    for (int i = 0; i < most_steps && !pair.of_a.is_plane() && !pair.of_b.is_plane(); ++i) {
      const Vec3 next = next_normal(a, pair.of_a, b, pair.of_b, normal, least_share * size, with_lines);
      const double distance = distance_along(a, b, next), turned = (next - normal).norm();
      if (!(distance >= pair.apart.distance - 1e-12 * size) || turned > 0.1) break;
      better = true;
      normal = next;
      pair.apart.distance = distance;
      find_parts(a, b, pair, planes);
      if (turned < exact) break;
    }
    if (better) break;
  }
  pair.apart.distance = distance_along(a, b, normal);
}

}  // namespace

FacingPair facing_pair(const Placed3& a, const Placed3& b) {
  FacingPair pair{separation(a, b), {}, {}, {}};
  make_exact(a, b, pair, Planes::with);
  pair.normal = pair.apart.normal;
  if (!pair.of_a.is_plane() && !pair.of_b.is_plane()) return pair;
  if (pair.of_b.is_plane()) {
    pair.normal = pair.of_b.normal;
    pair.of_a = support_feature(a, -pair.normal);
  } else {
    pair.normal = -pair.of_a.normal;
    pair.of_b = support_feature(b, pair.normal);
  }
  const double over_plane = distance_along(a, b, pair.normal),
               noise = 1e-12 * std::max(a.shape.bound, b.shape.bound);
  if (over_plane >= pair.apart.distance - noise) {
    pair.apart.normal = pair.normal;
    pair.apart.distance = over_plane;
  } else {  // a part of one core is below the plane, but beside the face or cap
    FacingPair beside{pair.apart, {}, {}, {}};
    make_exact(a, b, beside, Planes::without);
    pair.apart = beside.apart;
  }
  return pair;
}

std::optional<double> distance_of_features(const Placed3& a, FeatureId feature, const Placed3& b,
                                           FeatureId against, const Vec3& near) {
  constexpr int most_steps = 8;
  constexpr double exact = 1e-13, most_turn = 0.1;  // rad
  const double least = least_share * std::max(a.shape.bound, b.shape.bound);
  Vec3 normal = near;
  for (int i = 0; i < most_steps; ++i) {
    const auto of_a = known_feature(a, feature, -normal), of_b = known_feature(b, against, normal);
    if (!of_a || !of_b) return std::nullopt;
    const Vec3 next = next_normal(a, *of_a, b, *of_b, normal, least, true);
    const double turned = (next - normal).norm();
    if (!((next - near).norm() < most_turn)) return std::nullopt;
    normal = next;
    if (turned < exact) return normal.dot(place_on(*of_a) - place_on(*of_b));
  }
  return std::nullopt;
}

}  // namespace flyrock
