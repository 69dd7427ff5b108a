#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "geometry/fill_voids.h"
#include "geometry/terrain_fault.h"
#include "plugin/raster_file.h"
#include "plugin/surveyed_terrain.h"
#include "plugins/factories.h"

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
    for (LonelyHeight& lonely : lonely_heights(read, metres)) {
      if (lonely.is_code) fail(lonely.text);
      read.notes.push_back(std::move(lonely.text));
    }
    if (fill_ > 0)
      if (const FilledVoids filled = fill_voids(read.grid, fill_); filled.count > 0)
        read.notes.push_back(fmt::format("filled {} void{} of {} cell{} in all", filled.count,
                                         filled.count == 1 ? "" : "s", filled.cells,
                                         filled.cells == 1 ? "" : "s"));
    if (const std::string wrong = fault(read.grid); !wrong.empty()) fail(wrong);
    report_ = {fmt::format("{} cells of {:.6g} m, {}", with_commas(read.grid.heights.size()), read.grid.cell,
                           heights_of(read.grid)),
               read.crs,
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
    if (plan_unit_.empty() || plan_unit_ == "m") return;
    read.grid.cell *= metres_in(plan_unit_);
    read.grid.corner *= metres_in(plan_unit_);
  }

  /// Returns the metres of one unit.
  double heights_to_metres(RasterFile& read) const {
    const bool is_plan_in_feet = !read.plan_unit.empty() && read.plan_unit != "m";
    if (unit_.empty() && read.height_unit.empty() && is_plan_in_feet)
      fail(fmt::format(
          "its coordinates are in feet, and it does not say the unit of its heights: write `unit: {}` or "
          "`unit: m`",
          read.plan_unit));
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
