#include "trial/elastic_blocks.h"

#include "plugin/params.h"

namespace flyrock {

namespace {

ElasticMesh<2> mesh_of(const Deformable& shape) {
  if (shape.form == Deformable::Form::disk) return ringed_disk(shape.radius, shape.rings);
  if (shape.form == Deformable::Form::rectangle) return crossed_rectangle(shape.size, shape.cells);
  ElasticMesh<2> mesh{shape.mesh->nodes, shape.mesh->cells, shape.mesh->outline, shape.mesh->ignored};
  for (Vec2& node : mesh.nodes) node *= shape.scale;
  return mesh;
}

}  // namespace

std::shared_ptr<const ElasticBlock> ElasticBlocks::get(const Deformable& shape,
                                                       const ElasticMaterial& material, double h,
                                                       double theta) {
  constexpr std::size_t most = 4;  // of drawn values each trial has its own
  const std::array<double, 15> values{static_cast<double>(shape.form),
                                      shape.scale,
                                      shape.size.x(),
                                      shape.size.y(),
                                      static_cast<double>(shape.cells[0]),
                                      static_cast<double>(shape.cells[1]),
                                      shape.radius,
                                      static_cast<double>(shape.rings),
                                      material.young,
                                      material.poisson,
                                      material.density * material.thickness,
                                      material.alpha,
                                      material.beta,
                                      h,
                                      theta};
  for (const Kept& kept : kept_)
    if (kept.values == values && kept.mesh == shape.mesh) return kept.block;
  try {
    auto block = std::make_shared<const ElasticBlock>(mesh_of(shape), material, h, theta);
    kept_.push_back({values, shape.mesh, std::move(block)});
  } catch (const std::runtime_error& error) {
    throw PluginError(error.what());
  }
  if (kept_.size() > most) kept_.pop_front();
  return kept_.back().block;
}

}  // namespace flyrock
