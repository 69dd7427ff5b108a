#include "geometry/bearing.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "math/space.h"

namespace flyrock {

double azimuth_of_bearing(double bearing, double north) {
  const double azimuth = std::remainder(north - bearing, 2 * pi);
  return azimuth == -pi ? pi : azimuth;
}

double bearing_of_azimuth(double azimuth, double north) {
  const double bearing = std::remainder(north - azimuth, 2 * pi);
  return bearing < 0 ? bearing + 2 * pi : bearing;
}

double bearing_degrees(double azimuth, double north) {
  const double degrees = std::round(bearing_of_azimuth(azimuth, north) * 180 / pi * 1e9) / 1e9;
  return degrees == 360 ? 0 : degrees;
}

std::string compass_name(double bearing) {
  constexpr std::array names = {"north", "north-east", "east", "south-east",
                                "south", "south-west", "west", "north-west"};
  const auto eighth = static_cast<long>(std::lround(bearing / (pi / 4)));
  return names[static_cast<std::size_t>(((eighth % 8) + 8) % 8)];
}

std::string bearing_text(double azimuth, double north) {
  const double bearing = bearing_of_azimuth(azimuth, north);
  const long degrees = std::lround(bearing * 180 / pi) % 360;
  return fmt::format("bearing {} deg, {}", degrees, compass_name(bearing));
}

}  // namespace flyrock
