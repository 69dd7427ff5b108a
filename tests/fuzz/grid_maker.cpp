// Grids of heights as GIS write them.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "../geotiff.h"
#include "corpus.h"
#include "terrain_file.h"

namespace flyrock::fuzz {

namespace {

/// Heights at the centres of cells, as the file means them.
struct MadeGrid {
  int columns = 0, rows = 0;
  double cell = 1;
  Vec2 first = Vec2::Zero();    ///< centre of the south-western cell
  std::vector<double> heights;  ///< from the south-west; NaN: no data

  double at(int column, int row) const { return heights[static_cast<std::size_t>(row * columns + column)]; }
  Vec2 place(double column, double row) const { return first + cell * Vec2(column, row); }

  /// In the square of four centres, which is cut from south-west to north-east; none where one has no data.
  std::optional<double> height(int column, int row, double u, double v) const {
    const double sw = at(column, row), se = at(column + 1, row), nw = at(column, row + 1),
                 ne = at(column + 1, row + 1);
    if (std::isnan(sw + se + nw + ne)) return std::nullopt;
    return u >= v ? sw + u * (se - sw) + v * (ne - se) : sw + v * (nw - sw) + u * (ne - nw);
  }
};

class GridMaker {
 public:
  explicit GridMaker(Dice& dice) : dice_(dice) {}

  TerrainFile make() {
    const Hill hill = make_hill(dice_, dice_.one_in(2));
    grid_.columns = 4 + static_cast<int>(dice_.below(9));
    grid_.rows = 4 + static_cast<int>(dice_.below(9));
    grid_.cell = one_of_cells();
    grid_.first = hill.corner + Vec2::Constant(0.5 * grid_.cell);
    for (int row = 0; row < grid_.rows; ++row)
      for (int column = 0; column < grid_.columns; ++column)
        grid_.heights.push_back(std::stod(fmt::format("{:.3f}", hill.height(grid_.place(column, row)))));
    make_voids();
    switch (dice_.below(4)) {
      case 0:
        write_surfer();
        break;
      case 1:
        write_tif();
        break;
      default:
        write_esri();
    }
    add_probes();
    return file_;
  }

 private:
  double one_of_cells() {
    static constexpr std::array cells = {0.5, 1.0, 2.0, 5.0, 10.0, 0.3, 2.5};
    return dice_.pick(cells);
  }

  /// Some cells at the border or inside have no data, the middle square always has.
  void make_voids() {
    if (dice_.one_in(2)) return;
    const int column = grid_.columns / 2, row = grid_.rows / 2;
    for (int i = 0; i < grid_.columns * grid_.rows; ++i) {
      const int c = i % grid_.columns, r = i / grid_.columns;
      const bool is_middle = (c == column || c == column - 1) && (r == row || r == row - 1);
      const bool is_corner =
          c + (grid_.rows - 1 - r) < 2;  // of a clipped raster the first cell is empty, as written
      if (!is_middle && (is_corner || dice_.one_in(9)))
        grid_.heights[static_cast<std::size_t>(i)] = std::numeric_limits<double>::quiet_NaN();
    }
  }

  bool has_voids() const {
    for (const double height : grid_.heights)
      if (std::isnan(height)) return true;
    return false;
  }

  void add_probes() {
    const int c0 = grid_.columns / 2 - 1, r0 = grid_.rows / 2 - 1;
    file_.start = grid_.place(c0 + 0.5, r0 + 0.5);
    for (int i = 0; i < 40; ++i) {
      const int column = static_cast<int>(dice_.below(static_cast<std::size_t>(grid_.columns - 1)));
      const int row = static_cast<int>(dice_.below(static_cast<std::size_t>(grid_.rows - 1)));
      const double u = draw(dice_, 0.01, 0.99), v = draw(dice_, 0.01, 0.99);
      file_.probes.push_back({grid_.place(column + u, row + v), grid_.height(column, row, u, v)});
    }
  }

  std::string key(const char* name) {
    std::string text = name;
    if (dice_.one_in(4))
      for (char& c : text)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return text;
  }

