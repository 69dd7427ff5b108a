#include "batch/rock_surface.h"

#include <cmath>

#include "elastic/elastic_block.h"
#include "geometry/ground.h"

namespace flyrock {

namespace {

/// A point is drawn as a small ball.
template <class Contactor>
double drawn_radius(const Contactor& contactor) {
  return contactor.form == Form::ball && contactor.radius == 0 ? contactor.bound : contactor.radius;
}

constexpr int wall_pieces = 48;  // of the wall of a drum, around its axis

/// The wall of a hollow disk, in pieces.
void add_ring(const Contactor2& contactor, int index, std::vector<SurfaceCorner>& corners) {
  const auto place = [&](double radius, int i) {
    const double angle = 2 * pi * i / wall_pieces;
    return Vec3(radius * std::cos(angle), radius * std::sin(angle), 0);
  };
  const double inner = contactor.radius, outer = contactor.outer;
  for (int i = 0; i < wall_pieces; ++i)
    for (const Vec3& corner : {place(outer, i), place(outer, i + 1), place(inner, i + 1), place(inner, i)})
      corners.push_back({index, i, corner, 0});
}

/// The solid in an outline. One that is solid outside is drawn as a frame about its box, cut open at a
/// corner.
std::vector<Vec2> counter_clockwise(const Ground2& outline) {
  constexpr double frame = 0.1;  // of the diagonal of the box
  std::vector<Vec2> points;
  for (int i = outline.segments() - 1; i > 0; --i)  // point 0 is in the middle of a segment
    points.push_back(outline.point(i));
  double twice_area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2& next = points[(i + 1) % points.size()];
    twice_area += points[i].x() * next.y() - points[i].y() * next.x();
  }
  if (twice_area > 0) return points;
  const Box2 box = Box2::around(points);
  const auto [low, high] = box.grown(frame * box.size().norm());
  points.push_back(points.front());
  points.insert(points.end(), {low, {high.x(), low.y()}, high, {low.x(), high.y()}, low});
  return points;
}

}  // namespace

std::vector<SurfaceCorner> surface_of(const std::vector<Contactor2>& contactors) {
  std::vector<SurfaceCorner> corners;
  for (int c = 0; c < static_cast<int>(contactors.size()); ++c) {
    const Contactor2& contactor = contactors[static_cast<std::size_t>(c)];
    const auto add = [&](const Vec2& at, double grown) {
      corners.push_back({c, 0, {at.x(), at.y(), 0}, grown});
    };
    if (contactor.form == Form::hollow)
      add_ring(contactor, c, corners);
    else if (contactor.form == Form::outline)
      for (const Vec2& point : counter_clockwise(*contactor.ground)) add(point, 0);
    else
      for (const Vec2& point : contactor.points) add(point, drawn_radius(contactor));
  }
  return corners;
}

