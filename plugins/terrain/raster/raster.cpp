#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "geometry/terrain_fault.h"
#include "plugins/factories.h"
#include "survey/fill_voids.h"
#include "survey/raster_file.h"
#include "survey/surveyed_terrain.h"

namespace flyrock::plugins {

namespace {

/// A height as the file writes it. `metres`: of one unit of the heights.
double in_file(const RasterFile& file, double height, double metres) {
  return (height / metres - file.value_offset) / file.value_scale;
}

/// Heights that no ground has: the commonest of them is the value that a program writes for no data.
std::string impossible_heights(const RasterFile& file, double metres) {
  std::map<double, std::size_t> counts;
  std::size_t all = 0;
  constexpr std::size_t most_values = 10'000;
  for (const double z : file.grid.heights) {
    if (std::isnan(z) || is_height_of_ground(z)) continue;
    ++all;
    if (counts.size() < most_values || counts.contains(z)) ++counts[z];
  }
  if (all == 0) return {};
  const auto common = std::max_element(counts.begin(), counts.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
  return fmt::format(
      "{} cell{} {:.10g} m, and {} in all are below {:g} m or above {:g} m, which no ground is; write "
      "`no_data: {:.10g}` if these cells have no data, or `unit` or `scale` if the heights are not in m",
      common->second, common->second == 1 ? " is" : "s are", common->first, all, lowest_ground,
      highest_ground, in_file(file, common->first, metres));
}

/// Values that programs write for no data.
bool is_code_of_no_data(double value) {
  static constexpr std::array codes = {-9999.0, -99999.0, -999.0,  -32768.0, -32767.0,
                                       9999.0,  99999.0,  32767.0, 65535.0};
  return std::find(codes.begin(), codes.end(), value) != codes.end();
}

struct LonelyHeight {
  std::string text;
  bool is_code = false;  ///< no ground
};

/// One value far below or above all other heights: a code of no data in any number of cells, or 0 and the
/// like in several. No cliff does that, because grids have cells on its face.
std::vector<LonelyHeight> lonely_heights(const RasterFile& file, double metres) {
  constexpr double far = 100;  // m
  std::vector<LonelyHeight> found;
  for (const double sign : {1.0, -1.0}) {  // the lowest, then the highest
    double end = std::numeric_limits<double>::infinity(), next = end;
    std::size_t count = 0;
    for (const double height : file.grid.heights) {
      const double z = sign * height;
      if (z < end) {
        next = end;
        end = z;
        count = 1;
      } else if (z == end) {
        ++count;
      } else if (z < next) {
        next = z;
      }
    }
    if (!std::isfinite(next) || next - end <= far) continue;
    const double value = std::stod(fmt::format("{:.10g}", in_file(file, sign * end, metres)));
    const bool is_code = is_code_of_no_data(value);
    if (count < 2 && !is_code) continue;
    found.push_back(
        {fmt::format("{} cell{} {:.10g} m, {:.0f} m {} all others: write `no_data: {:.10g}` if {} no data",
                     count, count == 1 ? " is" : "s are", sign * end, next - end,
                     sign > 0 ? "below" : "above", value, count == 1 ? "it has" : "these cells have"),
         is_code});
  }
  return found;
}

/// Cells that lie more than 100 m above or below all cells about them, whatever their value: a ground has
/// slopes between its cells.
std::vector<LonelyHeight> lonely_cells(const RasterFile& file, double metres) {
  constexpr double far = 100;  // m
  const HeightGrid& grid = file.grid;
  const auto least_step = [&](int row, int column) {
    double least = infinite;
    for (int r = std::max(0, row - 1); r <= std::min(grid.rows - 1, row + 1); ++r)
      for (int c = std::max(0, column - 1); c <= std::min(grid.columns - 1, column + 1); ++c)
        if ((r != row || c != column) && !std::isnan(grid.at(c, r)))
          least = std::min(least, std::abs(grid.at(c, r) - grid.at(column, row)));
    return std::isfinite(least) ? least : 0;
  };
  std::size_t count = 0;
  bool are_equal = true;
  int first_row = 0, first_column = 0;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      if (std::isnan(grid.at(column, row)) || !(least_step(row, column) > far)) continue;
      if (count++ == 0) {
        first_row = row;
        first_column = column;
      }
      are_equal = are_equal && grid.at(column, row) == grid.at(first_column, first_row);
    }
  if (count == 0) return {};
  const double z = grid.at(first_column, first_row);
  const Vec2 place = grid.corner + grid.cell * Vec2(first_column, first_row);
  const std::string cure = are_equal
                               ? fmt::format("write `no_data: {:.10g}` if {} no data",
                                             in_file(file, z, metres), count == 1 ? "it has" : "they have")
                               : "they have different values: mend them in the program that made the grid";
  return {{fmt::format(
      "{} cell{} more than {:.0f} m above or below all cells about {}; {} at ({:.10g}, {:.10g}) is "
      "{:.10g} m, {:.0f} m from the nearest: {}",
      count, count == 1 ? " lies" : "s lie", far, count == 1 ? "it" : "them",
      count == 1 ? "that" : "the first", place.x(), place.y(), z, least_step(first_row, first_column),
      cure)}};
}

class RasterTerrain : public SurveyedTerrain {
 public:
  explicit RasterTerrain(Params& params) : file_(params.text("file")), unit_(params.text("unit")) {
    params.require_dimension(3);
    scale_ = params.constant("scale");
    if (params.slot("no_data") >= 0) no_data_ = params.constant("no_data");
    if (params.slot("fill") >= 0) fill_ = static_cast<int>(params.constant("fill"));
    plan_unit_ = params.text("plan_unit");
  }

