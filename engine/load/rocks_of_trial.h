#pragma once
// How many rocks a trial of a scenario has, and for how many real ones they stand.

#include <cstdint>
#include <vector>

#include "scenario/scenario.h"

namespace flyrock {

/// The rocks of a trial, of one group or of several.
struct RocksOfTrial {
  std::uint64_t count = 0;
  double real = 0;      ///< the sum of their weights
  double greatest = 0;  ///< weight

  void add(const RocksOfTrial& other);
};

/// The rocks of each group of the scenario. The first trial stands for all. Throws TrialError if it cannot be
/// built.
std::vector<RocksOfTrial> rocks_of_a_trial(const Scenario& scenario);

}  // namespace flyrock
