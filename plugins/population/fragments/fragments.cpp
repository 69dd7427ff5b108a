#include "plugins/factories.h"
#include "plugins/population/fragment_sample.h"

namespace flyrock::plugins {

namespace {

class Fragments : public Population {
 public:
  explicit Fragments(Params& params)
      : sample_(params),
        median_(params.slot("median")),
        uniformity_(params.slot("uniformity")),
        volume_(params.slot("volume")) {}

  std::vector<RockPlan<2>> rocks(Values values, const TerrainView&, const Blast&,
                                 RandomStream& rng) const override {
    return sampled<2>(values, rng);
  }
  std::vector<RockPlan<3>> rocks_3d(Values values, const TerrainView&, const Blast&,
                                    RandomStream& rng) const override {
    return sampled<3>(values, rng);
  }

 private:
  template <int D>
  std::vector<RockPlan<D>> sampled(Values values, RandomStream& rng) const {
    return sample_.rocks<D>(values, {values[median_], values[uniformity_]}, values[volume_], rng);
  }

  FragmentSample sample_;
  int median_, uniformity_, volume_;
};

}  // namespace

std::unique_ptr<Population> make_fragments(Params& params) { return std::make_unique<Fragments>(params); }

}  // namespace flyrock::plugins