  TerrainShape3 build_3d(Values, RandomStream&) const override {
    RasterFile read = read_raster_file("plugin raster", file_, no_data_);
    plan_to_metres(read);
    const double metres = heights_to_metres(read);
    if (const std::string wrong = impossible_heights(read, metres); !wrong.empty()) fail(wrong);
    std::vector<LonelyHeight> lonely = lonely_heights(read, metres);
    for (const LonelyHeight& one : lonely)
      if (one.is_code) fail(one.text);
    if (lonely.empty()) lonely = lonely_cells(read, metres);
    for (LonelyHeight& one : lonely) read.notes.push_back(std::move(one.text));
    if (fill_ > 0)
      if (const FilledVoids filled = fill_voids(read.grid, fill_); filled.count > 0)
        read.notes.push_back(fmt::format("filled {} void{} of {} cell{} in all", filled.count,
                                         filled.count == 1 ? "" : "s", filled.cells,
                                         filled.cells == 1 ? "" : "s"));
    if (const std::string wrong = fault(read.grid); !wrong.empty()) fail(wrong);
    report_ = {fmt::format("{} cells of {:.6g} m, {}", with_commas(read.grid.heights.size()), read.grid.cell,
                           heights_of(read.grid)),
               read.crs,
               is_converted(),
               {}};
    for (const std::string& note : read.notes) report_.notes.push_back(fmt::format("{}: {}", file_, note));
    return std::move(read.grid);
  }

  SurveyReport report() const override { return report_; }

 private:
  [[noreturn]] void fail(const std::string& text) const {
    throw PluginError(fmt::format("plugin raster: {}: {}", file_, text));
  }

  void plan_to_metres(RasterFile& read) const {
    if (plan_unit_.empty() && !read.plan_unit.empty() && read.plan_unit != "m")
      fail(fmt::format(
          "its coordinates are in {}: write `plan_unit: {}`, which converts them to m (places of the "
          "scenario are then in m too), or project the grid first",
          read.plan_unit == "ft" ? "feet" : "US survey feet", read.plan_unit));
    if (!is_converted()) return;
    read.grid.cell *= metres_in(plan_unit_);
    read.grid.corner *= metres_in(plan_unit_);
    read.crs.clear();
  }

  bool is_converted() const { return !plan_unit_.empty() && plan_unit_ != "m"; }

  /// Returns the metres of one unit.
  double heights_to_metres(RasterFile& read) const {
    const bool is_plan_in_feet = !read.plan_unit.empty() && read.plan_unit != "m";
    if (unit_.empty() && read.height_unit.empty() && is_plan_in_feet)
      fail(fmt::format(
          "its coordinates are in feet, and it does not say the unit of its heights: write `unit: {}` or "
          "`unit: m`",
          read.plan_unit));
    if (unit_.empty() && !read.unknown_height_unit.empty())
      fail(fmt::format(
          "its heights have the unit `{}`, which is not known: write `unit: m`, `ft` or `us_ft`, and "
          "`scale` where one of its numbers is not one of these",
          read.unknown_height_unit));
    const std::string& unit = unit_.empty() ? read.height_unit : unit_;
    const double metres = scale_ * (unit.empty() ? 1 : metres_in(unit));
    if (metres != 1)
      for (double& z : read.grid.heights) z *= metres;
    return metres;
  }

  std::string file_, unit_, plan_unit_;
  double scale_ = 1;
  std::optional<double> no_data_;
  int fill_ = 0;                 ///< cells
  mutable SurveyReport report_;  ///< of the last build_3d
};

}  // namespace

std::unique_ptr<TerrainModel> make_raster(Params& params) { return std::make_unique<RasterTerrain>(params); }

}  // namespace flyrock::plugins
