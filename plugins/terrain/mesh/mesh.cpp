#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plugins/factories.h"
#include "plugins/terrain/mesh/mesh_file.h"
#include "survey/mesh_gaps.h"
#include "survey/mesh_repair.h"
#include "survey/surveyed_terrain.h"
#include "units/units.h"

namespace flyrock::plugins {

namespace {

/// A length with two digits, rounded up.
std::string rounded_up(double length) {
  const double unit = std::pow(10.0, std::floor(std::log10(length)) - 1);
  return fmt::format("{:.6g} m", std::ceil(length / unit * 1.05) * unit);
}

/// What to write in the scenario, or to do in the program of the survey.
std::string cure_of(const MeshFault& fault) {
  constexpr double least_weld = 1e-4;  // m, for gaps by rounding
  switch (fault.kind) {
    case MeshFault::Kind::gap:
      return fmt::format("`repair: {{ weld: {} }}` joins them", rounded_up(std::max(fault.size, least_weld)));
    case MeshFault::Kind::over:
      return "cut them to one in the program that made them, or write `repair: { keep: largest }`";
    case MeshFault::Kind::hole:
      return fault.size <= 200 ? fmt::format("`repair: {{ fill_holes: {:.0f} }}` fills it", fault.size)
                               : "close it in the program that made it";
    case MeshFault::Kind::down:
      return "if y points up in the file, write `up: y`";
    case MeshFault::Kind::flipped:
      return "turn its normals outwards in the program that made it (Blender: Recalculate Outside; MeshLab: "
             "Re-Orient all faces coherently)";
    default:
      return "clean the mesh in the program that made it";
  }
}

class MeshTerrain : public SurveyedTerrain {
 public:
  explicit MeshTerrain(Params& params)
      : file_(params.text("file")), y_is_up_(params.text("up") == "y"), scale_(params.slot("scale")) {
    params.require_dimension(3);
    surface_ = params.text("surface");
    if (params.slot("repair.weld") >= 0) repair_.weld = params.constant("repair.weld");
    if (params.slot("repair.fill_holes") >= 0)
      repair_.fill_holes = static_cast<int>(params.constant("repair.fill_holes"));
    repair_.keep_largest = params.text("repair.keep") == "largest";
    const std::string parts = params.text("parts");
    parts_ = parts == "groups"      ? PartsOf::groups
             : parts == "materials" ? PartsOf::materials
                                    : PartsOf::either;
  }

  TerrainShape3 build_3d(Values values, RandomStream&) const override {
    const bool is_landxml = lower(file_).ends_with(".xml"), is_drawing = lower(file_).ends_with(".dxf");
    if (!is_landxml && !is_drawing && !surface_.empty())
      throw PluginError(fmt::format(
          "plugin mesh: {}: `surface` names one of LandXML (.xml), or a layer of a drawing (.dxf)", file_));
    MeshFile read = is_landxml   ? read_landxml("mesh", file_, surface_)
                    : is_drawing ? read_dxf("mesh", file_, surface_)
                                 : read_mesh("mesh", file_, parts_);
    if (is_landxml && y_is_up_)
      throw PluginError(fmt::format("plugin mesh: {}: in LandXML z is the height, leave `up` out", file_));
    if (read.unit > 0 && values[scale_] != 1)
      throw PluginError(
          fmt::format("plugin mesh: {}: says its unit, {:.10g} m, leave `scale` out", file_, read.unit));
    Mesh mesh = to_metres("mesh", std::move(read.mesh), values[scale_], y_is_up_);
    report_ = {};
    report_.is_converted = read.unit > 0 && read.unit != 1;
    if (!report_.is_converted) report_.crs = read.crs;
    report_.notes = std::move(read.notes);
    for (std::string& note : mend(mesh, read.lines, repair_)) report_.notes.push_back(std::move(note));
    for (std::string& note : report_.notes) note = fmt::format("{}: {}", file_, note);
    refuse(mesh, read.lines);
    report_.size = fmt::format("{} triangles, {}", with_commas(mesh.triangles.size()), heights_of(mesh));
    return mesh;
  }

  SurveyReport report() const override { return report_; }

 private:
  /// All faults at once, each with what to write.
  void refuse(const Mesh& mesh, const std::vector<int>& lines) const {
    if (mesh.triangles.empty())
      throw PluginError(fmt::format("plugin mesh: {}: no triangle has an area", file_));
    refuse_heights(mesh, lines);
    std::vector<MeshFault> found = faults(mesh, lines);
    if (found.empty() || found.front().kind != MeshFault::Kind::broken)
      for (MeshFault& gap : gap_faults(mesh, lines)) found.push_back(std::move(gap));
    double widest = 0;  // one weld must join all gaps
    for (const MeshFault& one : found)
      if (one.kind == MeshFault::Kind::gap) widest = std::max(widest, one.size);
    for (MeshFault& one : found)
      if (one.kind == MeshFault::Kind::gap) one.size = widest;
    constexpr std::size_t most = 20;
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < std::min(most, found.size()); ++i)
      texts.push_back(fmt::format("plugin mesh: {}: {}; {}", file_, found[i].text, cure_of(found[i])));
    if (found.size() > most)
      texts.push_back(fmt::format("plugin mesh: {}: {} more faults", file_, found.size() - most));
    if (!texts.empty()) throw FileFaults(std::move(texts));
  }

  /// Heights that no ground has, because of another unit or another axis.
  void refuse_heights(const Mesh& mesh, const std::vector<int>& lines) const {
    std::size_t count = 0;
    std::string first;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (const int corner : mesh.triangles[t]) {
        const double z = mesh.vertices[corner].z();
        if (is_height_of_ground(z) || count++ > 0) continue;
        first = fmt::format("a corner{} has the height {:.10g} m", lines_text(lines, static_cast<int>(t)), z);
      }
    if (count == 0) return;
    throw PluginError(
        fmt::format("plugin mesh: {}: {}, and {} corners in all are below {:g} m or above {:g} m, which no "
                    "ground is; write "
                    "`up: y` if y points up in the file, or `scale` if it is not in m",
                    file_, first, count, lowest_ground, highest_ground));
  }

  std::string file_, surface_;
  bool y_is_up_;
  int scale_;
  PartsOf parts_ = PartsOf::either;
  MeshRepair repair_;
  mutable SurveyReport report_;  ///< of the last build_3d
};

}  // namespace

Mesh to_metres(const std::string& plugin, Mesh mesh, double scale, bool y_is_up) {
  if (!(scale > 0))
    throw PluginError(fmt::format("plugin {}: scale is {:.6g}, must be above 0", plugin, scale));
  for (Vec3& vertex : mesh.vertices) {
    if (y_is_up) vertex = Vec3(vertex.x(), -vertex.z(), vertex.y());
    vertex *= scale;
  }
  return mesh;
}

std::unique_ptr<TerrainModel> make_mesh(Params& params) { return std::make_unique<MeshTerrain>(params); }

}  // namespace flyrock::plugins
