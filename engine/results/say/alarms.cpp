#include "results/say/alarms.h"

#include <fmt/format.h>

#include <algorithm>

#include "math/sphere.h"
#include "results/say/wording.h"

namespace flyrock {

double least_size(const PointResult& point) {
  double least = infinite;
  for (const RockRecord& rock : point.first_trial)
    if (rock.volume > 0) least = std::min(least, 2 * sphere_radius(rock.volume));
  return least;
}

std::vector<std::string> alarms(const std::vector<PointResult>& points) {
  std::vector<std::string> list;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const SolverQuality& quality = points[p].totals.quality;
    const std::string at = points.size() > 1 ? fmt::format("Point {}: ", p) : "";
    const double depth = quality.max_penetration / least_size(points[p]);
    if (depth > most_penetration)
      list.push_back(
          fmt::format("{}a rock lay {} m deep in the ground or in another rock, {} of the size of the "
                      "smallest rock; above {} it is too deep",
                      at, three_digits(quality.max_penetration), percent(depth), percent(most_penetration)));
    if (quality.max_residual > most_residual)
      list.push_back(
          fmt::format("{}a contact problem kept a residual of {} m/s; above {} m/s velocities are wrong", at,
                      three_digits(quality.max_residual), three_digits(most_residual)));
  }
  return list;
}

}  // namespace flyrock
