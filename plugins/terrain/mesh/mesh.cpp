#include <fmt/format.h>

#include "geometry/mesh_fault.h"
#include "plugins/factories.h"
#include "plugins/terrain/mesh/mesh_file.h"

namespace flyrock::plugins {

namespace {

class MeshTerrain : public TerrainModel {
 public:
  explicit MeshTerrain(Params& params)
      : file_(params.text("file")), y_is_up_(params.text("up") == "y"), scale_(params.slot("scale")) {
    params.require_dimension(3);
  }

  TerrainShape3 build_3d(Values values, RandomStream&) const override {
    MeshFile read = read_mesh("mesh", file_);
    Mesh mesh = to_metres("mesh", std::move(read.mesh), values[scale_], y_is_up_);
    if (const std::string wrong = fault(mesh, read.lines); !wrong.empty())
      throw PluginError(fmt::format("plugin mesh: {}: {}", file_, wrong));
    return mesh;
  }

 private:
  std::string file_;
  bool y_is_up_;
  int scale_;
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
