#pragma once
// Which drawn numbers the runout depends on, and how.

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "batch/statistics.h"

namespace flyrock {

/// The rank correlation of every drawn number against the runout, of each group of rocks, over its first 10,000 rocks
/// without faults: they say all that can be seen in a plot, and take no more room where there are a million. A censored
/// runout has the rank of its lower bound.
///
/// Beside it a curve: the runout of the rocks within each tenth of the number's values, all other numbers being drawn as ever.
/// Two numbers that follow from what is drawn stand beside the drawn ones: the charge of a hole and its powder factor.
class Sensitivity {
 public:
  explicit Sensitivity(const Scenario& scenario);

  /// Chunks in order, with their inputs.
  void see(const TrialRecords& chunk);

  /// One entry a group: { count, inputs: [{ path, r, lower, upper, curve }] }, the strongest first; what has one value in all
  /// rocks is left out. curve: { x, low, middle, high }, the median of the number and p10, p50 and p90 of the runout, of each tenth.
  nlohmann::ordered_json data() const;

 private:
  struct Group {
    std::vector<double> runout;
    std::map<int, std::vector<double>> inputs;  ///< of each draw, and of what follows from draws, numbered after them
  };
  void add_derived(const std::map<int, double>& drawn, Group& group) const;
  nlohmann::ordered_json group_data(const Group& group) const;

  std::optional<BlastPlan> blast_;
  std::vector<std::string> names_;  ///< of the draws, then of what follows from them
  std::vector<Group> groups_;
};

}  // namespace flyrock
