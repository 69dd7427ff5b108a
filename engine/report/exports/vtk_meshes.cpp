#include "report/exports/vtk_meshes.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "files/safe_file.h"
#include "report/exports/vtk_file.h"

namespace flyrock {

namespace {

namespace fs = std::filesystem;

/// The bodies of one instant in one grid.
struct Grid {
  VtkPoints data{.points = {},
                 .line_ends = {},
                 .corners = {},
                 .polygon_ends = {},
                 .of_points = {{"displacement_m", {}, 3}, {"rate_m_s", {}, 3}},
                 .of_cells = {{"body", {}}, {"tension_Pa", {}}, {"compression_Pa", {}}}};
  std::map<std::string, std::int64_t> first_node;  ///< of each body
};

void add_nodes(const SqliteReader& database, const std::string& where, std::map<double, Grid>& grids) {
  Query row(database,
            "SELECT time_s, body, x_m, y_m, z_m, ux_m, uy_m, uz_m, ux_rate_m_s, uy_rate_m_s, "
            "uz_rate_m_s FROM series_nodes" +
                where + " ORDER BY time_s, body, node");
  while (row.next()) {
    Grid& grid = grids[row.real(0)];
    grid.first_node.try_emplace(row.text(1), static_cast<std::int64_t>(grid.data.points.size()));
    grid.data.points.emplace_back(row.real(2), row.real(3), row.real(4));
    for (const int i : {5, 6, 7}) grid.data.of_points[0].values.push_back(row.real(i));
    for (const int i : {8, 9, 10}) grid.data.of_points[1].values.push_back(row.real(i));
  }
}

void add_cells(const SqliteReader& database, const std::string& where, std::map<double, Grid>& grids) {
  Query row(database, "SELECT time_s, body, a, b, c, d, tension_Pa, compression_Pa FROM series_cells" +
                          where + " ORDER BY time_s, body, cell");
  while (row.next()) {
    Grid& grid = grids[row.real(0)];
    const auto body = grid.first_node.find(row.text(1));
    if (body == grid.first_node.end()) continue;
    for (const int i : {2, 3, 4, 5})
      if (row.type(i) != SQLITE_NULL && row.whole(i) >= 0)
        grid.data.corners.push_back(body->second + row.whole(i));
    grid.data.polygon_ends.push_back(grid.data.corners.size());
    grid.data.of_cells[0].values.push_back(static_cast<double>(std::distance(grid.first_node.begin(), body)));
    for (const int i : {6, 7})
      grid.data.of_cells[static_cast<std::size_t>(i - 5)].values.push_back(row.real(i));
  }
}

}  // namespace

bool write_meshes(const fs::path& index, const SqliteReader& database, std::int64_t point,
                  const std::string& crs) {
  const std::string where = fmt::format(
      " WHERE point = {0} AND trial = (SELECT min(trial) FROM series_nodes WHERE point = {0})", point);
  std::map<double, Grid> grids;
  add_nodes(database, where, grids);
  add_cells(database, where, grids);
  if (grids.empty()) return false;
  const fs::path folder = index.parent_path() / index.stem();
  make_folder(folder);
  std::vector<std::pair<double, fs::path>> files;
  for (const auto& [time, grid] : grids) {
    files.emplace_back(time, fmt::format("{:04}.vtu", files.size()));
    write_vtu(folder / files.back().second, grid.data, crs);
  }
  write_pvd(index, files);
  return true;
}

}  // namespace flyrock
