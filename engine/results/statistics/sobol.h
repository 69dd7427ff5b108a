#pragma once
// Sobol's indices: which input explains how much of the variance of a number.
//
// f is computed at two bases A and B of N trials with independent inputs, and at A with one input i from B at
// a time, AB_i. With the variance V of both bases together and their mean m,
//   S_i = mean (f_B - m) (f_ABi - f_A) / V     first order: the part that the input explains alone
//   T_i = mean (f_A - f_ABi)^2 / (2 V)         total: the part that stays if all other inputs are known
// so that sum S_i <= 1 <= sum T_i, with equality where no inputs act together. Sources: Saltelli et al. 2010,
// Variance based sensitivity analysis of model output, table 2 (b) and (f); Jansen 1999. Without m the error
// of S_i grows with the mean of f.
//
// Intervals: 2.5 % and 97.5 % of 1,000 bootstraps over the trials, in all runs of which a trial is drawn as
// one.

#include <cstdint>
#include <vector>

#include "results/statistics/sample.h"
#include "results/statistics/unknown.h"

namespace flyrock {

/// A number of each trial, in each run. A trial with an unknown number in one run is left out of all.
struct ExchangedRuns {
  std::vector<double> a, b;
  std::vector<std::vector<double>> ab;  ///< of each input
};

struct SobolIndex {
  double first = unknown, total = unknown;
  Interval first_interval{unknown, unknown}, total_interval{unknown, unknown};
};

struct SobolIndices {
  std::vector<SobolIndex> inputs;
  double mean = unknown, variance = unknown;
  double sum_first = unknown, sum_total = unknown;
  std::uint64_t trials = 0, left_out = 0;

  /// More than this share of the trials left out: no index is known.
  static constexpr double most_left_out = 0.05;
  bool is_lost() const {
    return static_cast<double>(left_out) > most_left_out * static_cast<double>(trials + left_out);
  }
};

inline constexpr int sobol_bootstraps = 1000;

/// Unknown where f is the same in all trials, where too many trials are left out, and intervals below 2
/// trials. `seed`: of the bootstraps.
SobolIndices sobol_indices(const ExchangedRuns& runs, std::uint64_t seed, int bootstraps = sobol_bootstraps);

}  // namespace flyrock
