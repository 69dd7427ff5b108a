#include "results/say/cell_size.h"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/ground.h"

namespace flyrock {

namespace {

std::string warning_of(const CellSize& size) {
  const double diameters = size.cell / size.p50;
  const std::string ground = fmt::format(
      "terrain: the cells of the ground (of a mesh: the median of its edges) are {:.3g} m", size.cell);
  if (diameters > most_diameters_a_cell)
    return fmt::format(
        "{}, {:.3g} times the median diameter of the rocks ({:.3g} m). Bumps of the rocks' size are missing "
        "from a surveyed ground, and rocks go a different distance; try smaller cells",
        ground, diameters, size.p50);
  if (diameters < least_diameters_a_cell)
    return fmt::format(
        "{}, {:.2g} of the median diameter of the rocks ({:.3g} m). They cost time, and carry the grass and "
        "the noise of a survey; try larger cells",
        ground, diameters, size.p50);
  return "";
}

}  // namespace

std::optional<CellSize> cell_size(const PointResult& point) {
  const Terrain3* terrain = point.terrain.ground.get();
  if (!terrain || !terrain->faces().empty() || terrain->ground().cell() == 0) return std::nullopt;
  if (!(point.diameters.p50 > 0)) return std::nullopt;
  return CellSize{terrain->ground().cell(), point.diameters.p5, point.diameters.p50};
}

std::vector<std::string> cell_warnings(const std::vector<PointResult>& points) {
  std::vector<std::string> list;
  for (const PointResult& point : points) {
    const std::optional<CellSize> size = cell_size(point);
    if (!size) continue;
    std::string warning = warning_of(*size);
    if (!warning.empty() && std::find(list.begin(), list.end(), warning) == list.end())
      list.push_back(std::move(warning));
  }
  return list;
}

}  // namespace flyrock
