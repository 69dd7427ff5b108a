#include "geometry/contactor3.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "geometry/bound.h"
#include "geometry/ground.h"

namespace flyrock {

namespace {

// The largest allowed distance of a vertex from the plane of its face, as a share of the polyhedron's size.
constexpr double flat_share = 1e-9;

/// Twice the area of a loop times its normal (Newell).
Vec3 area_vector(const std::vector<Vec3>& points, const std::vector<int>& loop) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += (points[loop[i]] - points[loop[0]]).cross(points[loop[(i + 1) % loop.size()]] - points[loop[0]]);
  return sum;
}

void add_faces(Contactor3& shape, const std::vector<std::vector<int>>& faces) {
  for (const auto& loop : faces) {
    if (loop.size() < 3) throw std::invalid_argument("a face of a polyhedron has fewer than 3 vertices");
    if (loop.size() > Contactor3::most_face_vertices)
      throw std::invalid_argument(
          fmt::format("a face of a polyhedron has {} vertices, at most {} are possible", loop.size(),
                      Contactor3::most_face_vertices));
    const Vec3 area = area_vector(shape.points, loop);
    if (!(area.norm() > 0)) throw std::invalid_argument("a face of a polyhedron has no area");
    shape.faces.push_back(
        {area.normalized(), static_cast<int>(shape.loop.size()), static_cast<int>(loop.size())});
    shape.loop.insert(shape.loop.end(), loop.begin(), loop.end());
  }
}

/// Each edge belongs to two faces, which pass it in opposite directions.
void add_edges(Contactor3& shape) {
  std::map<std::pair<int, int>, int> edge_of;  // by (start, end) of its left face
  shape.loop_edge.assign(shape.loop.size(), -1);
  for (int f = 0; f < static_cast<int>(shape.faces.size()); ++f) {
    const Contactor3::Face& face = shape.faces[f];
    for (int i = 0; i < face.count; ++i) {
      const int a = shape.vertex(face, i), b = shape.vertex(face, (i + 1) % face.count);
      const auto other = edge_of.find({b, a});
      int edge = static_cast<int>(shape.edges.size());
      if (other != edge_of.end()) {
        edge = other->second;
        shape.edges[edge].right = f;
      } else {
        shape.edges.push_back({a, b, f, -1});
      }
      if (!edge_of.insert({{a, b}, edge}).second)
        throw std::invalid_argument("two faces of a polyhedron run through an edge in one direction");
      shape.loop_edge[face.first + i] = edge;
    }
  }
  for (const Contactor3::Edge& edge : shape.edges)
    if (edge.right < 0) throw std::invalid_argument("the faces of a polyhedron do not close");
  if (shape.edges.size() > Contactor3::most_edges)
    throw std::invalid_argument(fmt::format("a polyhedron has {} edges, at most {} are possible",
                                            shape.edges.size(), Contactor3::most_edges));
}

/// The radius of the smallest sphere about the origin that contains a contactor.
double extent_of(const Contactor3& shape) {
  double bound = bound_of(shape.points, shape.radius);
  for (const Contactor3::Circle& circle : shape.circles)
    bound = std::max(bound, std::hypot(circle.axis.dot(circle.centre),
                                       circle.across(circle.centre).norm() + circle.radius) +
                                shape.radius);
  return bound;
}

}  // namespace

Vec3 Contactor3::Circle::towards(const Vec3& direction) const {
  constexpr double level = 1e-9;  // sine of the angle between the axis and the direction
  const Vec3 out = across(direction);
  const double length = out.norm();
  return length > level * direction.norm() ? Vec3(out / length) : axis.unitOrthogonal();
}

Vec3 Contactor3::support(const Vec3& direction) const {
  double most = -infinite;
  Vec3 best = Vec3::Zero();
  const auto see = [&](const Vec3& place) {
    if (const double along = direction.dot(place); along > most) most = along, best = place;
  };
  for (const Vec3& point : points) see(point);
  for (const Circle& circle : circles) {
    constexpr double level = 1e-15;  // sine of the angle between the axis and the direction
    const Vec3 out = circle.across(direction);
    const double length = out.norm();
    see(length > level * direction.norm() ? Vec3(circle.centre + circle.radius / length * out)
                                          : circle.centre);
  }
  return best;
}

Contactor3 Contactor3::cylinder(double radius, double height) {
  Contactor3 shape;
  shape.form = Form::smooth;
  for (const double side : {-1.0, 1.0})
    shape.circles.push_back({{0, 0, 0.5 * side * height}, {0, 0, side}, radius});
  shape.bound = extent_of(shape);
  return shape;
}

