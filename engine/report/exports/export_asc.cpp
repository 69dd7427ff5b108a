#include "report/exports/export_asc.h"

#include <fmt/format.h>

#include <cstdint>
#include <string>

#include "document/value.h"
#include "files/safe_file.h"
#include "record/maps.h"
#include "report/tables/sqlite.h"
#include "report/tables/stored_scene.h"

namespace flyrock {

namespace {

constexpr double no_data = -9999;

struct StoredGrid {
  std::int64_t point = 0;
  double x = 0, y = 0, cell = 0;
  std::size_t columns = 0, rows = 0;
};

std::vector<StoredGrid> stored_grids(const SqliteReader& database) {
  std::vector<StoredGrid> grids;
  Query row(database, "SELECT point, x_m, y_m, cell_m, columns, rows FROM map_grids ORDER BY point");
  while (row.next()) {
    const std::int64_t columns = row.whole(4), rows = row.whole(5);
    const auto most = static_cast<std::int64_t>(most_map_cells);
    if (columns < 1 || rows < 1 || columns > most || rows > most || columns * rows > most)
      throw UnreadableFile("results.db is damaged: the cells of its maps make no grid");
    grids.push_back({row.whole(0), row.real(1), row.real(2), row.real(3), static_cast<std::size_t>(columns),
                     static_cast<std::size_t>(rows)});
  }
  return grids;
}

/// The values of a raster in the order of their cells (PlanGrid).
std::vector<double> stored_values(const SqliteReader& database, const StoredGrid& grid, const char* name) {
  std::vector<double> values(grid.columns * grid.rows, no_data);
  Query row(database,
            fmt::format("SELECT \"column\", \"row\", {} FROM maps WHERE point = {}", name, grid.point));
  while (row.next()) {
    const auto column = static_cast<std::size_t>(row.whole(0)), at = static_cast<std::size_t>(row.whole(1));
    if (column >= grid.columns || at >= grid.rows)
      throw UnreadableFile("results.db is damaged: a cell outside of its map");
    values[at * grid.columns + column] = row.real(2);
  }
  return values;
}

/// Whether the point has the raster: its cells hold numbers.
bool has_raster(const SqliteReader& database, const StoredGrid& grid, const char* name) {
  Query row(database,
            fmt::format("SELECT 1 FROM maps WHERE point = {} AND {} IS NOT NULL LIMIT 1", grid.point, name));
  return row.next();
}

std::string grid_text(const StoredGrid& grid, const std::vector<double>& values) {
  std::string text = fmt::format(
      "ncols {}\nnrows {}\nxllcorner {}\nyllcorner {}\ncellsize {}\nNODATA_value {}\n", grid.columns,
      grid.rows, shortest(grid.x), shortest(grid.y), shortest(grid.cell), shortest(no_data));
  for (std::size_t r = grid.rows; r-- > 0;)
    for (std::size_t c = 0; c < grid.columns; ++c) {
      text += shortest(values[r * grid.columns + c]);
      text += c + 1 < grid.columns ? ' ' : '\n';
    }
  return text;
}

/// An ASCII grid has no place for the number of a coordinate system, and a file .prj needs all of its
/// definition. GDAL, and so QGIS, take it from this file, which shows the grid. Source: gdal.org, VRT driver.
void write_with_crs(const std::filesystem::path& grid_file, const StoredGrid& grid, const std::string& crs) {
  std::filesystem::path file = grid_file;
  write_file(file.replace_extension(".vrt"),
             fmt::format("<VRTDataset rasterXSize=\"{}\" rasterYSize=\"{}\">\n"
                         "  <SRS>{}</SRS>\n"
                         "  <GeoTransform>{}, {}, 0, {}, 0, {}</GeoTransform>\n"
                         "  <VRTRasterBand dataType=\"Float64\" band=\"1\">\n"
                         "    <NoDataValue>{}</NoDataValue>\n"
                         "    <SimpleSource>\n"
                         "      <SourceFilename relativeToVRT=\"1\">{}</SourceFilename>\n"
                         "      <OpenOptions><OOI key=\"DATATYPE\">Float64</OOI></OpenOptions>\n"
                         "    </SimpleSource>\n"
                         "  </VRTRasterBand>\n"
                         "</VRTDataset>\n",
                         grid.columns, grid.rows, crs, shortest(grid.x), shortest(grid.cell),
                         shortest(grid.y + grid.cell * static_cast<double>(grid.rows)), shortest(-grid.cell),
                         shortest(no_data), grid_file.filename().string()));
}

}  // namespace

std::vector<std::filesystem::path> export_asc(const std::filesystem::path& results,
                                              const std::filesystem::path& folder) {
  const SqliteReader database(results);
  const std::string crs = stored_crs(database);
  std::vector<std::filesystem::path> files;
  for (const StoredGrid& grid : stored_grids(database)) {
    make_folder(folder);
    for (std::size_t m = 0; m < map_names.size(); ++m) {
      const char* name = map_names[m];
      if (m == hit_map && !has_raster(database, grid, name)) continue;
      files.push_back(folder / fmt::format("{}-p{}.asc", name, grid.point));
      write_file(files.back(), grid_text(grid, stored_values(database, grid, name)));
      if (!crs.empty()) write_with_crs(files.back(), grid, crs);
    }
  }
  return files;
}

}  // namespace flyrock
