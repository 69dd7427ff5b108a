#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/delaunay.h"
#include "geometry/mesh_edges.h"
#include "geometry/mesh_fault.h"
#include "geometry/terrain_fault.h"
#include "plugins/factories.h"
#include "survey/fill_voids.h"
#include "survey/mesh_repair.h"
#include "survey/point_cloud.h"
#include "survey/surveyed_terrain.h"

namespace flyrock::plugins {

namespace {

constexpr double most_cells = 2.5e7;
constexpr std::size_t most_triangulated = 2'000'000;

/// A void inside of a grid: cells without data that touch at sides or corners and do not reach its outline.
struct InnerVoid {
  Vec2 low = Vec2::Constant(infinite), high = Vec2::Constant(-infinite);  ///< columns and rows
};

std::vector<InnerVoid> inner_voids(const HeightGrid& grid) {
  std::vector<bool> is_seen(grid.heights.size());
  std::vector<InnerVoid> found;
  std::vector<std::pair<int, int>> open;
  const auto visit = [&](int column, int row) {
    const std::size_t at = static_cast<std::size_t>(row) * grid.columns + column;
    if (is_seen[at] || !std::isnan(grid.heights[at])) return;
    is_seen[at] = true;
    open.emplace_back(column, row);
  };
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      visit(column, row);
      InnerVoid one;
      bool is_inside = true;
      while (!open.empty()) {
        const auto [c, r] = open.back();
        open.pop_back();
        one.low = one.low.cwiseMin(Vec2(c, r));
        one.high = one.high.cwiseMax(Vec2(c, r));
        is_inside = is_inside && c > 0 && r > 0 && c + 1 < grid.columns && r + 1 < grid.rows;
        for (int y = std::max(r - 1, 0); y <= std::min(r + 1, grid.rows - 1); ++y)
          for (int x = std::max(c - 1, 0); x <= std::min(c + 1, grid.columns - 1); ++x) visit(x, y);
      }
      if (one.low.x() < infinite && is_inside) found.push_back(one);
    }
  return found;
}

class PointsTerrain : public SurveyedTerrain {
 public:
  explicit PointsTerrain(Params& params) : file_(params.text("file")) {
    params.require_dimension(3);
    scale_ = params.constant("scale");
    if (params.slot("class") >= 0) class_ = static_cast<int>(params.constant("class"));
    if (params.slot("cell") >= 0) cell_ = params.constant("cell");
    if (params.slot("max_gap") >= 0) max_gap_ = params.constant("max_gap");
    const bool triangulate = params.constant("triangulate") != 0;
    if (triangulate == (cell_ > 0)) fail("expected either `cell` or `triangulate: true`");
    if (triangulate && !(max_gap_ > 0)) fail("`triangulate` needs `max_gap`, the longest side of a triangle");
  }

  TerrainShape3 build_3d(Values, RandomStream&) const override {
    PointCloud cloud = read_point_cloud("plugin points", file_, class_);
    if (!cloud.plan_unit.empty() && cloud.plan_unit != "m" && scale_ == 1)
      fail(fmt::format(
          "its coordinates are in feet: write `scale: {}`, which makes metres of them; places of the "
          "scenario are then in metres too",
          cloud.plan_unit == "ft" ? "0.3048" : "0.3048006096"));
    for (Vec3& place : cloud.points) {
      place *= scale_;
      if (!is_height_of_ground(place.z()))
        fail(fmt::format(
            "a point has the height {:.10g} m, below {:g} m or above {:g} m, which no ground has; write "
            "`class: 2` if the file has classes, or `scale` if it is not in m",
            place.z(), lowest_ground, highest_ground));
    }
    report_ = {{}, scale_ == 1 ? cloud.crs : "", scale_ != 1, {}};
    for (const std::string& note : cloud.notes) say(note);
    const std::string count =
        cloud.points.size() == cloud.all
            ? fmt::format("{} points", with_commas(cloud.all))
            : fmt::format("{} of {} points", with_commas(cloud.points.size()), with_commas(cloud.all));
    return cell_ > 0 ? TerrainShape3(grid_of(cloud.points, count))
                     : TerrainShape3(mesh_of(cloud.points, count));
  }

  SurveyReport report() const override { return report_; }

 private:
  [[noreturn]] void fail(const std::string& text) const {
    throw PluginError(fmt::format("plugin points: {}: {}", file_, text));
  }
  void say(const std::string& text) const { report_.notes.push_back(fmt::format("{}: {}", file_, text)); }

