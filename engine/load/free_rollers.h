#pragma once
// Round rocks that their ground does not bring to rest before stop.time.

#include <string>
#include <vector>

#include "trial/build_trial.h"

namespace flyrock {

/// A rock that goes on until stop.time, so that the percentiles of a run are lower bounds.
struct FreeRoller {
  std::string path;  ///< of the key of the material that does not stop it
  std::string why;
};

/// The round rocks of a world that roll on or pivot on: the ground has no resistance to rolling, or one so
/// small that it needs longer than stop.time for a speed of 1 m/s or for a pivot of 1 rad/s:
///   R (1 + I/(m R^2)) v / (mu_r g),   2 R^2 w / (5 mu_spin g)
/// A pivot that nothing slows (mu_spin 0) counts as rest (flight/rest.h). Laws are asked for a slow contact
/// on level ground; one that fails is skipped.
template <int D>
std::vector<FreeRoller> free_rollers(const Scenario& scenario, const Instances& instances,
                                     const World<D>& world, const WorldLaws& laws);

}  // namespace flyrock
