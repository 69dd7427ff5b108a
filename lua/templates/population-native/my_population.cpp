#include "plugin/module.h"

namespace {

/// A number of rocks that differs from trial to trial, half of them heavier.
class MyPopulation : public flyrock::Population {
 public:
  explicit MyPopulation(flyrock::Params& params) : most_(params.slot("most")) {}
  std::vector<flyrock::RockPlan<2>> rocks(flyrock::Values values, const flyrock::TerrainView&,
                                          const flyrock::Blast&, flyrock::RandomStream& rng) const override {
    return drawn<2>(values, rng);
  }
  std::vector<flyrock::RockPlan<3>> rocks_3d(flyrock::Values values, const flyrock::TerrainView&,
                                             const flyrock::Blast&,
                                             flyrock::RandomStream& rng) const override {
    return drawn<3>(values, rng);
  }

 private:
  /// What a rock does not say, its group says.
  template <int D>
  std::vector<flyrock::RockPlan<D>> drawn(flyrock::Values values, flyrock::RandomStream& rng) const {
    const auto most = static_cast<std::int64_t>(values[most_]);
    std::vector<flyrock::RockPlan<D>> rocks(static_cast<std::size_t>(rng.integer(1, most)));
    for (flyrock::RockPlan<D>& rock : rocks)
      if (rng.uniform() < 0.5) rock.density = 3000;
    return rocks;
  }

  int most_;
};

}  // namespace

FLYROCK_MODULE(table) {
  table[{flyrock::PluginKind::population, "my_population"}] = flyrock::FactoryOf<flyrock::Population>(
      [](flyrock::Params& params) { return std::make_unique<MyPopulation>(params); });
  return nullptr;
}
