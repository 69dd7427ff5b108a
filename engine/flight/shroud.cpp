#include "flight/shroud.h"

#include <algorithm>
#include <cmath>

#include "geometry/profile.h"
#include "math/polynomial.h"

namespace flyrock {

namespace {

Profile level_ground(double depth) {
  constexpr double wide = 1e6;  // m, beyond any flight
  Profile ground;
  ground.points = {{-wide, -depth}, {wide, -depth}};
  ground.part = {0};
  ground.parts = {""};
  return ground;
}

}  // namespace

double level_range(const Forces<2>& forces, const Vec2& velocity, double height, double longest) {
  return land(BallisticFlight<2>(forces, Vec2::Zero(), velocity), level_ground(height), longest,
              [](const Arc<2>&, const ArcEnd&) {})
      .position.x();
}

Farthest farthest(const Forces<2>& forces, double speed, double height, double longest) {
  const auto range = [&](double elevation) {
    return level_range(forces, speed * Vec2(std::cos(elevation), std::sin(elevation)), height, longest);
  };
  // Golden-section search, because the range has a single maximum over the elevation.
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double low = 0, high = pi / 2;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double range_a = range(a), range_b = range(b);
  while (high - low > 1e-4) {
    if (range_a < range_b) {
      low = a, a = b, range_a = range_b;
      range_b = range(b = low + golden * (high - low));
    } else {
      high = b, b = a, range_b = range_a;
      range_a = range(a = high - golden * (high - low));
    }
  }
  return {0.5 * (low + high), std::max(range_a, range_b)};
}

double vacuum_envelope(double speed, double x, double gravity) {
  const double squared = speed * speed;
  return squared / (2 * gravity) - gravity * x * x / (2 * squared);
}

std::vector<Vec2> shroud(const Forces<2>& forces, double speed, double height, double longest, int points) {
  std::vector<Vec2> line;
  if (!(speed > 0)) return line;
  const double range = farthest(forces, speed, height, longest).range;
  for (int i = 0; i < points; ++i) line.emplace_back(range * i / (points - 1), -height);
  if (forces.air.drag == 0) {
    for (Vec2& point : line)
      point.y() = std::max(-height, vacuum_envelope(speed, point.x(), -forces.gravity.y()));
    return line;
  }
  const Profile ground = level_ground(height);
  constexpr int flights = 180;
  for (int flight = 0; flight <= flights; ++flight) {
    // The fan is denser for steep flights, because they form the top of the envelope, where a small change of
    // angle matters most.
    const double from_vertical = std::pow(1 - static_cast<double>(flight) / flights, 2);
    const double elevation = pi / 2 * (1 - from_vertical);
    std::size_t next = 0;  // next point, not yet reached
    const Vec2 velocity = speed * Vec2(std::cos(elevation), std::sin(elevation));
    land(BallisticFlight<2>(forces, Vec2::Zero(), velocity), ground, longest,
         [&](const Arc<2>& arc, const ArcEnd& end) {
           while (next < line.size()) {
             const auto s = first_arrival(arc, line[next].x(), 1.0, end.s);
             if (!s) break;
             line[next].y() = std::max(line[next].y(), arc.position(*s).y());
             ++next;
           }
           // Directly above the launch, the vertical flight is the highest.
           if (const auto apex = first_fall(arc.rate_along(Vec2::UnitY()), 0, end.s);
               apex && flight == flights)
             line.front().y() = std::max(line.front().y(), arc.position(*apex).y());
         });
  }
  return line;
}

}  // namespace flyrock