  void write_esri() {
    const std::string end = one_of(dice_, {"\n", "\n", "\r\n"}), gap = one_of(dice_, {" ", "   ", "\t"});
    const bool is_centre = dice_.one_in(2), is_split = dice_.one_in(5);
    const Vec2 corner = grid_.first - (is_centre ? 0 : 0.5) * Vec2::Constant(grid_.cell);
    std::string text = one_of(dice_, {"", "", "\xEF\xBB\xBF"});
    const auto line = [&](const char* name, const std::string& value) {
      text += key(name) + gap + value + end;
    };
    line("ncols", std::to_string(grid_.columns));
    line("nrows", std::to_string(grid_.rows));
    line(is_centre ? "xllcenter" : "xllcorner", fmt::format("{:.6f}", corner.x()));
    line(is_centre ? "yllcenter" : "yllcorner", fmt::format("{:.6f}", corner.y()));
    if (is_split) {
      line("dx", fmt::format("{:.12f}", grid_.cell));
      line("dy", fmt::format("{:.12f}", grid_.cell * (1 + 2e-6)));
      file_.tolerance = 1e-3;
    } else {
      line("cellsize", fmt::format("{}", grid_.cell));
    }
    struct NoData {
      const char *head, *cell;
    };
    static constexpr NoData tagged[] = {{"-9999", "-9999"},
                                        {"-9999", "-9999.000"},
                                        {"nan", "nan"},
                                        {"-3.4028234663852886e+38", "-3.4028235e+38"},
                                        {"-3.40282346638529e+38", "-3.40282e+038"},
                                        {"-32767", "-32767"},
                                        {"1e20", "1e+20"},
                                        {"", "-9999"},
                                        {"", "nan"}};
    static constexpr NoData untagged[] = {{"", "-32768"}, {"", "-99999"}, {"-9999", "-32768"}, {"", "65535"}};
    const bool is_untagged = has_voids() && dice_.one_in(4);
    const NoData none = is_untagged ? dice_.pick(untagged) : dice_.pick(tagged);
    if (*none.head) line("nodata_value", none.head);
    if (is_untagged) {
      file_.fault = none.cell;
      file_.cure = "no_data: ";
    }
    const int wrap = dice_.one_in(4) ? 3 : grid_.columns;  // values a line
    int on_line = 0;
    for (int row = grid_.rows - 1; row >= 0; --row)
      for (int column = 0; column < grid_.columns; ++column) {
        const double height = grid_.at(column, row);
        text += std::isnan(height) ? none.cell : fmt::format("{:.3f}", height);
        text += ++on_line % wrap == 0 || (wrap == grid_.columns && column + 1 == grid_.columns) ? end : " ";
      }
    write_here("ground.asc", with_last_line(dice_, std::move(text)));
    file_.terrain = "type: raster, file: ground.asc";
  }

  void write_surfer() {
    const std::string end = one_of(dice_, {"\n", "\r\n"});
    double low = 1e300, high = -1e300;
    for (const double height : grid_.heights)
      if (!std::isnan(height)) low = std::min(low, height), high = std::max(high, height);
    const Vec2 last = grid_.place(grid_.columns - 1, grid_.rows - 1);
    std::string text = fmt::format("DSAA{0}{1} {2}{0}{3:.6f} {4:.6f}{0}{5:.6f} {6:.6f}{0}{7:.3f} {8:.3f}{0}",
                                   end, grid_.columns, grid_.rows, grid_.first.x(), last.x(), grid_.first.y(),
                                   last.y(), low, high);
    for (int row = 0; row < grid_.rows; ++row) {
      for (int column = 0; column < grid_.columns; ++column) {
        const double height = grid_.at(column, row);
        text += std::isnan(height) ? "1.70141e+038" : fmt::format("{:.3f}", height);
        text += (column + 1) % 10 == 0 ? end : " ";  // Surfer breaks lines at ten values
      }
      text += end + end;
    }
    write_here("ground.grd", with_last_line(dice_, std::move(text)));
    file_.terrain = "type: raster, file: ground.grd";
    file_.tolerance = 1e-4;  // of its places
  }

  void write_tif() {
    GeoTiff tif;
    tif.cell = grid_.cell;
    tif.north_west = grid_.place(-0.5, grid_.rows - 0.5);
    const bool is_scaled = dice_.one_in(4), is_feet = !is_scaled && dice_.one_in(4);
    const bool is_masked = has_voids() && dice_.one_in(2),
               is_untagged = has_voids() && !is_masked && dice_.one_in(4);
    if (is_scaled) {
      tif.scale = "0.1";
      tif.offset = "500";
    }
    if (is_feet) tif.unit = one_of(dice_, {"ft", "foot", "feet"});
    if (dice_.one_in(2) && grid_.first.x() > 1e6) tif.epsg = 2056;
    const float none = dice_.one_in(2) ? -9999.0f : std::numeric_limits<float>::lowest();
    if (has_voids() && !is_masked && !is_untagged)
      tif.no_data = none == -9999 ? "-9999" : "-3.4028234663852886e+38";
    for (int row = grid_.rows - 1; row >= 0; --row) {
      tif.rows.emplace_back();
      if (is_masked) tif.mask.emplace_back();
      for (int column = 0; column < grid_.columns; ++column) {
        const double height = grid_.at(column, row);
        const double written = is_scaled ? (height - 500) / 0.1 : is_feet ? height / 0.3048 : height;
        tif.rows.back().push_back(std::isnan(height) ? (is_masked ? 0.0f : none)
                                                     : static_cast<float>(written));
        if (is_masked) tif.mask.back().push_back(!std::isnan(height));
      }
    }
    if (is_untagged) {
      file_.fault = none == -9999 ? "-9999" : "-3.40282";
      file_.cure = "no_data: ";
    }
    write_here("ground.tif", tif.bytes());
    file_.terrain = "type: raster, file: ground.tif";
    file_.tolerance = 2e-3;  // numbers of 32 bits
  }

  Dice& dice_;
  MadeGrid grid_;
  TerrainFile file_;
};

}  // namespace

TerrainFile make_grid_file(Dice& dice) { return GridMaker(dice).make(); }

}  // namespace flyrock::fuzz
