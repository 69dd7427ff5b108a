#pragma once
// The cells of a map below a flight.

#include "flight/ground.h"
#include "record/plan_cells.h"

namespace flyrock {

/// Records a path over [0, dt] in the cells over which it passes above ground. `energy(squared)` is the
/// kinetic energy [J] at a squared speed, `squared_speed(t)` the squared speed [m2/s2], convex in time: its
/// greatest value over a cell is at an end of the stretch there. The greatest height over a cell is at an end
/// or where the path is parallel to a facet. Both are exact for a path that is straight in plan, as for
/// rate_along_x.
template <class SquaredSpeed, class Energy>
void over_cells(const Terrain3& terrain, const Path<3>& path, double dt, PlanCells& cells,
                SquaredSpeed squared_speed, Energy energy) {
  if (!cells.records()) return;
  const Vec2 place = path.x.head<2>(), rate = (path.v + 0.5 * dt * path.a).head<2>();
  visit_heights(terrain, path, dt, [&](double from, double to, const auto& highest) {
    cells.visit(place, rate, from, to, [&](PlanCell& cell, double t0, double t1) {
      const double squared = std::max(squared_speed(t0), squared_speed(t1));
      cell.height = std::max(cell.height, highest(t0, t1));
      cell.speed = std::max(cell.speed, std::sqrt(squared));
      cell.energy = std::max(cell.energy, energy(squared));
    });
  });
}
/// Maps are made in 3D.
template <class SquaredSpeed, class Energy>
void over_cells(const Terrain2&, const Path<2>&, double, PlanCells&, SquaredSpeed, Energy) {}

}  // namespace flyrock
