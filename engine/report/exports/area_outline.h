#pragma once
// The outline of a blasting area in plan, as report/assets/area.js draws it.

#include <vector>

#include "geometry/plan_region.h"

namespace flyrock {

/// A sector of the area: the place of its middle, and where the area ends in it.
struct AreaSector {
  double azimuth = 0;   ///< rad, from +x towards +y
  double distance = 0;  ///< m, from the hull
};

/// The union of equal sectors about `centre`, each up to its distance from `hull` (counter-clockwise: the
/// hull of all release places, or one place). The arcs have a place every degree or two. Counter-clockwise.
PlanRing area_outline(const Vec2& centre, const std::vector<Vec2>& hull,
                      const std::vector<AreaSector>& sectors);

}  // namespace flyrock
