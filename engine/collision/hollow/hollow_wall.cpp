#include "collision/hollow/hollow_wall.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/manifold_reduction.h"
#include "collision/rules.h"
#include "collision/smooth/support_feature.h"
#include "math/farthest_on_ellipse.h"

namespace flyrock {

namespace {

/// The index of the second place of a rim that is nearest to a round wall, in the ids of support_feature.h.
constexpr int second_place = 8;

/// The place of a rim with this index of support_feature.h.
Vec3 place_on_rim(const Placed3& other, int index, const HollowWall3& wall, const Vec3& origin) {
  if (wall.is_plane()) return rim_place(other, index, -wall.axis());
  const Ring ring = ring_of(other, other.shape.circles[circle_of_rim(index)], origin);
  const auto nearest = wall.nearest(ring);
  return origin + ring.at(place_of_rim(index) == second_place ? nearest.back() : nearest.front());
}

}  // namespace

Vec2 HollowWall2::normal(const Vec2& from) const {
  const double rho = from.norm();
  return rho > 0 ? Vec2(-from / rho) : Vec2::UnitY();
}

HollowWall3::HollowWall3(const Placed3& hollow) : plane_(hollow.shape.circles.empty()) {
  if (plane_) {
    axis_ = hollow.pose.r * Vec3::UnitZ();
    radius_ = half_ = std::numeric_limits<double>::infinity();
  } else {
    const Contactor3::Circle& end = hollow.shape.circles.front();
    axis_ = hollow.pose.r * end.axis;
    radius_ = end.radius;
    half_ = end.axis.dot(end.centre);
  }
  first_ = axis_.unitOrthogonal();
  second_ = axis_.cross(first_);
}

double HollowWall3::gap(const Vec3& from) const {
  return plane_ ? axis_.dot(from) : radius_ - (from - axis_.dot(from) * axis_).norm();
}

Vec3 HollowWall3::normal(const Vec3& from) const {
  if (plane_) return axis_;
  const Vec3 across = from - axis_.dot(from) * axis_;
  const double rho = across.norm();
  return rho > 0 ? Vec3(-across / rho) : first_;
}

boost::container::static_vector<double, 2> HollowWall3::nearest(const Ring& ring) const {
  if (plane_) return {std::atan2(-axis_.dot(ring.b), -axis_.dot(ring.a))};
  const auto flat = [&](const Vec3& v) { return Vec2(first_.dot(v), second_.dot(v)); };
  return farthest_on_ellipse(flat(ring.centre), flat(ring.a), flat(ring.b));
}

bool HollowWall3::contains(const Vec3& middle) const {
  return plane_ || (std::abs(axis_.dot(middle)) <= half_ && gap(middle) > -HollowWall2::wall_share * radius_);
}

Vec2 middle_of(const Contactor2& shape) {
  Vec2 sum = Vec2::Zero();
  for (const Vec2& point : shape.points) sum += point;
  return sum / static_cast<double>(shape.points.size());
}

Vec3 middle_of(const Contactor3& shape) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& point : shape.points) sum += point;
  for (const Contactor3::Circle& circle : shape.circles) sum += circle.centre;
  return sum / static_cast<double>(shape.points.size() + shape.circles.size());
}

Ring ring_of(const Placed3& shape, const Contactor3::Circle& circle, const Vec3& origin) {
  const Vec3 first = circle.axis.unitOrthogonal();
  return {shape.pose * circle.centre - origin, shape.pose.r * Vec3(circle.radius * first),
          shape.pose.r * Vec3(circle.radius * circle.axis.cross(first))};
}

void hollow_contacts(Workspace&, const Placed2& other, const Placed2& hollow, double reach, double,
                     Contacts<2>& out) {
  const HollowWall2 wall(hollow);
  const Vec2& origin = hollow.pose.x;
  if (!wall.contains(other.pose * middle_of(other.shape) - origin)) return;
  const double radius = other.shape.radius;
  for (int i = 0; i < other.count(); ++i) {
    const Vec2 place = other.point(i), normal = wall.normal(place - origin);
    const double gap = wall.gap(place - origin) - radius;
    if (gap <= reach)
      out.push_back({place - (radius + 0.5 * gap) * normal, normal, gap, other.vertex(i), hollow.vertex(0)});
  }
}

void hollow_contacts(Workspace&, const Placed3& other, const Placed3& hollow, double reach, double,
                     Contacts<3>& out) {
  const HollowWall3 wall(hollow);
  const Vec3& origin = hollow.pose.x;
  if (!wall.contains(other.pose * middle_of(other.shape) - origin)) return;
  const double radius = other.shape.radius;
  const std::size_t begin = out.size();
  const auto see = [&](const Vec3& place, const ShapeFeature& feature) {
    const double gap = wall.gap(place - origin) - radius;
    if (gap > reach) return false;
    const Vec3 normal = wall.normal(place - origin);
    out.push_back({place - (radius + 0.5 * gap) * normal, normal, gap, other.id(feature),
                   hollow.id({FeatureKind::face, 0})});
    return true;
  };
  for (int i = 0; i < other.count(); ++i) see(other.point(i), {FeatureKind::vertex, i});
  for (int k = 0; k < static_cast<int>(other.shape.circles.size()); ++k) {
    if (wall.is_plane()) {
      // Where a cap is level, all places of its rim are near. The first one is the nearest.
      for (int i = 0; i < rim_places; ++i) {
        const int index = rim_index(k, i);
        if (!see(rim_place(other, index, -wall.axis()), {FeatureKind::edge, index}) && i == 0) break;
      }
      continue;
    }
    const Ring ring = ring_of(other, other.shape.circles[k], origin);
    const auto nearest = wall.nearest(ring);
    for (std::size_t i = 0; i < nearest.size(); ++i)
      see(origin + ring.at(nearest[i]), {FeatureKind::edge, rim_index(k, i == 0 ? 0 : second_place)});
  }
  if (wall.is_plane()) keep_four(out, begin);
}

double hollow_gap(Workspace&, const Placed2& other, FeatureId feature, const Placed2& hollow, FeatureId,
                  const Vec2&) {
  return HollowWall2(hollow).gap(other.point(index_2d(feature)) - hollow.pose.x) - other.shape.radius;
}

double hollow_gap(Workspace&, const Placed3& other, FeatureId feature, const Placed3& hollow, FeatureId,
                  const Vec3&) {
  const HollowWall3 wall(hollow);
  const int index = index_of(feature);
  const Vec3 place = kind_of(feature) == FeatureKind::vertex
                         ? other.point(index)
                         : place_on_rim(other, index, wall, hollow.pose.x);
  return wall.gap(place - hollow.pose.x) - other.shape.radius;
}

}  // namespace flyrock
