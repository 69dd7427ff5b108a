#include "geometry/place_text.h"

#include <fmt/format.h>

namespace flyrock {

std::string coordinate_text(double value) { return fmt::format("{:.10g}", value); }

std::string place_text(const Vec2& place) {
  return fmt::format("({}, {})", coordinate_text(place.x()), coordinate_text(place.y()));
}

std::string place_text(const Vec3& place) {
  return fmt::format("({}, {}, {})", coordinate_text(place.x()), coordinate_text(place.y()),
                     coordinate_text(place.z()));
}

}  // namespace flyrock
