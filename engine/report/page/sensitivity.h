#pragma once
// Which drawn numbers influence the runout, and how.

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "report/page/ranked_inputs.h"
#include "results/statistics/rank_correlation.h"
#include "results/statistics/statistics.h"

namespace flyrock {

/// The rank correlation of each drawn number that the run reads (ranked_inputs.h) with the runout, for each
/// group of rocks, with the weights of the rocks. Only the first 10,000 rocks without faults of a group
/// count: more would add nothing to a plot and would take more memory. A censored runout has the rank of its
/// lower bound. A number that is drawn at every impact has its mean over the impacts of a rock; rocks without
/// it are left out.
///
/// With many numbers, some seem to have an influence by chance alone. Therefore the intervals of one group
/// hold together: with m inputs each has the confidence 1 - 0.05/m (Bonferroni). In 19 of 20 runs, all inputs
/// without influence then have intervals that contain 0.
///
/// Each number has a curve: the runout of the rocks in each tenth of the number's values, while all other
/// numbers vary as drawn. Numbers of the blast that are made of drawn ones (blast/derived.h) stand among
/// them, marked with what they are made of; they are no further causes, so m does not count them. Outcomes of
/// what plugins draw (rock.volume) are ranked only with `output.rank_outcomes`.
class Sensitivity {
 public:
  explicit Sensitivity(const Scenario& scenario);

  /// Takes chunks in order, with their inputs.
  void add(const TrialRecords& chunk);

  /// One entry for each group: { count, confidence, inputs: [{ path, unit, r, lower, upper, design_effect,
  /// curve, of }], not_read }, strongest first. `of`: what a derived number is made of, [{ path, read }],
  /// null of others. not_read: drawn numbers of the blast that nothing of the group reads. Inputs with the
  /// same value in all rocks are left out. confidence is that of one interval, whose unit is the trial
  /// (design_effect: results/statistics/rank_correlation.h); unit is a unit for readers (readable_unit).
  /// curve: { x, low, middle, high }, the median of the number in that unit and p10, p50 and p90 of the
  /// runout, in each tenth.
  nlohmann::ordered_json data() const;

 private:
  struct Group {
    PairUnits rocks;
    std::vector<double> runout;
    /// By the index of batch/inputs.h; unknown for a rock without the number.
    std::map<int, std::vector<double>> inputs;
  };
  /// The rocks of a group that have a number.
  struct Column {
    PairUnits rocks;
    std::vector<double> value, runout;
  };
  /// One ranked input.
  struct Line {
    int input = 0;
    Column column;
    RankCorrelation found;
  };
  static Column column(const Group& group, const std::vector<double>& values);
  int first_derived() const { return static_cast<int>(names_.size() - derived_count); }
  /// What a derived number is made of, for a group; null for another input.
  nlohmann::ordered_json made_of_data(std::size_t group, int input) const;
  bool is_ranked(std::size_t group, int input) const;
  std::vector<Line> ranked(std::size_t group) const;
  nlohmann::ordered_json group_data(std::size_t group) const;

  RankedInputs inputs_;
  std::vector<std::string> draws_of_blast_;        ///< streams, each by its draw; empty of other draws
  std::vector<std::vector<std::string>> made_of_;  ///< of each derived number the paths
  int draws_ = 0;  ///< number of inputs that are draws; the next ones are outcomes
  bool rank_outcomes_ = false;
  std::vector<std::string> names_;   ///< of the inputs
  std::vector<ReadableUnit> units_;  ///< in the same order
  std::vector<Group> groups_;
};

}  // namespace flyrock
