#include "geometry/terrain_fault.h"

#include <fmt/format.h>

#include <cmath>

#include "geometry/mesh_fault.h"
#include "geometry/place_text.h"

namespace flyrock {

namespace {

bool has_ground(const HeightGrid& grid) {
  for (int row = 0; row + 1 < grid.rows; ++row)
    for (int column = 0; column + 1 < grid.columns; ++column)
      if (std::isfinite(grid.at(column, row) + grid.at(column + 1, row) + grid.at(column, row + 1) +
                        grid.at(column + 1, row + 1)))
        return true;
  return false;
}

std::string fault(const Plane& plane) {
  const bool is_plane =
      plane.point.allFinite() && std::abs(plane.normal.norm() - 1) < 1e-9 && plane.normal.z() > 0;
  return is_plane ? "" : "a plane has no finite point or no unit normal that points upwards";
}

}  // namespace

std::string fault(const HeightGrid& grid) {
  if (grid.columns < 2 || grid.rows < 2)
    return fmt::format("a grid has {} x {} heights, expected at least 2 x 2", grid.columns, grid.rows);
  const std::size_t cells = static_cast<std::size_t>(grid.columns) * grid.rows;
  if (grid.heights.size() != cells)
    return fmt::format("a grid of {} x {} cells has {} heights", grid.columns, grid.rows,
                       grid.heights.size());
  if (!(grid.cell > 0 && std::isfinite(grid.cell)) || !grid.corner.allFinite())
    return fmt::format("a grid has cells of {:.6g} m at {}", grid.cell, place_text(grid.corner));
  for (std::size_t i = 0; i < cells; ++i)
    if (std::isinf(grid.heights[i]))
      return fmt::format(
          "the height at {} of a grid is infinite",
          place_text(Vec2(grid.corner + grid.cell * Vec2(static_cast<double>(i % grid.columns),
                                                         static_cast<double>(i / grid.columns)))));
  if (!grid.part.empty() && grid.part.size() != cells)
    return fmt::format("the grid has {} cells but {} part numbers", cells, grid.part.size());
  for (const std::uint8_t part : grid.part)
    if (part >= grid.parts.size())
      return fmt::format("a grid of {} parts has a cell of part {}", grid.parts.size(), part);
  if (!has_ground(grid)) return "a grid has no ground: nowhere have four neighbouring cells a height";
  return {};
}

std::string fault(const TerrainShape3& shape) {
  if (const Plane* plane = std::get_if<Plane>(&shape)) return fault(*plane);
  if (const Mesh* mesh = std::get_if<Mesh>(&shape)) return fault(*mesh);
  return fault(std::get<HeightGrid>(shape));
}

}  // namespace flyrock
