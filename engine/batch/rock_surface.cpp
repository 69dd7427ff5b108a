#include "batch/rock_surface.h"

#include <cmath>

namespace flyrock {

std::vector<SurfaceCorner> surface_of(const std::vector<Contactor2>& contactors) {
  std::vector<SurfaceCorner> corners;
  for (std::size_t c = 0; c < contactors.size(); ++c)
    for (const Vec2& point : contactors[c].points)
      corners.push_back({static_cast<int>(c), 0, {point.x(), point.y(), 0}, contactors[c].radius});
  return corners;
}

namespace {

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
    if (contactor.has_circles()) {
      add_with_circles(contactor, static_cast<int>(c), corners);
      continue;
    }
    if (!contactor.has_faces())
      for (const Vec3& point : contactor.points)
        corners.push_back({static_cast<int>(c), 0, point, contactor.radius});
    for (std::size_t f = 0; f < contactor.faces.size(); ++f)
      for (int i = 0; i < contactor.faces[f].count; ++i)
        corners.push_back({static_cast<int>(c), static_cast<int>(f),
                           contactor.points[contactor.vertex(contactor.faces[f], i)], 0});
  }
  return corners;
}

}  // namespace flyrock