namespace {

void add_triangles(const Ground3& ground, int index, std::vector<SurfaceCorner>& corners) {
  std::vector<Facet> facets;
  ground.facets(ground.extent(), facets);
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (const Vec3& corner : facets[f].corner) corners.push_back({index, static_cast<int>(f), corner, 0});
}

/// The wall of a hollow cylinder: its inside, its outside, and the ring at each end.
void add_tube(const Contactor3& contactor, int index, std::vector<SurfaceCorner>& corners) {
  const Contactor3::Circle &base = contactor.circles.front(), &top = contactor.circles.back();
  const Vec3 first = top.axis.unitOrthogonal(), second = top.axis.cross(first);
  const auto place = [&](const Contactor3::Circle& end, double radius, int i) -> Vec3 {
    const double angle = 2 * pi * i / wall_pieces;
    return end.centre + radius * (std::cos(angle) * first + std::sin(angle) * second);
  };
  const double inner = top.radius, outer = contactor.outer;
  int face = 0;
  const auto add = [&](const Contactor3::Circle& a, double ra, const Contactor3::Circle& b, double rb) {
    for (int i = 0; i < wall_pieces; ++i, ++face)
      for (const Vec3& corner : {place(a, ra, i), place(a, ra, i + 1), place(b, rb, i + 1), place(b, rb, i)})
        corners.push_back({index, face, corner, 0});
  };
  add(top, inner, base, inner);
  add(base, inner, base, outer);
  add(base, outer, top, outer);
  add(top, outer, top, inner);
}

/// A contactor with circles, drawn with polygons in their place: the caps, then the side.
void add_with_circles(const Contactor3& contactor, int index, std::vector<SurfaceCorner>& corners) {
  constexpr int sides = 32;
  const Vec3& axis = contactor.circles.front().axis;
  const Vec3 first = axis.unitOrthogonal(), second = axis.cross(first);
  const auto place = [&](const Contactor3::Circle& circle, int i) -> Vec3 {
    const double angle = 2 * pi * i / sides;
    return circle.centre + circle.radius * (std::cos(angle) * first + std::sin(angle) * second);
  };
  int face = 0;
  for (const Contactor3::Circle& circle : contactor.circles) {
    const int way = circle.axis.dot(axis) > 0 ? 1 : -1;  // seen from outside
    for (int i = 0; i < sides; ++i) corners.push_back({index, face, place(circle, way * i), 0});
    ++face;
  }
  const Contactor3::Circle &base = contactor.circles.front(), &top = contactor.circles.back();
  const auto add = [&](const Vec3& corner) { corners.push_back({index, face, corner, 0}); };
  for (int i = 0; i < sides; ++i, ++face) {
    const bool is_cone = !contactor.points.empty();
    add(place(base, i + 1));
    add(place(base, i));
    if (is_cone) {
      add(contactor.points[0]);
    } else {
      add(place(top, i));
      add(place(top, i + 1));
    }
  }
}

}  // namespace

std::vector<SurfaceCorner> surface_of(const std::vector<Contactor3>& contactors) {
  std::vector<SurfaceCorner> corners;
  for (int c = 0; c < static_cast<int>(contactors.size()); ++c) {
    const Contactor3& contactor = contactors[static_cast<std::size_t>(c)];
    const auto add = [&](int face, int point, double grown = 0) {
      corners.push_back({c, face, contactor.points[static_cast<std::size_t>(point)], grown});
    };
    switch (contactor.form) {
      case Form::ball:
      case Form::pill:
        for (int i = 0; i < static_cast<int>(contactor.points.size()); ++i)
          add(0, i, drawn_radius(contactor));
        break;
      case Form::hull:
        for (int f = 0; f < static_cast<int>(contactor.faces.size()); ++f)
          for (int i = 0; i < contactor.faces[static_cast<std::size_t>(f)].count; ++i)
            add(f, contactor.vertex(contactor.faces[static_cast<std::size_t>(f)], i));
        break;
      case Form::smooth:
        add_with_circles(contactor, c, corners);
        break;
      case Form::hollow:
        add_tube(contactor, c, corners);
        break;
      case Form::half_space:  // a square of 1 m stands for it
        for (const auto& [x, y] : {std::pair(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
          corners.push_back({c, 0, {x, y, 0}, 0});
        break;
      case Form::outline:
        add_triangles(*contactor.ground, c, corners);
        break;
      case Form::cloud:
        for (int f = 0; f < static_cast<int>(contactor.skin.size()); ++f)
          for (const int i : contactor.skin[static_cast<std::size_t>(f)]) add(f, i);
        break;
    }
  }
  return corners;
}

std::vector<SurfaceCorner> surface_of(const Body<2>& body) {
  if (!body.deformation.moves()) return surface_of(body.contactors);
  std::vector<Vec2> corners;
  for (const Contactor2& node : body.contactors) corners.push_back(node.points.front());
  return surface_of(std::vector{Contactor2::hull(std::move(corners), 0)});
}
std::vector<SurfaceCorner> surface_of(const Body<3>& body) {
  if (!body.deformation.moves()) return surface_of(body.contactors);
  std::vector<SurfaceCorner> corners;
  int face = 0;
  for (const auto& side : body.deformation.block->model.mesh().sides) {
    for (const int node : side) corners.push_back({0, face, body.deformation.place(node), 0});
    ++face;
  }
  return corners;
}

}  // namespace flyrock
