#pragma once
// A few rocks that stand for all fragments of a blast.

#include <vector>

#include "blast/kuz_ram.h"
#include "plugin/models.h"

namespace flyrock::plugins {

/// The parameters that populations of fragments share: `per_trial`, `share`, `least`, `greatest`.
class FragmentSample {
 public:
  explicit FragmentSample(Params& params);

  /// n rocks for a volume [m3] of broken rock of which a share is thrown. The mass between the least and the
  /// greatest size is cut into n equal parts, and a size x is drawn in each: all sizes are met, large blocks
  /// as surely as gravel. A rock then stands for (volume x share x F / n) / (pi/6 x^3) real ones, F the share
  /// of the mass between those sizes. None if less than 1e-9 of the mass is between them.
  template <int D>
  std::vector<RockPlan<D>> rocks(Values values, const FragmentSizes& sizes, double volume,
                                 RandomStream& rng) const;

 private:
  int per_trial_, share_, least_, greatest_;
};

}  // namespace flyrock::plugins
