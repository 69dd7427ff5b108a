#include <fmt/format.h>

#include <cmath>

#include "blast/blast.h"
#include "plugin/models.h"
#include "plugin/terrain_view.h"
#include "plugins/factories.h"
#include "random/stream.h"

namespace flyrock::plugins {

namespace {

class Independent : public Population {
 public:
  explicit Independent(Params& params) : per_trial_(params.slot("per_trial")) {}

  std::vector<RockPlan<2>> rocks(Values values, const TerrainView&, const Blast&,
                                 RandomStream&) const override {
    return std::vector<RockPlan<2>>(count(values));
  }
  std::vector<RockPlan<3>> rocks_3d(Values values, const TerrainView&, const Blast&,
                                    RandomStream&) const override {
    return std::vector<RockPlan<3>>(count(values));
  }

 private:
  std::size_t count(Values values) const {
    const double given = values[per_trial_];
    if (!(given >= 1))
      throw PluginError(fmt::format("plugin independent: per_trial is {:.6g}, must be at least 1", given));
    return static_cast<std::size_t>(std::llround(given));
  }

  int per_trial_;
};

}  // namespace

std::unique_ptr<Population> make_independent(Params& params) { return std::make_unique<Independent>(params); }

}  // namespace flyrock::plugins
