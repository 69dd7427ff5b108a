#include "trial/elastic_blocks.h"

#include "plugin/params.h"

namespace flyrock {

std::shared_ptr<const ElasticBlock> ElasticBlocks::get(const Deformable& shape,
                                                       const ElasticMaterial& material, double h,
                                                       double theta) {
  constexpr std::size_t most = 4;  // of drawn values each trial has its own
  const bool is_disk = shape.form == Deformable::Form::disk;
  const std::array<double, 14> values{static_cast<double>(is_disk),
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
    if (kept.values == values) return kept.block;
  try {
    auto mesh = is_disk ? ringed_disk(shape.radius, shape.rings) : crossed_rectangle(shape.size, shape.cells);
    auto block = std::make_shared<const ElasticBlock>(std::move(mesh), material, h, theta);
    kept_.push_back({values, std::move(block)});
  } catch (const std::runtime_error& error) {
    throw PluginError(error.what());
  }
  if (kept_.size() > most) kept_.pop_front();
  return kept_.back().block;
}

}  // namespace flyrock
