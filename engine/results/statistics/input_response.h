#pragma once
// How a number of a trial moves with one of its inputs, while all other inputs vary as drawn.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "record/records.h"
#include "results/statistics/sample.h"
#include "results/statistics/unknown.h"
#include "scenario/scenario.h"

namespace flyrock {

/// The inputs (batch/inputs.h) of the trials of both bases. Only an input with one number in each trial has
/// values: not one that differs from rock to rock, from hole to hole or from impact to impact.
class InputValues {
 public:
  /// `group`: whose rocks count; -1: all. `trials`: of a base.
  InputValues(const Scenario& scenario, int group, std::uint64_t trials);

  /// `base`: 0 or 1.
  void add(int base, const TrialRecords& chunk);

  /// The values of an input, by its path: in the trials of the first base, then of the second; NaN in a trial
  /// without it. Null: it has no single number in a trial.
  const std::vector<double>* of(const std::string& path) const;
  const std::vector<std::string>& paths() const { return paths_; }
  const std::string& unit_of(const std::string& path) const;

 private:
  struct Column {
    std::vector<double> values;
    bool has_one = true;  ///< in each trial so far
  };
  int group_;
  std::uint64_t trials_;
  std::vector<std::string> paths_, units_;
  std::map<int, Column> columns_;
};

/// A part of the trials, sorted by the input.
struct ResponseBin {
  double x = unknown;     ///< median of the input
  double mean = unknown;  ///< of f
  Interval mean_interval{unknown, unknown};
  /// Percentiles of f over the trials of the bin, with intervals (Sample::quantile_interval).
  double p50 = unknown, p95 = unknown, p99 = unknown;
  Interval p50_interval{unknown, unknown}, p95_interval = p50_interval, p99_interval = p50_interval;
  std::uint64_t trials = 0;
};

/// Where the mean of f crosses a line.
struct LineCrossing {
  double at = unknown;  ///< the input
  Interval interval{unknown, unknown};
  bool is_rising = false;  ///< f rises with the input
};

struct InputResponse {
  double p10 = unknown, p90 = unknown;      ///< of the input
  double f_p10 = unknown, f_p90 = unknown;  ///< mean of f in the tenth of the trials about each of them
  Interval f_p10_interval{unknown, unknown}, f_p90_interval{unknown, unknown};
  /// The part of the variance of f between the bins of the curve, corrected for their number: the correlation
  /// ratio 1 - (variance within) / (variance of all). Of one of several independent inputs it is the first
  /// order, without what varies within a bin; of a number that is made of inputs, what goes along with it.
  double explained = unknown;
  std::vector<ResponseBin> curve;  ///< ten bins of equally many trials; fewer if there are less than 300
};

/// The mean of f over two inputs: in cells of equally many trials by each of them.
struct ResponseMap {
  std::vector<double> x, y;               ///< medians of the inputs in the columns and rows
  std::vector<std::vector<double>> mean;  ///< of a row the columns; NaN in a cell with fewer than 5 trials
};

/// Nothing where fewer than 300 trials are known.
std::optional<ResponseMap> map_of(const std::vector<double>& x, const std::vector<double>& y,
                                  const std::vector<double>& f);

/// Nothing where fewer than 30 trials are known or the input is the same in all. `x`, `f`: of the same
/// trials.
std::optional<InputResponse> response_of(const std::vector<double>& x, const std::vector<double>& f);

/// From which value of the input on the mean of f is below (or above) `line`: an isotonic fit of f over x
/// (pool adjacent violators; falling or rising by the sign of the correlation), and the middle 95 % of the
/// crossings of `bootstraps` fits of trials drawn with replacement. Nothing where the fit does not cross the
/// line, or one in 40 bootstraps does not. Source: Barlow et al. 1972.
std::optional<LineCrossing> crossing_of(const std::vector<double>& x, const std::vector<double>& f,
                                        double line, std::uint64_t seed, int bootstraps = 400);

}  // namespace flyrock
