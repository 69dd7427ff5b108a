#include "plugin/models.h"

#include <cmath>

namespace flyrock {

Vec3 direction_velocity(const RockView& rock, double speed, double elevation, double azimuth) {
  const double horizontal = speed * std::cos(elevation);
  const double rise = speed * std::sin(elevation);
  if (rock.dimension == 2) return {horizontal * rock.outward.x(), rise, 0};
  const double c = std::cos(azimuth), s = std::sin(azimuth);
  return {horizontal * (c * rock.outward.x() - s * rock.outward.y()),
          horizontal * (s * rock.outward.x() + c * rock.outward.y()), rise};
}

}  // namespace flyrock
