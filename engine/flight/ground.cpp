#include "flight/ground.h"

#include <limits>

namespace flyrock {

namespace {
constexpr double infinite = std::numeric_limits<double>::infinity();
}

std::pair<double, double> extent(const Terrain2& terrain) {
  return {terrain.profile().x_min(), terrain.profile().x_max()};
}
std::pair<double, double> extent(const Terrain3&) { return {-infinite, infinite}; }

double ground_height(const Terrain2& terrain, const Vec2& at) { return terrain.profile().height(at.x()); }
double ground_height(const Terrain3& terrain, const Vec3& at) { return terrain.height(at.x(), at.y()); }

}  // namespace flyrock
