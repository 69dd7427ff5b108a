#include "blast/kuz_ram.h"

#include "plugins/factories.h"
#include "plugins/of_the_blast.h"
#include "plugins/population/fragment_sample.h"

namespace flyrock::plugins {

namespace {

class KuzRamFragments : public Population {
 public:
  explicit KuzRamFragments(Params& params)
      : sample_(params),
        rock_factor_(params.slot("rock_factor")),
        strength_(params.slot("strength")),
        deviation_(params.slot("deviation")),
        holes_(params.slot("holes")) {}

  std::vector<RockPlan<2>> rocks(Values values, const TerrainView&, const Blast& blast,
                                 RandomStream& rng) const override {
    return sampled<2>(values, blast, rng);
  }
  std::vector<RockPlan<3>> rocks_3d(Values values, const TerrainView&, const Blast& blast,
                                    RandomStream& rng) const override {
    return sampled<3>(values, blast, rng);
  }

 private:
  template <int D>
  std::vector<RockPlan<D>> sampled(Values values, const Blast& blast, RandomStream& rng) const {
    const KuzRam rock{values[rock_factor_], values[strength_], values[deviation_]};
    FragmentSizes sizes;
    const double volume = values[holes_] * of_the_blast("kuz_ram", [&] {
                            sizes = kuz_ram(blast, rock);
                            return volume_of_hole(blast);
                          });
    return sample_.rocks<D>(values, sizes, volume, rng);
  }

  FragmentSample sample_;
  int rock_factor_, strength_, deviation_, holes_;
};

}  // namespace

std::unique_ptr<Population> make_kuz_ram(Params& params) { return std::make_unique<KuzRamFragments>(params); }

}  // namespace flyrock::plugins
