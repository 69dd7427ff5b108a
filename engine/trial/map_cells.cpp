#include "trial/map_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/grid_ground.h"
#include "math/round_step.h"
#include "trial/scenario_error.h"

namespace flyrock {

namespace {

std::uint64_t cells_of(const PlanGrid& grid) {
  return static_cast<std::uint64_t>(grid.columns) * static_cast<std::uint64_t>(grid.rows);
}

std::int32_t cells_along(double length, double cell) {
  constexpr double rounding = 2e-6;  // m, of both ends (without_rounding)
  const double cells = std::ceil((length - rounding) / cell - 1e-9);
  return static_cast<std::int32_t>(std::clamp(cells, 1.0, static_cast<double>(most_map_cells) + 1));
}

PlanGrid grid_over(const Vec2& low, const Vec2& high, double cell) {
  return {low, cell, cells_along(high.x() - low.x(), cell), cells_along(high.y() - low.y(), cell)};
}

bool is_too_fine(const PlanGrid& grid) { return cells_of(grid) > most_map_cells; }

/// A coordinate without the rounding of sums of cells and their halves, to a micrometre.
double without_rounding(double x) { return std::round(x * 1e6) / 1e6; }

/// Moves the corners of a region outwards to those of the cells of a raster. `corner`: of the raster.
void snap_to_cells(const Vec2& corner, double cell, Vec2& low, Vec2& high) {
  constexpr double slack = 1e-6;  // of a cell: a corner of the region that lies on one of the raster stays
  for (int k = 0; k < 2; ++k) {
    const double first = std::floor((low[k] - corner[k]) / cell + slack);
    const double last = std::ceil((high[k] - corner[k]) / cell - slack);
    low[k] = without_rounding(corner[k] + first * cell);
    high[k] = without_rounding(corner[k] + last * cell);
  }
}

/// The cells over a ground that counts from `origin`. There may be too many only where the plan gives `cell`.
PlanGrid grid_of(const MapsPlan& plan, const Ground3& ground, const Vec2& origin) {
  if (!plan.wanted) return {};
  Vec2 low = ground.extent().low.head<2>() + origin, high = ground.extent().high.head<2>() + origin;
  if (!plan.region.empty()) {
    low = plan.region.front().cwiseMin(plan.region.back());
    high = plan.region.front().cwiseMax(plan.region.back());
  }
  if (!low.allFinite() || !high.allFinite()) return {};
  if (plan.cell > 0) return grid_over(low, high, plan.cell);
  const bool raster = dynamic_cast<const GridGround*>(&ground) != nullptr && ground.cell() > 0;
  if (raster) {
    // The ground ends at the centres of its outermost cells.
    const Vec2 half = Vec2::Constant(0.5 * ground.cell());
    const Vec2 corner = ground.extent().low.head<2>() + origin - half;
    if (plan.region.empty()) {
      low -= half;
      high += half;
    }
    snap_to_cells(corner, ground.cell(), low, high);
  }
  double cell = raster ? ground.cell() : round_step((high - low).maxCoeff() / 200);
  PlanGrid grid = grid_over(low, high, cell);
  for (int n = 2; is_too_fine(grid); ++n) grid = grid_over(low, high, n * cell);
  return grid;
}

}  // namespace

PlanGrid map_grid(const Scenario& scenario, const Terrain3& terrain) {
  const MapsPlan& plan = scenario.output.maps;
  const PlanGrid grid = grid_of(plan, terrain.ground(), scenario.terrain.origin.head<2>());
  if (grid.empty() && plan.wanted && plan.cell > 0)
    throw ScenarioError("output.maps.cell", "the ground has no ends, expected a `region`");
  if (is_too_fine(grid))
    throw ScenarioError("output.maps", fmt::format("there are more than {} cells, expected larger ones or a "
                                                   "smaller `region`",
                                                   most_map_cells));
  return grid;
}

}  // namespace flyrock
