#include <fmt/format.h>

#include <algorithm>

#include "geometry/box.h"
#include "geometry/contactor3.h"
#include "geometry/mesh_edges.h"
#include "geometry/mesh_fault.h"
#include "plugin/models.h"
#include "plugins/factories.h"
#include "plugins/terrain/mesh/mesh_file.h"
#include "random/stream.h"

namespace flyrock::plugins {

namespace {

double diagonal_of(const Mesh& mesh) { return Box3::around(mesh.vertices).size().norm(); }

Vec3 area_of(const Mesh& mesh, const std::array<int, 3>& triangle) {
  const Vec3& a = mesh.vertices[triangle[0]];
  return (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a);
}

/// The sides of triangles that have no neighbour, as pairs of vertices in their order.
std::vector<std::pair<int, int>> border_of(const Mesh& mesh) {
  const auto neighbours = neighbours_of(mesh.triangles, sorted_sides(mesh.triangles));
  std::vector<std::pair<int, int>> border;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (neighbours[t][k] < 0) border.emplace_back(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
  return border;
}

/// A plate of the given thickness behind a surface, with the surface as its front: a copy of it moved along
/// the mean normals of its vertices, and sides along the border. Empty if the copy folds over.
Mesh plate(const Mesh& front, const std::vector<std::pair<int, int>>& border, double thickness) {
  Mesh mesh = front;
  const int count = static_cast<int>(front.vertices.size());
  std::vector<Vec3> normals(front.vertices.size(), Vec3::Zero());
  for (const auto& triangle : front.triangles)
    for (const int vertex : triangle) normals[static_cast<std::size_t>(vertex)] += area_of(front, triangle);
  for (std::size_t i = 0; i < normals.size(); ++i)
    mesh.vertices.push_back(front.vertices[i] - thickness * normals[i].normalized());
  for (const auto& [a, b, c] : front.triangles) {
    mesh.triangles.push_back({a + count, c + count, b + count});
    if (area_of(mesh, mesh.triangles.back()).dot(area_of(front, {a, b, c})) >= 0) return {};
  }
  for (const auto& [a, b] : border) {
    mesh.triangles.push_back({b, a, a + count});
    mesh.triangles.push_back({b, a + count, b + count});
  }
  return mesh;
}

class MeshPatch : public ShapeModel {
 public:
  explicit MeshPatch(Params& params)
      : file_(params.text("file")),
        y_is_up_(params.text("up") == "y"),
        scale_(params.slot("scale")),
        thickness_(params.slot("thickness")) {
    params.require_dimension(3);
    read_ = read_mesh("mesh_patch", file_);
    if (read_.mesh.triangles.empty()) throw PluginError("plugin mesh_patch: " + file_ + ": no triangles");
    border_ = border_of(read_.mesh);
    if (border_.empty() && thickness_ >= 0)
      throw PluginError("plugin mesh_patch: `thickness` with a closed surface, expected one with a border");
  }

  std::vector<Contactor3> build_3d(Values values, RandomStream&) const override {
    Mesh mesh = to_metres("mesh_patch", read_.mesh, values[scale_], y_is_up_);
    if (!border_.empty()) mesh = thick(mesh, values);
    mesh.part.assign(mesh.triangles.size(), 0);
    mesh.parts = {""};
    std::vector<int> lines = read_.lines;
    if (!lines.empty()) lines.resize(mesh.triangles.size(), lines.back());
    if (const std::string wrong = fault(mesh, lines); !wrong.empty())
      throw PluginError(fmt::format("plugin mesh_patch: {}: {}", file_, wrong));
    return {Contactor3::solid(std::move(mesh))};
  }

 private:
  Mesh thick(const Mesh& mesh, Values values) const {
    if (thickness_ >= 0) {
      const double thickness = values[thickness_];
      if (!(thickness > 0))
        throw PluginError(
            fmt::format("plugin mesh_patch: thickness is {:.6g} m, must be above 0", thickness));
      Mesh solid = plate(mesh, border_, thickness);
      if (solid.triangles.empty())
        throw PluginError(fmt::format(
            "plugin mesh_patch: {}: thickness is {:.6g} m, too thick: the surface would fold at its bends",
            file_, thickness));
      return solid;
    }
    constexpr int most_tries = 20;
    double thickness = usual_thickness * diagonal_of(mesh);
    for (int i = 0; i < most_tries; ++i, thickness /= 2)
      if (Mesh solid = plate(mesh, border_, thickness); !solid.triangles.empty()) return solid;
    throw PluginError(fmt::format("plugin mesh_patch: {}: the surface is folded", file_));
  }

  static constexpr double usual_thickness = 0.05;  // of the diagonal of the mesh's box

  std::string file_;
  bool y_is_up_;
  int scale_, thickness_;
  MeshFile read_;
  std::vector<std::pair<int, int>> border_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_mesh_patch(Params& params) { return std::make_unique<MeshPatch>(params); }

}  // namespace flyrock::plugins
