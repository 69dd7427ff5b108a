#pragma once
// Which drawn numbers the runout depends on.

#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "batch/statistics.h"

namespace flyrock {

/// The rank correlation of every drawn number against the runout, of each group of rocks, over its first 10,000 rocks
/// without faults: they say all that can be seen in a plot, and take no more room where there are a million. A censored
/// runout has the rank of its lower bound.
class Sensitivity {
 public:
  explicit Sensitivity(const Scenario& scenario);

  /// Chunks in order, with their inputs.
  void see(const TrialRecords& chunk);

  /// One entry a group: { count, inputs: [{ path, r, lower, upper }] }, the strongest first; what has one value in all
  /// rocks is left out.
  nlohmann::ordered_json data() const;

 private:
  struct Group {
    std::vector<double> runout;
    std::map<int, std::vector<double>> inputs;  ///< of each draw
  };
  nlohmann::ordered_json group_data(const Group& group) const;

  std::vector<std::string> names_;  ///< of the draws
  std::vector<Group> groups_;
};

}  // namespace flyrock
