#include "plugin/models.h"

#include <cmath>
#include <string>

namespace flyrock {

namespace {
[[noreturn]] void refuse(const char* what, int dimension) {
  throw PluginError(std::string("the plugin has no ") + what + " in dimension " + std::to_string(dimension));
}
}  // namespace

std::vector<Contactor2> ShapeModel::build(Values, RandomStream&) const { refuse("shape", 2); }
std::vector<Contactor3> ShapeModel::build_3d(Values, RandomStream&) const { refuse("shape", 3); }
Profile TerrainModel::build(Values, RandomStream&) const { refuse("terrain", 2); }
TerrainShape3 TerrainModel::build_3d(Values, RandomStream&) const { refuse("terrain", 3); }
std::vector<RockPlan<2>> Population::rocks(Values, const TerrainView&, const Blast&, RandomStream&) const {
  refuse("rocks", 2);
}
std::vector<RockPlan<3>> Population::rocks_3d(Values, const TerrainView&, const Blast&, RandomStream&) const {
  refuse("rocks", 3);
}

Vec3 direction_velocity(const RockView& rock, double speed, double elevation, double azimuth) {
  const double horizontal = speed * std::cos(elevation);
  const double rise = speed * std::sin(elevation);
  if (rock.dimension == 2) return {horizontal * rock.outward.x(), rise, 0};
  const double c = std::cos(azimuth), s = std::sin(azimuth);
  return {horizontal * (c * rock.outward.x() - s * rock.outward.y()),
          horizontal * (s * rock.outward.x() + c * rock.outward.y()), rise};
}

}  // namespace flyrock
