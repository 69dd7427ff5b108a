#include "trial/elastic_blocks.h"

#include "plugin/params.h"

namespace flyrock {

namespace {

ElasticMesh<2> made_mesh(const Deformable<2>& shape) {
  if (shape.form == DeformableForm::disk) return ringed_disk(shape.radius, shape.rings);
  return crossed_rectangle(shape.size, shape.cells);
}
ElasticMesh<3> made_mesh(const Deformable<3>& shape) { return bricked_box(shape.size, shape.cells); }

template <int D>
ElasticMesh<D> mesh_of(const Deformable<D>& shape) {
  if (shape.form != DeformableForm::mesh) return made_mesh(shape);
  ElasticMesh<D> mesh{
      .nodes = shape.mesh->nodes, .cells = shape.mesh->cells, .surface = {}, .ignored = shape.mesh->ignored};
  for (Vec<D>& node : mesh.nodes) node *= shape.scale;
  if constexpr (D == 2)
    for (const auto& side : shape.mesh->sides) mesh.surface.push_back(side[0]);
  find_surface(mesh);
  return mesh;
}

}  // namespace

template <int D>
std::shared_ptr<const ElasticBlock<D>> ElasticBlocks<D>::get(const Deformable<D>& shape,
                                                             const ElasticMaterial& material, double h,
                                                             double theta) {
  constexpr std::size_t most = 4;  // of drawn values each trial has its own
  std::vector<double> values{static_cast<double>(shape.form),
                             shape.scale,
                             shape.radius,
                             static_cast<double>(shape.rings),
                             material.young,
                             material.poisson,
                             material.density * material.thickness,
                             material.alpha,
                             material.beta,
                             h,
                             theta};
  values.insert(values.end(), shape.size.begin(), shape.size.end());
  values.insert(values.end(), shape.cells.begin(), shape.cells.end());
  for (const Kept& kept : kept_)
    if (kept.values == values && kept.mesh == shape.mesh) return kept.block;
  try {
    auto block = std::make_shared<const ElasticBlock<D>>(mesh_of(shape), material, h, theta);
    kept_.push_back({values, shape.mesh, std::move(block)});
  } catch (const std::runtime_error& error) {
    throw PluginError(error.what());
  }
  if (kept_.size() > most) kept_.pop_front();
  return kept_.back().block;
}

template class ElasticBlocks<2>;
template class ElasticBlocks<3>;

}  // namespace flyrock
