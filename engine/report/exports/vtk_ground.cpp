#include "report/exports/vtk_ground.h"

#include <fmt/format.h>

#include "report/tables/stored_scene.h"

namespace flyrock {

namespace {

/// One line for each segment, because each segment has its own part.
VtkPoints profile_lines(const SqliteReader& database, std::int64_t point) {
  Query row(database,
            fmt::format("SELECT x_m, y_m, part FROM ground WHERE point = {} ORDER BY rowid", point));
  VtkPoints lines;
  VtkArray parts{"part", {}};
  Vec3 before = Vec3::Zero();
  for (bool first = true; row.next(); first = false) {
    const Vec3 place(row.real(0), row.real(1), 0);
    if (!first) {
      lines.points.insert(lines.points.end(), {before, place});
      lines.line_ends.push_back(lines.points.size());
    }
    if (row.type(2) != SQLITE_NULL) parts.values.push_back(row.real(2));
    before = place;
  }
  lines.of_cells = {std::move(parts)};
  return lines;
}

VtkPoints ground_triangles(const SqliteReader& database, std::int64_t ground) {
  VtkPoints surface;
  VtkArray parts{"part", {}};
  Query vertex(
      database,
      fmt::format("SELECT x_m, y_m, z_m FROM ground_vertices WHERE ground = {} ORDER BY rowid", ground));
  while (vertex.next()) surface.points.emplace_back(vertex.real(0), vertex.real(1), vertex.real(2));
  Query triangle(
      database,
      fmt::format("SELECT a, b, c, part FROM ground_triangles WHERE ground = {} ORDER BY rowid", ground));
  while (triangle.next()) {
    for (const int corner : {0, 1, 2}) surface.corners.push_back(triangle.whole(corner));
    surface.polygon_ends.push_back(surface.corners.size());
    parts.values.push_back(triangle.real(3));
  }
  surface.of_cells = {std::move(parts)};
  return surface;
}

}  // namespace

VtkPoints stored_ground_surface(const SqliteReader& database, std::int64_t point) {
  const std::optional<std::int64_t> ground = stored_ground(database, point);
  return ground ? ground_triangles(database, *ground) : profile_lines(database, point);
}

}  // namespace flyrock
