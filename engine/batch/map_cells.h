#pragma once
// The cells of the maps of a scenario, checked.

#include <fmt/format.h>

#include "batch/maps.h"
#include "collision/terrain3.h"
#include "trial/scenario_error.h"

namespace flyrock {

/// map_grid() of a scenario in 3D over its ground. Throws ScenarioError if the scenario asks for cells that
/// cannot be made.
inline PlanGrid checked_map_grid(const Scenario& scenario, const Terrain3& terrain) {
  const MapsPlan& plan = scenario.output.maps;
  const PlanGrid grid = map_grid(plan, terrain.ground(), scenario.terrain.origin.head<2>());
  if (grid.empty() && plan.wanted && plan.cell > 0)
    throw ScenarioError("output.maps.cell", "the ground has no ends, expected a `region`");
  const auto columns = static_cast<std::uint64_t>(grid.columns), rows = static_cast<std::uint64_t>(grid.rows);
  if (columns * rows > most_map_cells)
    throw ScenarioError("output.maps", fmt::format("there are more than {} cells, expected larger ones or a "
                                                   "smaller `region`",
                                                   most_map_cells));
  return grid;
}

}  // namespace flyrock
