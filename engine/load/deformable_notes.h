#pragma once
// What `check` says of deformable bodies.

#include <string>
#include <vector>

#include "trial/build_trial.h"

namespace flyrock {

/// A block whose step is longer than a tenth of the time in which sound passes its smaller extent.
struct LongStep {
  std::string path;  ///< of the shape
  std::string why;
};
template <int D>
std::vector<LongStep> long_steps(const Scenario& scenario, const World<D>& world);

/// One line about how the deformable bodies of a world touch; empty if there are none.
template <int D>
std::string deformable_note(const World<D>& world);

}  // namespace flyrock
