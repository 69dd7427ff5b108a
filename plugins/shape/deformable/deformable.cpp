#include "geometry/deformable.h"

#include <fmt/format.h>

#include <cmath>

#include "geometry/contactor.h"
#include "plugin/models.h"
#include "plugins/factories.h"
#include "random/stream.h"

namespace flyrock::plugins {

namespace {

/// A rectangle or disk of finite elements; the contactor is the polygon about its mesh.
class DeformableShape : public ShapeModel {
 public:
  explicit DeformableShape(Params& params)
      : is_disk_(params.text("form") == "disk"),
        size_(params.vector_slot("size")),
        cells_(params.slot("cells")),
        radius_(params.slot("radius")),
        rings_(params.slot("rings")),
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
                                    is_disk_ ? "disk" : "rectangle"));
    };
    needs(size_ >= 0, "size", !is_disk_);
    needs(cells_ >= 0, "cells", !is_disk_);
    needs(radius_ >= 0, "radius", is_disk_);
    needs(rings_ >= 0, "rings", is_disk_);
  }

  std::vector<Contactor2> build(Values values, RandomStream&) const override {
    const Deformable block = block_of(values);
    std::vector<Vec2> corners;
    if (is_disk_) {
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
  Deformable block_of(Values values) const {
    Deformable block{.form = is_disk_ ? Deformable::Form::disk : Deformable::Form::rectangle,
                     .young = values[young_],
                     .poisson = values[poisson_],
                     .alpha = alpha_ >= 0 ? values[alpha_] : 0,
                     .beta = beta_ >= 0 ? values[beta_] : 0,
                     .tensile_strength = {}};
    if (strength_ >= 0) block.tensile_strength = values[strength_];
    double nodes = 0;
    if (is_disk_) {
      block.radius = values[radius_];
      nodes = 1 + 3 * values[rings_] * (values[rings_] + 1);
      check_nodes(nodes, "rings");
      block.rings = static_cast<int>(values[rings_]);
    } else {
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

  bool is_disk_;
  int size_, cells_, radius_, rings_, young_, poisson_, alpha_, beta_, strength_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_deformable(Params& params) {
  return std::make_unique<DeformableShape>(params);
}

}  // namespace flyrock::plugins
