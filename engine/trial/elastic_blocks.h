#pragma once
// The factorised blocks of a scenario: those of the same values share one.

#include <deque>
#include <memory>

#include "elastic/elastic_block.h"
#include "geometry/deformable.h"

namespace flyrock {

/// The blocks that were asked for last. Of one thread (ElasticBlock).
template <int D>
class ElasticBlocks {
 public:
  /// Throws PluginError if the block cannot be factorised.
  std::shared_ptr<const ElasticBlock<D>> get(const Deformable<D>& shape, const ElasticMaterial& material,
                                             double h, double theta);

 private:
  struct Kept {
    std::vector<double> values;
    std::shared_ptr<const GivenMesh<D>> mesh;
    std::shared_ptr<const ElasticBlock<D>> block;
  };
  std::deque<Kept> kept_;
};

}  // namespace flyrock
