#include <fmt/format.h>

#include <stdexcept>

#include "geometry/contactor3.h"
#include "geometry/mesh_edges.h"
#include "geometry/mesh_fault.h"
#include "plugin/models.h"
#include "plugins/factories.h"
#include "plugins/terrain/mesh/mesh_file.h"
#include "random/stream.h"

namespace flyrock::plugins {

namespace {

class MeshPoint : public ShapeModel {
 public:
  explicit MeshPoint(Params& params)
      : file_(params.text("file")), y_is_up_(params.text("up") == "y"), scale_(params.slot("scale")) {
    params.require_dimension(3);
    read_ = read_mesh("mesh_point", file_);
    if (std::string wrong = fault(read_.mesh, read_.lines); !wrong.empty() || !is_closed())
      throw PluginError(fmt::format("plugin mesh_point: {}: {}", file_,
                                    wrong.empty() ? "the surface has a border, expected a closed one, which "
                                                    "has a volume"
                                                  : wrong));
  }

  std::vector<Contactor3> build_3d(Values values, RandomStream&) const override {
    try {
      return {Contactor3::cloud(to_metres("mesh_point", read_.mesh, values[scale_], y_is_up_))};
    } catch (const std::invalid_argument& fault) {
      throw PluginError(fmt::format("plugin mesh_point: {}: {}", file_, fault.what()));
    }
  }

 private:
  /// Whether each triangle has three neighbours, each in common with one other one.
  bool is_closed() const {
    for (const auto& around : neighbours_of(read_.mesh.triangles, sorted_sides(read_.mesh.triangles)))
      for (const int neighbour : around)
        if (neighbour < 0) return false;
    return true;
  }

  std::string file_;
  bool y_is_up_;
  int scale_;
  MeshFile read_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_mesh_point(Params& params) { return std::make_unique<MeshPoint>(params); }

}  // namespace flyrock::plugins
