#include "batch/rock_surface.h"

#include <cmath>

#include "geometry/ground.h"

namespace flyrock {

namespace {

/// A point is drawn as a small ball.
template <class Contactor>
double drawn_radius(const Contactor& contactor) {
  return contactor.points.size() == 1 && contactor.radius == 0 ? contactor.bound : contactor.radius;
}

constexpr int wall_pieces = 48;  // of the wall of a room, around its axis

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
  Vec2 low = points.front(), high = low;
  double twice_area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2& next = points[(i + 1) % points.size()];
    low = low.cwiseMin(next), high = high.cwiseMax(next);
    twice_area += points[i].x() * next.y() - points[i].y() * next.x();
  }
  if (twice_area > 0) return points;
  const Vec2 grow = Vec2::Constant(frame * (high - low).norm());
  low -= grow, high += grow;
  points.push_back(points.front());
  points.insert(points.end(), {low, {high.x(), low.y()}, high, {low.x(), high.y()}, low});
  return points;
}

}  // namespace

std::vector<SurfaceCorner> surface_of(const std::vector<Contactor2>& contactors) {
  std::vector<SurfaceCorner> corners;
  for (std::size_t c = 0; c < contactors.size(); ++c) {
    if (contactors[c].is_room()) {
      add_ring(contactors[c], static_cast<int>(c), corners);
      continue;
    }
    if (contactors[c].is_surface()) {
      for (const Vec2& point : counter_clockwise(*contactors[c].surface))
        corners.push_back({static_cast<int>(c), 0, {point.x(), point.y(), 0}, 0});
      continue;
    }
    for (const Vec2& point : contactors[c].points)
      corners.push_back({static_cast<int>(c), 0, {point.x(), point.y(), 0}, drawn_radius(contactors[c])});
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
  for (std::size_t c = 0; c < contactors.size(); ++c) {
    const Contactor3& contactor = contactors[c];
    if (contactor.is_half_space()) {  // a square of 1 m stands for it
      for (const auto& [x, y] : {std::pair(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
        corners.push_back({static_cast<int>(c), 0, {x, y, 0}, 0});
      continue;
    }
    if (contactor.is_surface()) {
      add_triangles(*contactor.surface, static_cast<int>(c), corners);
      continue;
    }
    if (contactor.is_cloud()) {
      for (std::size_t f = 0; f < contactor.skin.size(); ++f)
        for (const int i : contactor.skin[f])
          corners.push_back(
              {static_cast<int>(c), static_cast<int>(f), contactor.points[static_cast<std::size_t>(i)], 0});
      continue;
    }
    if (contactor.is_room()) {
      add_tube(contactor, static_cast<int>(c), corners);
      continue;
    }
    if (contactor.has_circles()) {
      add_with_circles(contactor, static_cast<int>(c), corners);
      continue;
    }
    if (!contactor.has_faces())
      for (const Vec3& point : contactor.points)
        corners.push_back({static_cast<int>(c), 0, point, drawn_radius(contactor)});
    for (std::size_t f = 0; f < contactor.faces.size(); ++f)
      for (int i = 0; i < contactor.faces[f].count; ++i)
        corners.push_back({static_cast<int>(c), static_cast<int>(f),
                           contactor.points[contactor.vertex(contactor.faces[f], i)], 0});
  }
  return corners;
}

}  // namespace flyrock
