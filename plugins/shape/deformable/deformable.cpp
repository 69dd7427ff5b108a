#include "geometry/deformable.h"

#include <fmt/format.h>

#include <cmath>

#include "geometry/contactor.h"
#include "geometry/contactor3.h"
#include "geometry/mesh.h"
#include "plugin/models.h"
#include "plugins/factories.h"
#include "plugins/shape/deformable/gmsh_file.h"
#include "random/stream.h"

namespace flyrock::plugins {

namespace {

/// A rectangle, disk, box or given mesh of finite elements. The contactors fill it.
class DeformableShape : public ShapeModel {
 public:
  explicit DeformableShape(Params& params)
      : form_(form_of(params)),
        size_(params.vector_slot("size")),
        cells_(params.slot("cells")),
        radius_(params.slot("radius")),
        rings_(params.slot("rings")),
        scale_(params.slot("scale")),
        young_(params.slot("young")),
        poisson_(params.slot("poisson")),
        alpha_(params.slot("damping.alpha")),
        beta_(params.slot("damping.beta")),
        strength_(params.slot("tensile_strength")) {
    const auto needs = [&](bool given, const char* name, bool wanted) {
      if (given == wanted) return;
      throw PluginError(fmt::format("plugin deformable: `{}` {} `form: {}`", name,
                                    wanted ? "is needed with" : "is given, not expected with",
                                    params.text("form")));
    };
    const std::string file = params.text("mesh");
    const bool has_sides = form_ == DeformableForm::rectangle || form_ == DeformableForm::box;
    needs(size_ >= 0, "size", has_sides);
    needs(cells_ >= 0, "cells", has_sides);
    needs(radius_ >= 0, "radius", form_ == DeformableForm::disk);
    needs(rings_ >= 0, "rings", form_ == DeformableForm::disk);
    needs(params.given("mesh"), "mesh", form_ == DeformableForm::mesh);
    if (form_ != DeformableForm::mesh) return;
    if (params.dimension() == 2)
      mesh_ = std::make_shared<const GivenMesh<2>>(read_gmsh<2>(file));
    else
      solid_mesh_ = std::make_shared<const GivenMesh<3>>(read_gmsh<3>(file));
  }

  std::vector<Contactor2> build(Values values, RandomStream&) const override {
    return contactors(block_of<2>(values));
  }
  std::vector<Contactor3> build_3d(Values values, RandomStream&) const override {
    return contactors(block_of<3>(values));
  }
  ShapeAnswer<2> shape(Values values, RandomStream&) const override { return answer(block_of<2>(values)); }
  ShapeAnswer<3> shape_3d(Values values, RandomStream&) const override { return answer(block_of<3>(values)); }

 private:
  static DeformableForm form_of(Params& params) {
    const std::string name = params.text("form");
    if (name == "mesh") return DeformableForm::mesh;
    const bool in_plane = params.dimension() == 2;
    if (in_plane == (name == "box"))
      throw PluginError(fmt::format("plugin deformable: `form: {}` belongs to {}, expected {}", name,
                                    in_plane ? "3D" : "2D",
                                    in_plane ? "`rectangle`, `disk` or `mesh`" : "`box` or `mesh`"));
    return name == "disk" ? DeformableForm::disk : in_plane ? DeformableForm::rectangle : DeformableForm::box;
  }

  template <int D>
  static ShapeAnswer<D> answer(const Deformable<D>& block) {
    ShapeAnswer<D> answer{contactors(block)};
    answer.deformable = block;
    return answer;
  }

  /// The polygon about it, or the triangles of a given mesh.
  static std::vector<Contactor2> contactors(const Deformable<2>& block) {
    if (block.form == DeformableForm::mesh) return triangles(block);
    std::vector<Vec2> corners;
    if (block.form == DeformableForm::disk) {
      for (int i = 0; i < 6 * block.rings; ++i) {
        const double angle = 2 * pi * i / (6 * block.rings);
        corners.emplace_back(block.radius * Vec2(std::cos(angle), std::sin(angle)));
      }
    } else {
      const Vec2 half = 0.5 * block.size;
      corners = {-half, {half.x(), -half.y()}, half, {-half.x(), half.y()}};
    }
    return {Contactor2::polygon(std::move(corners))};
  }
  /// The box, or the surface of a given mesh.
  static std::vector<Contactor3> contactors(const Deformable<3>& block) {
    if (block.form != DeformableForm::mesh) return {Contactor3::box(block.size)};
    Mesh surface;
    for (const Vec3& node : block.mesh->nodes) surface.vertices.push_back(block.scale * node);
    surface.triangles = block.mesh->sides;
    return {Contactor3::cloud(surface)};
  }

  static std::vector<Contactor2> triangles(const Deformable<2>& block) {
    std::vector<Contactor2> list;
    for (const auto& [a, b, c] : block.mesh->cells) {
      const auto& nodes = block.mesh->nodes;
      list.push_back(Contactor2::polygon({block.scale * nodes[static_cast<std::size_t>(a)],
                                          block.scale * nodes[static_cast<std::size_t>(b)],
                                          block.scale * nodes[static_cast<std::size_t>(c)]}));
    }
    return list;
  }

  template <int D>
  Deformable<D> block_of(Values values) const {
    Deformable<D> block;
    block.form = form_;
    block.scale = values[scale_];
    block.young = values[young_];
    block.poisson = values[poisson_];
    if (alpha_ >= 0) block.alpha = values[alpha_];
    if (beta_ >= 0) block.beta = values[beta_];
    if constexpr (D == 2)
      block.mesh = mesh_;
    else
      block.mesh = solid_mesh_;
    if (strength_ >= 0) block.tensile_strength = values[strength_];
    if (form_ == DeformableForm::disk) {
      block.radius = values[radius_];
      check_nodes<D>(1 + 3 * values[rings_] * (values[rings_] + 1), "rings");
      block.rings = static_cast<int>(values[rings_]);
    } else if (form_ != DeformableForm::mesh) {
      for (int k = 0; k < D; ++k) block.size[k] = values[size_ + k];
      const double cell = block.size.minCoeff() / values[cells_];
      const Vec<D> along = (block.size / cell).array().round();
      const double corners = (along.array() + 1).prod();
      check_nodes<D>(D == 2 ? corners + along.prod() : corners, "cells");  // in 2D also the middles
      for (int k = 0; k < D; ++k) block.cells[static_cast<std::size_t>(k)] = static_cast<int>(along[k]);
    }
    return block;
  }

  template <int D>
  static void check_nodes(double nodes, const char* name) {
    if (nodes > most_mesh_nodes<D>)
      throw ParameterError(
          fmt::format("plugin deformable: the mesh has {:.0f} nodes, expected at most {}: fewer `{}`", nodes,
                      most_mesh_nodes<D>, name));
  }

  DeformableForm form_;
  std::shared_ptr<const GivenMesh<2>> mesh_;        ///< of the form `mesh` in 2D
  std::shared_ptr<const GivenMesh<3>> solid_mesh_;  ///< and in 3D
  int size_, cells_, radius_, rings_, scale_, young_, poisson_, alpha_, beta_, strength_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_deformable(Params& params) {
  return std::make_unique<DeformableShape>(params);
}

}  // namespace flyrock::plugins
