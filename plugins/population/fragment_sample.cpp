#include "plugins/population/fragment_sample.h"

#include <cmath>

#include "math/space.h"
#include "random/distribution.h"

namespace flyrock::plugins {

FragmentSample::FragmentSample(Params& params)
    : per_trial_(params.slot("per_trial")),
      share_(params.slot("share")),
      least_(params.slot("least")),
      greatest_(params.slot("greatest")) {}

template <int D>
std::vector<RockPlan<D>> FragmentSample::rocks(Values values, const FragmentSizes& sizes, double volume,
                                               RandomStream& rng) const {
  Distribution mass;
  mass.kind = DistributionKind::rosin_rammler;
  mass.a = sizes.median;
  mass.b = sizes.uniformity;
  mass.min = values[least_];
  if (greatest_ >= 0) mass.max = values[greatest_];
  if (!mass.fault().empty()) return {};  // no piece has such a size
  const auto count = static_cast<std::size_t>(std::llround(values[per_trial_]));
  const double part = (mass.cumulative(mass.max) - mass.cumulative(mass.min)) / static_cast<double>(count);
  std::vector<RockPlan<D>> rocks(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double size = mass.quantile((static_cast<double>(i) + rng.uniform()) / static_cast<double>(count));
    rocks[i].diameter = size;
    rocks[i].weight = volume * values[share_] * part / (pi / 6 * size * size * size);
  }
  return rocks;
}

template std::vector<RockPlan<2>> FragmentSample::rocks(Values, const FragmentSizes&, double,
                                                        RandomStream&) const;
template std::vector<RockPlan<3>> FragmentSample::rocks(Values, const FragmentSizes&, double,
                                                        RandomStream&) const;

}  // namespace flyrock::plugins
