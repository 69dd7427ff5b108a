#include "geometry/contactor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/bound.h"
#include "geometry/doubled_area.h"

namespace flyrock {

namespace {

/// Sine of the smallest angle between successive edges that counts as a corner.
constexpr double corner_sine = 1e-9;
/// Area over squared perimeter below which a polygon is a line.
constexpr double flat = 1e-12;

std::vector<Vec2> edge_normals(const std::vector<Vec2>& points) {
  std::vector<Vec2> normals;
  for (std::size_t i = 0; i < points.size(); ++i)
    normals.push_back(-perpendicular((points[(i + 1) % points.size()] - points[i]).normalized()));
  return normals;
}

/// Area and its first and second moments about one origin; sums of these are exact. The polar moment is
/// summed apart from the tensor, with its own roundings.
struct Moments {
  double area = 0;
  Vec2 first = Vec2::Zero();
  double polar = 0;
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();

  /// Adds a piece with its area, and its first, polar and second moments about its own point `at`.
  void add(double piece, const Vec2& piece_first, double piece_polar, const Eigen::Matrix2d& piece_second,
           const Vec2& at) {
    area += piece;
    first += piece_first + piece * at;
    polar += piece_polar + 2 * at.dot(piece_first) + piece * at.squaredNorm();
    second += piece_second + at * piece_first.transpose() + piece_first * at.transpose() +
              piece * at * at.transpose();
  }
};

/// The second moments of a piece with the moment `along` its axis (a unit vector) and `across` it.
Eigen::Matrix2d of_axis(double along, double across, const Vec2& axis) {
  return across * Eigen::Matrix2d::Identity() + (along - across) * axis * axis.transpose();
}

Eigen::Matrix2d of_triangle(const Vec2& a, const Vec2& b) {
  const Vec2 sum = a + b;
  return cross(a, b) / 24 * (a * a.transpose() + b * b.transpose() + sum * sum.transpose());
}

/// `sign`: -1 takes the disk away.
void add_disk(Moments& sum, double r, const Vec2& at, double sign) {
  sum.add(sign * pi * r * r, Vec2::Zero(), sign * pi * std::pow(r, 4) / 2,
          sign * pi * std::pow(r, 4) / 4 * Eigen::Matrix2d::Identity(), at);
}

/// A grown hull consists of its core, a rectangle on each edge and a sector at each corner (Steiner).
void add_contactor(Moments& sum, const Contactor2& contactor, const Vec2& origin) {
  const auto& points = contactor.points;
  const std::size_t count = points.size();
  const double r = contactor.radius;
  if (count == 1) {
    if (contactor.form == Form::hollow) add_disk(sum, contactor.outer, points[0] - origin, 1);
    return add_disk(sum, r, points[0] - origin, contactor.form == Form::hollow ? -1 : 1);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 a = points[i] - origin, b = points[(i + 1) % count] - origin;
    const double twice = cross(a, b);  // core: the triangle (origin, a, b), with its sign
    sum.add(twice / 2, twice / 6 * (a + b), twice / 12 * (a.dot(a) + a.dot(b) + b.dot(b)), of_triangle(a, b),
            Vec2::Zero());
    if (r <= 0) continue;
    const Vec2& before = contactor.normals[(i + count - 1) % count];
    const Vec2& normal = contactor.normals[i];
    const double length = (b - a).norm();
    sum.add(length * r, Vec2::Zero(), length * r * (length * length + r * r) / 12,
            of_axis(length * r * r * r / 12, length * length * length * r / 12, normal),
            (a + b + r * normal) / 2);
    const double turn = std::abs(std::atan2(cross(before, normal), before.dot(normal)));
    const double half = turn * std::pow(r, 4) / 8, skew = std::sin(turn) * std::pow(r, 4) / 8;
    const Vec2 middle = perpendicular(normal - before).normalized();
    sum.add(turn * r * r / 2, -std::pow(r, 3) / 3 * perpendicular(normal - before), turn * std::pow(r, 4) / 4,
            of_axis(half + skew, half - skew, middle), a);
  }
}

}  // namespace

Contactor2 Contactor2::disk(double radius, const Vec2& centre) {
  return {.points = {centre}, .normals = {}, .radius = radius, .bound = centre.norm() + radius};
}

Contactor2 Contactor2::hollow_disk(double radius, double outer) {
  return {.form = Form::hollow,
          .points = {Vec2::Zero()},
          .normals = {},
          .radius = radius,
          .bound = outer,
          .outer = outer};
}

Contactor2 Contactor2::outline(const std::vector<Vec2>& points) {
  const auto [low, high] = Box2::around(points);
  return {.form = Form::outline,
          .points = {low, {high.x(), low.y()}, high, {low.x(), high.y()}},
          .normals = {},
          .bound = bound_of(points, 0),
          .ground = std::make_shared<const Ground2>(Ground2::outline(points))};
}

Contactor2 Contactor2::hull(std::vector<Vec2> points, double radius) {
  auto normals = edge_normals(points);
  const double bound = bound_of(points, radius);
  const Form form = points.size() == 1 ? Form::ball : points.size() == 2 ? Form::pill : Form::hull;
  return {form, std::move(points), std::move(normals), radius, bound};
}

void Contactor2::translate(const Vec2& by) {
  if (form == Form::outline) throw std::logic_error("an outline keeps its frame");
  for (Vec2& point : points) point += by;
  bound = bound_of(points, radius);
}

void Contactor2::scale(double factor) {
  if (form == Form::outline) throw std::logic_error("an outline keeps its size");
  for (Vec2& point : points) point *= factor;
  for (double* length : {&radius, &bound, &outer}) *length *= factor;
}

std::string make_convex(std::vector<Vec2>& vertices) {
  const std::size_t count = vertices.size();
  if (count < 3) return fmt::format("a polygon has {} vertices, at least 3 are needed", count);
  if (count > Contactor2::most_vertices)
    return fmt::format("a polygon has {} vertices, at most {} are possible", count,
                       Contactor2::most_vertices);
  double perimeter = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double length = (vertices[(i + 1) % count] - vertices[i]).norm();
    if (length == 0)
      return fmt::format("a polygon has the vertex ({:.6g}, {:.6g}) twice", vertices[i].x(), vertices[i].y());
    perimeter += length;
  }
  if (std::abs(doubled_area(vertices) / 2) <= flat * perimeter * perimeter) return "the polygon has no area";
  if (doubled_area(vertices) < 0) std::reverse(vertices.begin(), vertices.end());
  double turned = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2& at = vertices[(i + 1) % count];
    const Vec2 in = at - vertices[i];
    const Vec2 out = vertices[(i + 2) % count] - at;
    const double sine = cross(in, out) / (in.norm() * out.norm());
    if (std::abs(sine) <= corner_sine && in.dot(out) > 0)
      return fmt::format(
          "the polygon's vertex ({:.6g}, {:.6g}) lies on the straight line between its neighbours; leave it "
          "out",
          at.x(), at.y());
    if (sine <= corner_sine)
      return fmt::format("the polygon is not convex at the vertex ({:.6g}, {:.6g})", at.x(), at.y());
    turned += std::atan2(cross(in, out), in.dot(out));
  }
  // A star turns left at every vertex, but it is not convex, because its edges turn around more than once.
  if (turned > 3 * pi) return "the polygon is not convex: its edges cross";
  return {};
}

AreaProperties area_properties(const std::vector<Contactor2>& contactors) {
  if (contactors.empty() || contactors.front().form == Form::outline) return {};
  // Use moments about a point of the body, so that a body drawn far from the frame's origin loses no digits.
  const Vec2 origin = contactors.front().points.front();
  Moments sum;
  for (const Contactor2& contactor : contactors) add_contactor(sum, contactor, origin);
  if (sum.area == 0) return {0, origin, 0, Eigen::Matrix2d::Zero()};
  const Vec2 centre = sum.first / sum.area;
  return {sum.area, origin + centre, sum.polar - sum.area * centre.squaredNorm(),
          sum.second - sum.area * centre * centre.transpose()};
}

double default_thickness(double area) { return 4.0 / 3.0 * std::sqrt(area / pi); }

}  // namespace flyrock
