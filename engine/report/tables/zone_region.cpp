#include "report/tables/zone_region.h"

#include <algorithm>

namespace flyrock {

std::vector<PlanPolygon> region_of(const Zone& zone, const Mesh* ground) {
  if (!zone.polygon.empty()) return polygons_of({zone.polygon});
  if (!zone.polygons.empty()) {
    std::vector<PlanPolygon> all;
    for (const PlanPolygon& polygon : zone.polygons) {
      std::vector<PlanRing> rings = polygon.holes;
      rings.push_back(polygon.outline);
      for (PlanPolygon& one : polygons_of(std::move(rings))) all.push_back(std::move(one));
    }
    return all;
  }
  if (zone.raster)
    return polygons_of(rings_around_cells(*zone.raster, [&](double value) { return value == zone.value; }));
  if (zone.group.empty() || !ground) return {};
  const auto part = std::find(ground->parts.begin(), ground->parts.end(), zone.name);
  if (part == ground->parts.end()) return {};
  return polygons_of(rings_around_part(*ground, static_cast<int>(part - ground->parts.begin())));
}

}  // namespace flyrock
