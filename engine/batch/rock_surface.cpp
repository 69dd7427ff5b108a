#include "batch/rock_surface.h"

namespace flyrock {

std::vector<SurfaceCorner> surface_of(const std::vector<Contactor2>& contactors) {
  std::vector<SurfaceCorner> corners;
  for (std::size_t c = 0; c < contactors.size(); ++c)
    for (const Vec2& point : contactors[c].points)
      corners.push_back({static_cast<int>(c), 0, {point.x(), point.y(), 0}, contactors[c].radius});
  return corners;
}

std::vector<SurfaceCorner> surface_of(const std::vector<Contactor3>& contactors) {
  std::vector<SurfaceCorner> corners;
  for (std::size_t c = 0; c < contactors.size(); ++c) {
    const Contactor3& contactor = contactors[c];
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