Contactor3 Contactor3::hollow_cylinder(double radius, double outer, double height) {
  Contactor3 shape = cylinder(radius, height);
  shape.form = Form::hollow;
  shape.outer = outer;
  shape.bound = std::hypot(outer, 0.5 * height);
  return shape;
}

Contactor3 Contactor3::half_space() {
  constexpr double beyond_all = 1e6;  // m; no place is farther than 100 km from the origin
  Contactor3 shape;
  shape.form = Form::half_space;
  shape.points = {Vec3::Zero()};
  shape.bound = beyond_all;
  return shape;
}

Contactor3 Contactor3::solid(Mesh mesh) {
  Contactor3 shape;
  shape.form = Form::outline;
  shape.bound = bound_of(mesh.vertices, 0);
  shape.ground = make_ground(std::move(mesh));
  const Box3& box = shape.ground->extent();
  for (int i = 0; i < 8; ++i)
    shape.points.emplace_back((i & 1 ? box.high : box.low).x(), (i & 2 ? box.high : box.low).y(),
                              (i & 4 ? box.high : box.low).z());
  return shape;
}

Contactor3 Contactor3::cloud(const Mesh& mesh) {
  if (mesh.vertices.size() > most_edges)
    throw std::invalid_argument(
        fmt::format("{} vertices, at most {} are possible", mesh.vertices.size(), most_edges));
  Contactor3 shape;
  shape.form = Form::cloud;
  shape.points = mesh.vertices;
  shape.skin = mesh.triangles;
  shape.bound = bound_of(shape.points, 0);
  return shape;
}

Contactor3 Contactor3::sphere(double radius, const Vec3& centre) {
  Contactor3 shape;
  shape.points = {centre};
  shape.radius = radius;
  shape.bound = bound_of(shape.points, radius);
  return shape;
}

Contactor3 Contactor3::pill(const Vec3& start, const Vec3& end, double radius) {
  Contactor3 shape;
  shape.form = Form::pill;
  shape.points = {start, end};
  shape.edges = {{.start = 0, .end = 1, .left = -1, .right = -1}};
  shape.radius = radius;
  shape.bound = bound_of(shape.points, radius);
  return shape;
}

Contactor3 Contactor3::box(const Vec3& size) {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i)
    points.push_back(0.5 * size.cwiseProduct(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
  return polyhedron(std::move(points),
                    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}});
}

Contactor3 Contactor3::polyhedron(std::vector<Vec3> points, const std::vector<std::vector<int>>& faces) {
  Contactor3 shape;
  shape.form = Form::hull;
  shape.points = std::move(points);
  add_faces(shape, faces);
  add_edges(shape);
  const double size = Box3::around(shape.points).size().norm();
  for (const Face& face : shape.faces)
    for (const Vec3& p : shape.points)
      if (face.normal.dot(p - shape.points[shape.vertex(face, 0)]) > flat_share * size)
        throw std::invalid_argument("a polyhedron is not convex");
  shape.bound = bound_of(shape.points, 0);
  return shape;
}

std::optional<Vec3> Contactor3::axis_of_revolution() const {
  if (circles.empty()) return std::nullopt;
  constexpr double rounding = 1e-12;
  const Vec3& axis = circles.front().axis;
  const auto on_axis = [&](const Vec3& p) { return p.cross(axis).norm() <= rounding * bound; };
  for (const Vec3& point : points)
    if (!on_axis(point)) return std::nullopt;
  for (const Circle& circle : circles)
    if (!on_axis(circle.centre) || circle.axis.cross(axis).norm() > rounding) return std::nullopt;
  return axis;
}

void Contactor3::change_frame(const Vec3& origin, const Rotation3& r) {
  if (form == Form::outline) throw std::logic_error("an outline keeps its frame");
  for (Vec3& point : points) point = r.inverse(point - origin);
  for (Face& face : faces) face.normal = r.inverse(face.normal);
  for (Circle& circle : circles) {
    circle.centre = r.inverse(circle.centre - origin);
    circle.axis = r.inverse(circle.axis);
  }
  if (!is_hollow(form)) bound = extent_of(*this);  // these stay about the origin
}

void Contactor3::scale(double factor) {
  if (form == Form::outline) throw std::logic_error("an outline keeps its size");
  for (Vec3& point : points) point *= factor;
  for (Circle& circle : circles) {
    circle.centre *= factor;
    circle.radius *= factor;
  }
  for (double* length : {&radius, &bound, &outer}) *length *= factor;
}

}  // namespace flyrock