  /// The mean height of the points in each cell.
  HeightGrid grid_of(const std::vector<Vec3>& points, const std::string& count) const {
    Vec2 low = Vec2::Constant(infinite), high = -low;
    for (const Vec3& place : points) {
      low = low.cwiseMin(place.head<2>());
      high = high.cwiseMax(place.head<2>());
    }
    const Vec2 size = ((high - low) / cell_).array().round() + 1;
    if (!(size.x() * size.y() <= most_cells))
      fail(fmt::format("makes {:.0f} x {:.0f} cells of {:.6g} m, expected at most {:g}: take larger cells",
                       size.x(), size.y(), cell_, most_cells));
    HeightGrid grid;
    grid.columns = static_cast<int>(size.x());
    grid.rows = static_cast<int>(size.y());
    grid.cell = cell_;
    grid.corner = low;
    std::vector<double> sums(static_cast<std::size_t>(grid.columns) * grid.rows, 0);
    std::vector<unsigned> counts(sums.size(), 0);
    for (const Vec3& place : points) {
      const Vec2 at = ((place.head<2>() - low) / cell_).array().round();
      const std::size_t index =
          static_cast<std::size_t>(at.y()) * grid.columns + static_cast<std::size_t>(at.x());
      sums[index] += place.z();
      ++counts[index];
    }
    grid.heights.resize(sums.size());
    for (std::size_t i = 0; i < sums.size(); ++i)
      grid.heights[i] = counts[i] > 0 ? sums[i] / counts[i] : std::nan("");
    fill(grid);
    if (const std::string wrong = fault(grid); !wrong.empty()) fail(wrong);
    report_.size = fmt::format("{}, {} cells of {:.6g} m, {}", count, with_commas(grid.heights.size()), cell_,
                               heights_of(grid));
    return grid;
  }

  void fill(HeightGrid& grid) const {
    if (const int most = static_cast<int>(std::min(max_gap_ / cell_ + 1e-9, 1000.0)); most > 0)
      if (const FilledVoids filled = fill_voids(grid, most); filled.count > 0)
        say(fmt::format("filled {} void{} of {} cell{} in all", filled.count, filled.count == 1 ? "" : "s",
                        filled.cells, filled.cells == 1 ? "" : "s"));
    const std::vector<InnerVoid> left = inner_voids(grid);
    if (left.empty()) return;
    const auto width = [&](const InnerVoid& one) { return cell_ * ((one.high - one.low).maxCoeff() + 1); };
    const InnerVoid& widest = *std::max_element(
        left.begin(), left.end(), [&](const auto& a, const auto& b) { return width(a) < width(b); });
    const Vec2 middle = grid.corner + cell_ / 2 * (widest.low + widest.high);
    say(fmt::format(
        "{} void{} inside of the points {} no ground, the widest of {:.6g} m about ({:.10g}, {:.10g}): "
        "`max_gap: {:.6g} m` fills {}",
        left.size(), left.size() == 1 ? "" : "s", left.size() == 1 ? "has" : "have", width(widest),
        middle.x(), middle.y(), width(widest), left.size() == 1 ? "it" : "them"));
  }

  /// Triangles with sides of at most `max_gap`.
  Mesh mesh_of(const std::vector<Vec3>& points, const std::string& count) const {
    if (points.size() > most_triangulated)
      fail(fmt::format("has {} points to triangulate, expected at most {}: take `cell`", points.size(),
                       most_triangulated));
    std::vector<Vec2> plan;
    for (const Vec3& place : points) plan.emplace_back((place - points.front()).head<2>());
    Mesh mesh;
    mesh.vertices = points;
    mesh.parts = {""};
    try {
      for (const std::array<int, 3>& corners : delaunay(plan)) {
        double longest = 0;
        for (int k = 0; k < 3; ++k)
          longest = std::max(longest, (plan[corners[k]] - plan[corners[(k + 1) % 3]]).norm());
        if (longest <= max_gap_) mesh.triangles.push_back(corners);
      }
    } catch (const std::invalid_argument& wrong) {
      fail(wrong.what());
    }
    if (mesh.triangles.empty())
      fail(fmt::format("no triangle has sides of at most {:.6g} m: write a greater `max_gap`", max_gap_));
    mesh.part.assign(mesh.triangles.size(), 0);
    mesh = welded(std::move(mesh));
    std::vector<int> lines;
    MeshRepair repair;
    repair.keep_largest = true;
    for (const std::string& note : mend(mesh, lines, repair)) say(note);
    for (const MeshFault& wrong : faults(mesh))
      fail(fmt::format("{}; write a greater `max_gap`, or `cell`, where voids have no ground", wrong.text));
    report_.size =
        fmt::format("{}, {} triangles, {}", count, with_commas(mesh.triangles.size()), heights_of(mesh));
    return mesh;
  }

  std::string file_;
  std::optional<int> class_;
  double cell_ = 0, max_gap_ = 0, scale_ = 1;
  mutable SurveyReport report_;  ///< of the last build_3d
};

}  // namespace

std::unique_ptr<TerrainModel> make_points(Params& params) { return std::make_unique<PointsTerrain>(params); }

}  // namespace flyrock::plugins
