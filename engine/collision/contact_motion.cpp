#include "collision/contact_motion.h"

#include <cmath>

#include "collision/contact.h"
#include "collision/rules.h"
#include "collision/smooth/support_feature.h"

namespace flyrock {

namespace {

template <int D>
using PartKind = typename TouchingPart<D>::Kind;

constexpr double least_radius = 1e-9;  // m; parts that are sharp on both sides have no common normal
// Sine of the angle between two lines. Below, they count as parallel, because the place where they cross runs
// along them faster than they are long.
constexpr double least_crossing = 0.1;

Vec2 turned_by(double w, const Vec2& v) { return cross(w, v); }
Vec3 turned_by(const Vec3& w, const Vec3& v) { return w.cross(v); }

/// The rate of the normal across `line`, as between two points.
Vec3 rate_across(const Vec3& line, const Vec3& approach, double radii, const Vec3& normal) {
  if (std::abs(radii) < least_radius) return Vec3::Zero();
  const Vec3 across = line.cross(normal);
  return across.dot(approach) / radii * across;
}

/// What a line asks of the rate of the normal: its part along the line.
double rate_along(const TouchingPart<3>& part, const Vec3& normal) {
  return -normal.dot(part.spin.cross(part.line));
}

/// The walks, from the velocity of the contact.
template <int D>
ContactMotion<D> walks(const TouchingPart<D>& a, const TouchingPart<D>& b, const Vec<D>& normal_rate,
                       const Vec<D>& velocity) {
  return {normal_rate, velocity - a.velocity, velocity - b.velocity};
}

/// One side is a plane: the contact follows the other side.
template <int D>
ContactMotion<D> on_plane(const TouchingPart<D>& a, const TouchingPart<D>& b, const Vec<D>& normal) {
  if (b.kind == PartKind<D>::plane) {
    const Vec<D> rate = turned_by(b.spin, normal), over = -a.radius * rate;
    return {rate, over, a.velocity + over - b.velocity};
  }
  const Vec<D> rate = turned_by(a.spin, normal), over = b.radius * rate;
  return {rate, b.velocity + over - a.velocity, over};
}

template <int D>
ContactMotion<D> of_points(const TouchingPart<D>& a, const TouchingPart<D>& b, const Vec<D>& normal) {
  const double radii = a.radius + b.radius;
  if (std::abs(radii) < least_radius) return {};
  const Vec<D> apart = a.velocity - b.velocity, rate = (apart - normal.dot(apart) * normal) / radii;
  return {rate, -a.radius * rate, b.radius * rate};
}

ContactMotion<3> of_lines(const TouchingPart<3>& a, const TouchingPart<3>& b, const Vec3& normal) {
  const Vec3 apart = a.velocity - b.velocity;
  const double radii = a.radius + b.radius, cosine = a.line.dot(b.line), det = 1 - cosine * cosine;
  const double along_a = rate_along(a, normal), along_b = rate_along(b, normal);
  const Vec3 rate = (along_a - cosine * along_b) / det * a.line + (along_b - cosine * along_a) / det * b.line;
  const Vec3 gained = radii * rate - apart;
  const double run = (gained.dot(a.line) - cosine * gained.dot(b.line)) / det;
  return walks<3>(a, b, rate, a.velocity + run * a.line - a.radius * rate);
}

template <int D>
bool is_plane_with_place(const TouchingPart<D>& a, const TouchingPart<D>& b) {
  return a.kind == PartKind<D>::plane || b.kind == PartKind<D>::plane;
}

}  // namespace

TouchingPart<2> hull_part(const Placed2& shape, FeatureId feature, const Vec2&) {
  using Kind = PartKind<2>;
  return {.kind = feature & 1 ? Kind::plane : Kind::point, .radius = shape.shape.radius};
}
TouchingPart<2> hollow_part(const Placed2& shape, FeatureId, const Vec2&) {
  return {.kind = PartKind<2>::point, .radius = -shape.shape.radius};
}
TouchingPart<2> outline_part(const Placed2& shape, FeatureId feature, const Vec2&) {
  return touching_part(*shape.shape.ground, feature);
}
TouchingPart<2> touching_part(const Ground2&, FeatureId feature) {
  return {.kind = is_corner(feature) ? PartKind<2>::point : PartKind<2>::plane};
}

TouchingPart<3> touching_part(const Ground3& ground, FeatureId feature) {
  using Kind = PartKind<3>;
  if (kind_of(feature) == FeatureKind::face) return {.kind = Kind::plane};
  if (kind_of(feature) == FeatureKind::vertex) return {.kind = Kind::point};
  return {.kind = Kind::line, .line = touching_line(ground, feature)->normalized()};
}

TouchingPart<3> outline_part(const Placed3& shape, FeatureId feature, const Vec3&) {
  TouchingPart<3> part = touching_part(*shape.shape.ground, feature);
  part.line = shape.pose.r * part.line;
  return part;
}

TouchingPart<3> half_space_part(const Placed3&, FeatureId, const Vec3&) {
  return {.kind = PartKind<3>::plane};
}

TouchingPart<3> hollow_part(const Placed3& shape, FeatureId, const Vec3&) {
  const Contactor3::Circle& end = shape.shape.circles.front();
  return {.kind = PartKind<3>::line, .radius = -end.radius, .line = shape.pose.r * end.axis};
}

TouchingPart<3> smooth_part(const Placed3& shape, FeatureId feature, const Vec3& normal) {
  constexpr double level = 1e-3;  // sine of the angle between a side and the line of a contact with it
  using Kind = PartKind<3>;
  const Contactor3& contactor = shape.shape;
  const int index = index_of(feature);
  const FeatureKind kind = kind_of(feature);
  if (kind == FeatureKind::vertex) return {.kind = Kind::point, .radius = contactor.radius};
  if (kind == FeatureKind::face && index != side_face)
    return {.kind = Kind::plane, .radius = contactor.radius};
  const Contactor3::Circle& circle = contactor.circles.front();
  const Vec3 axis = shape.pose.r * circle.axis;
  const bool is_side = kind == FeatureKind::face || place_of_rim(index) == 0;
  if (contactor.circles.size() < 2 || !is_side || std::abs(axis.dot(normal)) > level)
    return {.rolls = true, .radius = contactor.radius};
  return {.kind = Kind::line, .rolls = true, .radius = circle.radius + contactor.radius, .line = axis};
}

TouchingPart<3> core_part(const Placed3& shape, FeatureId feature, const Vec3& normal) {
  using Kind = PartKind<3>;
  const Contactor3& contactor = shape.shape;
  switch (kind_of(feature)) {
    case FeatureKind::face:
      return {.kind = Kind::plane, .radius = contactor.radius};
    case FeatureKind::vertex:
      return {.kind = Kind::point, .radius = contactor.radius};
    case FeatureKind::edge:
      break;
  }
  return {.kind = Kind::line,
          .radius = contactor.radius,
          .line = touching_line(shape, feature, normal)->normalized()};
}

ContactMotion<2> contact_motion(const TouchingPart<2>& a, const TouchingPart<2>& b, const Vec2& normal) {
  return is_plane_with_place<2>(a, b) ? on_plane<2>(a, b, normal) : of_points<2>(a, b, normal);
}

ContactMotion<3> contact_motion(const TouchingPart<3>& a, const TouchingPart<3>& b, const Vec3& normal) {
  using Kind = PartKind<3>;
  if (is_plane_with_place<3>(a, b)) return on_plane<3>(a, b, normal);
  if (a.kind == Kind::place || b.kind == Kind::place) return {};
  if (a.kind == Kind::point && b.kind == Kind::point) return of_points<3>(a, b, normal);
  const bool two_lines = a.kind == Kind::line && b.kind == Kind::line;
  if (two_lines && a.line.cross(b.line).norm() > least_crossing) return of_lines(a, b, normal);
  // A line with a point, or with a place on a line that is parallel to it.
  const double radii = a.radius + b.radius;
  const bool line_is_b = b.kind == Kind::line;
  const TouchingPart<3>& line = line_is_b ? b : a;
  const Vec3 rate =
      rate_across(line.line, a.velocity - b.velocity, radii, normal) + rate_along(line, normal) * line.line;
  if (line_is_b) return walks<3>(a, b, rate, a.velocity - a.radius * rate);
  return walks<3>(a, b, rate, b.velocity + b.radius * rate);
}

}  // namespace flyrock
