#include "geometry/deformable.h"

#include <fmt/format.h>

#include <cmath>

#include "geometry/contactor.h"
#include "plugin/models.h"
#include "plugins/factories.h"
#include "plugins/shape/deformable/gmsh_file.h"
#include "random/stream.h"

namespace flyrock::plugins {

namespace {

/// A rectangle, disk or given mesh of finite elements. The contactors fill it: the polygon about it, or the
/// triangles of a given mesh.
class DeformableShape : public ShapeModel {
 public:
  explicit DeformableShape(Params& params)
      : form_(form_of(params.text("form"))),
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
    params.require_dimension(2);
    const auto needs = [&](bool given, const char* name, bool wanted) {
      if (given == wanted) return;
      throw PluginError(fmt::format("plugin deformable: `{}` {} `form: {}`", name,
                                    wanted ? "is missing, expected with" : "is given, not expected with",
                                    params.text("form")));
    };
    const std::string file = params.text("mesh");
    needs(size_ >= 0, "size", form_ == Deformable::Form::rectangle);
    needs(cells_ >= 0, "cells", form_ == Deformable::Form::rectangle);
    needs(radius_ >= 0, "radius", form_ == Deformable::Form::disk);
    needs(rings_ >= 0, "rings", form_ == Deformable::Form::disk);
    needs(params.given("mesh"), "mesh", form_ == Deformable::Form::mesh);
    if (form_ == Deformable::Form::mesh) mesh_ = std::make_shared<const GivenMesh>(read_gmsh(file));
  }

  std::vector<Contactor2> build(Values values, RandomStream&) const override {
    const Deformable block = block_of(values);
    if (form_ == Deformable::Form::mesh) return triangles(block);
    std::vector<Vec2> corners;
    if (form_ == Deformable::Form::disk) {
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

  ShapeAnswer<2> shape(Values values, RandomStream& rng) const override {
    ShapeAnswer<2> answer{build(values, rng)};
    answer.deformable = block_of(values);
    return answer;
  }

 private:
  static Deformable::Form form_of(const std::string& name) {
    return name == "disk"   ? Deformable::Form::disk
           : name == "mesh" ? Deformable::Form::mesh
                            : Deformable::Form::rectangle;
  }

  static std::vector<Contactor2> triangles(const Deformable& block) {
    std::vector<Contactor2> list;
    for (const auto& [a, b, c] : block.mesh->cells) {
      const auto& nodes = block.mesh->nodes;
      list.push_back(Contactor2::polygon({block.scale * nodes[static_cast<std::size_t>(a)],
                                          block.scale * nodes[static_cast<std::size_t>(b)],
                                          block.scale * nodes[static_cast<std::size_t>(c)]}));
    }
    return list;
  }

  Deformable block_of(Values values) const {
    Deformable block{.form = form_,
                     .mesh = mesh_,
                     .scale = values[scale_],
                     .young = values[young_],
                     .poisson = values[poisson_],
                     .alpha = alpha_ >= 0 ? values[alpha_] : 0,
                     .beta = beta_ >= 0 ? values[beta_] : 0,
                     .tensile_strength = {}};
    if (strength_ >= 0) block.tensile_strength = values[strength_];
    double nodes = 0;
    if (form_ == Deformable::Form::disk) {
      block.radius = values[radius_];
      nodes = 1 + 3 * values[rings_] * (values[rings_] + 1);
      check_nodes(nodes, "rings");
      block.rings = static_cast<int>(values[rings_]);
    } else if (form_ == Deformable::Form::rectangle) {
      block.size = Vec2(values[size_], values[size_ + 1]);
      const double shorter = values[cells_], cell = block.size.minCoeff() / shorter;
      const double columns = std::round(block.size.x() / cell), rows = std::round(block.size.y() / cell);
      nodes = (columns + 1) * (rows + 1) + columns * rows;
      check_nodes(nodes, "cells");
      block.cells = {static_cast<int>(columns), static_cast<int>(rows)};
    }
    return block;
  }

  static void check_nodes(double nodes, const char* name) {
    constexpr double most = 10000;
    if (nodes > most)
      throw PluginError(
          fmt::format("plugin deformable: the mesh has {:.0f} nodes, expected at most {:.0f}: "
                      "fewer `{}`",
                      nodes, most, name));
  }

  Deformable::Form form_;
  std::shared_ptr<const GivenMesh> mesh_;
  int size_, cells_, radius_, rings_, scale_, young_, poisson_, alpha_, beta_, strength_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_deformable(Params& params) {
  return std::make_unique<DeformableShape>(params);
}

}  // namespace flyrock::plugins
