#include "geometry/bearing.h"

#include <catch2/catch.hpp>

#include "math/space.h"

using namespace flyrock;

namespace bearing_test {
constexpr double degree = pi / 180;
}

TEST_CASE("eight bearings point where a compass shows them, and back") {
  using bearing_test::degree;
  const struct {
    double bearing, x, y;  // with +y in the north
    const char* name;
  } winds[] = {{0, 0, 1, "north"},         {45, 1, 1, "north-east"},  {90, 1, 0, "east"},
               {135, 1, -1, "south-east"}, {180, 0, -1, "south"},     {225, -1, -1, "south-west"},
               {270, -1, 0, "west"},       {315, -1, 1, "north-west"}};
  for (const auto& wind : winds) {
    CAPTURE(wind.bearing);
    const double azimuth = azimuth_of_bearing(wind.bearing * degree, pi / 2);
    const double length = std::hypot(wind.x, wind.y);
    CHECK(std::cos(azimuth) == Approx(wind.x / length).margin(1e-15));
    CHECK(std::sin(azimuth) == Approx(wind.y / length).margin(1e-15));
    CHECK(bearing_of_azimuth(azimuth, pi / 2) == Approx(wind.bearing * degree).margin(1e-15));
    CHECK(compass_name(wind.bearing * degree) == wind.name);
    CHECK(bearing_degrees(azimuth, pi / 2) == wind.bearing);
  }
  CHECK(azimuth_of_bearing(pi * 3 / 2, pi / 2) == Approx(pi));  // west, not -pi
  CHECK(bearing_text(-37 * degree, pi / 2) == "bearing 127 deg, south-east");
  CHECK(bearing_text(90.2 * degree, pi / 2) == "bearing 0 deg, north");
}

TEST_CASE("bearings count from a north that is turned") {
  using bearing_test::degree;
  CHECK(azimuth_of_bearing(0, 75 * degree) == Approx(75 * degree));
  CHECK(azimuth_of_bearing(90 * degree, 75 * degree) == Approx(-15 * degree));
  CHECK(bearing_of_azimuth(0, 75 * degree) == Approx(75 * degree));
}
