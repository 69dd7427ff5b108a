#pragma once
// What messages say of places beside the terrain.

#include <fmt/format.h>

#include <string>

#include "geometry/place_text.h"

namespace flyrock {

/// "100 m is not on the terrain, which spans x from -50 m to 64.36764281 m"
inline std::string off_terrain(double x, double low, double high) {
  return fmt::format("{:.10g} m is not on the terrain, which spans x from {:.10g} m to {:.10g} m", x, low,
                     high);
}

/// "(20, 31) is not on the terrain, which spans x from -50 m to 64.4 m and y from -30 m to 30 m"; of a place
/// within these ends, as beside a turned rectangle, that there is no ground.
inline std::string off_terrain(const Vec2& place, const Vec2& low, const Vec2& high) {
  if ((place.array() >= low.array()).all() && (place.array() <= high.array()).all())
    return fmt::format(
        "{} is not on the terrain: it lies between its ends in x and y, but there is no ground",
        place_text(place));
  return fmt::format(
      "{} is not on the terrain, which spans x from {:.10g} m to {:.10g} m and y from {:.10g} m "
      "to {:.10g} m",
      place_text(place), low.x(), high.x(), low.y(), high.y());
}

}  // namespace flyrock
