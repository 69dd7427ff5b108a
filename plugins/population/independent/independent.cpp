#include <fmt/format.h>

#include <cmath>

#include "plugins/factories.h"

namespace flyrock::plugins {

namespace {

class Independent : public Population {
 public:
  explicit Independent(Params& params) : per_trial_(params.slot("per_trial")) {}

  std::vector<RockPlan> rocks(Values values, const Profile&, const Blast&, RandomStream&) const override {
    const double count = values[per_trial_];
    if (!(count >= 1))
      throw PluginError(fmt::format("plugin independent: per_trial is {:.6g}, must be at least 1", count));
    return std::vector<RockPlan>(static_cast<std::size_t>(std::llround(count)));
  }

 private:
  int per_trial_;
};

}  // namespace

std::unique_ptr<Population> make_independent(Params& params) { return std::make_unique<Independent>(params); }

}  // namespace flyrock::plugins
