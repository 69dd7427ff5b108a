#pragma once
// What the trials of a run say of each measured rock (scenario/observed.h).

#include <cstdint>
#include <vector>

#include "record/records.h"
#include "scenario/scenario.h"

namespace flyrock {

/// What is compared, of one rock of one trial: a place in plan (y is 0 in 2D), or a number in x.
struct SimulatedValue {
  std::uint64_t trial = 0;
  Vec2 value = Vec2::Zero();
  bool censored = false;  ///< it left the domain, or still moved: its value is a lower bound
};

struct SimulatedRow {
  std::vector<SimulatedValue> values;  ///< in the order of trials; without rocks that failed
  Vec2 start = Vec2::Zero();           ///< mean of its starts, in plan; NaN: none
  std::uint64_t lost = 0;              ///< rocks that failed
};

/// In the order of ObservedPlan::rows; where these have no rocks of their own, one row for all rocks.
struct SimulatedRows {
  std::vector<SimulatedRow> rows;
  std::uint64_t trials = 0;
};

/// Collects the rows in one pass over chunks in the order of trials. Of a run with more values than
/// `most_values`, the first trials count.
class SimulatedTally {
 public:
  static constexpr std::size_t most_values = 4'000'000;

  explicit SimulatedTally(const Scenario& scenario);
  void add(const TrialRecords& chunk);
  SimulatedRows result();

 private:
  void end_trial();
  SimulatedRow* row_of(const RockRecord& rock);
  Vec2 value_of(const RockRecord& rock) const;

  /// A place in plan: in 2D y is a height, which is no part of it.
  Vec2 in_plan(double x, double y) const { return {x, dimension_ == 3 ? y : 0}; }

  const ObservedPlan& plan_;
  const int dimension_;
  std::vector<std::vector<int>> row_of_line_;  ///< by group and line of its table; -1: not measured
  std::vector<int> row_of_hole_;               ///< of measured holes; -1: not measured
  std::vector<std::size_t> seen_;              ///< rocks of each group in the open trial
  SimulatedRows rows_;
  std::vector<std::uint64_t> starts_;  ///< of each row: number of starts in its sum
  std::size_t values_ = 0;
  bool is_full_ = false;
  bool is_open_ = false;
  std::uint64_t trial_ = 0;
  /// The farthest rock of each row in the open trial, where a row is a blast or a hole.
  std::vector<std::optional<SimulatedValue>> farthest_;
};

}  // namespace flyrock
