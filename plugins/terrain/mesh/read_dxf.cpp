// DXF: a drawing of CAD, whose 3D faces (entities 3DFACE, and POLYLINE as a polyface mesh) are the ground.
// The module of GDAL reads it. Corners have no order that programs keep to, so neighbours decide which side
// is up.

#include <fmt/format.h>

#include <algorithm>

#include "geometry/mesh_edges.h"
#include "plugin/params.h"
#include "plugins/terrain/mesh/mesh_file.h"
#include "survey/mesh_winding.h"
#include "survey/vector_file.h"

namespace flyrock::plugins {

namespace {

VectorLayer drawing(const std::string& plugin, const std::string& path, const std::string& layer) try {
  return read_vector_layer(path, layer, "",
                           "export its triangulation (3D faces) as OBJ, with three decimals or more");
} catch (const PluginError& error) {
  throw PluginError(fmt::format("plugin {}: {}", plugin, error.what()));
}

bool is_face(const VectorPart& part) {
  return part.form == FeatureForm::region && part.has_heights && part.lines.size() == 1 &&
         part.lines.front().size() > 2;
}

std::string layer_of(const VectorPart& part) {
  for (const auto& [name, value] : part.attributes)
    if (name == layer_of_drawing) return value;
  return {};
}

/// The number of a name among `names`, where it is put if it is new.
int number_of(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  const auto number = static_cast<int>(found - names.begin());
  if (found == names.end()) names.push_back(name);
  return number;
}

}  // namespace

MeshFile read_dxf(const std::string& plugin, const std::string& path, const std::string& layer) {
  const VectorLayer read = drawing(plugin, path, layer);
  MeshFile file;
  Mesh& mesh = file.mesh;
  std::size_t others = 0;
  for (const VectorPart& part : read.parts) {
    if (!is_face(part)) {
      ++others;
      continue;
    }
    std::vector<int> face;
    for (const Vec3& corner : part.lines.front()) {
      face.push_back(static_cast<int>(mesh.vertices.size()));
      mesh.vertices.push_back(corner);
    }
    if (const std::string wrong = add_fan(file, face, 0); !wrong.empty())
      throw PluginError(fmt::format("plugin {}: {}: entity {}: {}", plugin, path, part.feature, wrong));
    mesh.part.resize(mesh.triangles.size(), number_of(mesh.parts, part_name(layer_of(part))));
  }
  if (mesh.triangles.empty())
    throw PluginError(fmt::format(
        "plugin {}: {}: has no 3D faces, expected entities 3DFACE or a polyface mesh: triangulate its points "
        "and contour lines in the program that made it",
        plugin, path));
  if (others > 0)
    file.notes.push_back(fmt::format("{} of its entities are no 3D faces and were left out", others));
  join_equal_places(mesh);
  wind_alike(mesh);
  mesh = welded(std::move(mesh));
  return file;
}

}  // namespace flyrock::plugins
