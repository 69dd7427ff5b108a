#pragma once
// Many bodies as a whole: where the centres of those that move lie at the end of a trial.

#include <cstddef>
#include <string>
#include <vector>

#include "record/observe.h"
#include "scenario/scenario.h"

namespace flyrock {

struct Assembly {
  int bodies = 0;      ///< that are neither fixed nor driven
  int at_rest = 0;     ///< of them
  double settled = 0;  ///< s, when the last of these came to rest
  BodyState low, high, mean;
};

/// From this number of bodies on, the answer speaks of all together.
inline constexpr std::size_t least_assembly = 11;

/// Which bodies of a scenario are neither fixed nor driven.
std::vector<bool> moving_bodies(const Scenario& scenario);

/// The assembly of the bodies of a trial that move.
Assembly assembly_of(const std::vector<bool>& moving, const std::vector<BodyHistory>& bodies);

/// "300 of 300 bodies moved; 298 are at rest, the last one since 4.2 s. The centres of all lie from x = 0.05
/// to 3.1 m, from y = 0.05 to 0.71 m."
std::string assembly_text(const Assembly& assembly, std::size_t moved, int dimension);

}  // namespace flyrock
