#pragma once
// Which drawn numbers the runout depends on, and how.

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "report/ranked_inputs.h"
#include "results/statistics.h"

namespace flyrock {

/// The rank correlation of every drawn number that the run reads (ranked_inputs.h) against the runout, of
/// each group of rocks, over its first 10,000 rocks without faults: they say all that can be seen in a plot,
/// and take no more room where there are a million. A censored runout has the rank of its lower bound.
///
/// Many numbers are looked at, and some of them would seem to matter by chance alone. Therefore the intervals
/// of one group hold together: with m inputs each has the confidence 1 - 0.05/m (Bonferroni), so that in 19
/// of 20 runs none of those without influence excludes 0.
///
/// Each has a curve: the runout of the rocks within each tenth of the number's values, all other numbers
/// being drawn as ever. Two numbers that follow from what is drawn stand with the drawn ones: the charge of a
/// hole and its powder factor.
class Sensitivity {
 public:
  explicit Sensitivity(const Scenario& scenario);

  /// Chunks in order, with their inputs.
  void see(const TrialRecords& chunk);

  /// One entry a group: { count, confidence, inputs: [{ path, unit, r, lower, upper, curve }] }, the
  /// strongest first; what has one value in all rocks is left out. confidence is that of one interval; unit
  /// is one that people read (readable_unit). curve: { x, low, middle, high }, the median of the number in
  /// that unit and p10, p50 and p90 of the runout, of each tenth.
  nlohmann::ordered_json data() const;

 private:
  struct Group {
    std::vector<double> runout;
    std::map<int, std::vector<double>>
        inputs;  ///< of each draw, and of what follows from draws, numbered after them
  };
  /// An input that orders the runouts in some way.
  struct Line {
    int input = 0;
    double r = 0;
  };
  int first_derived() const { return static_cast<int>(names_.size()) - derived_inputs; }
  bool is_ranked(std::size_t group, int input) const;
  void add_derived(const std::map<int, double>& drawn, Group& group) const;
  std::vector<Line> ranked(std::size_t group) const;
  nlohmann::ordered_json group_data(std::size_t group) const;

  std::optional<BlastPlan> blast_;
  RankedInputs inputs_;
  std::vector<std::string> names_;   ///< of the draws, then of what follows from them
  std::vector<ReadableUnit> units_;  ///< the same
  std::vector<Group> groups_;
};

}  // namespace flyrock
