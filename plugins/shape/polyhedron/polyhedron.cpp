#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

#include "geometry/convex_fault.h"
#include "geometry/hull.h"
#include "plugin/models.h"
#include "plugins/factories.h"
#include "plugins/read_points.h"
#include "plugins/terrain/mesh/mesh_file.h"
#include "random/stream.h"
#include "units/units.h"

namespace flyrock::plugins {

namespace {

bool has_ending(const std::string& path, std::string_view ending) { return lower(path).ends_with(ending); }

/// Whether a file is a surface; an OBJ file may list vertices only.
bool has_faces(const std::string& path) {
  if (has_ending(path, ".stl") || has_ending(path, ".ply")) return true;
  if (!has_ending(path, ".obj")) return false;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("f ")) return true;
  return false;
}

/// The surface of a file is that of its hull.
Contactor3 hull_of_surface(const std::string& path) {
  const MeshFile file = read_mesh("polyhedron", path);
  const Contactor3 hull = convex_hull(file.mesh.vertices);
  if (const std::string wrong = convex_fault(file.mesh, hull, file.lines); !wrong.empty())
    throw PluginError(
        fmt::format("plugin polyhedron: {}: {}; expected a closed convex surface, a `compound` of convex "
                    "parts, or a file "
                    "without faces, of whose points the hull is taken",
                    path, wrong));
  return hull;
}

const std::vector<TableColumn>& columns_of_points() {
  static const std::vector<TableColumn> columns = {
      {.name = "x", .dimension = dimension::length, .required = true},
      {.name = "y", .dimension = dimension::length, .required = true},
      {.name = "z", .dimension = dimension::length, .required = true}};
  return columns;
}

Contactor3 hull_of(Params& params) {
  std::vector<Vec3> points = params.points3("points");
  const std::string file = params.text("file");
  if (params.given("points") == params.given("file"))
    throw PluginError("plugin polyhedron: expected either `points` or a `file`");
  if (params.given("file")) {
    if (has_faces(file)) return hull_of_surface(file);
    if (file.ends_with(".obj")) return convex_hull(read_obj_points("polyhedron", file));
    for (const auto& point : read_points("polyhedron", file, columns_of_points()).points)
      points.emplace_back(point[0], point[1], point[2]);
  }
  return convex_hull(points);
}

class Polyhedron : public ShapeModel {
 public:
  explicit Polyhedron(Params& params) {
    params.require_dimension(3);
    try {
      hull_ = hull_of(params);
    } catch (const std::invalid_argument& fault) {
      throw PluginError(std::string("plugin polyhedron: ") + fault.what());
    }
  }
  std::vector<Contactor3> build_3d(Values, RandomStream&) const override { return {hull_}; }

 private:
  Contactor3 hull_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_polyhedron(Params& params) { return std::make_unique<Polyhedron>(params); }

}  // namespace flyrock::plugins
