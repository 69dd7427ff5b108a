#pragma once
// Clearances: distances that rocks, or the farthest rock of each blast, exceed with a given probability.

#include <cstdint>
#include <limits>
#include <vector>

#include "batch/sectors.h"
#include "scenario/diagnostics.h"

namespace flyrock {

/// A clearance needs so many rocks (or blasts) that 10 of them are expected beyond it: fewer say too little about the tail.
std::uint64_t needed_for(double probability);

struct ClearanceSummary {
  std::uint64_t count = 0;   ///< rocks without faults, or trials that have one
  std::uint64_t needed = 0;  ///< needed_for(probability)
  /// The quantile 1 - probability and its interval with the confidence of the plan, see Sample; NaN where there are too few.
  Bounded distance{std::numeric_limits<double>::quiet_NaN(), false};
  Interval interval{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  /// factor x distance; NaN without a factor. The interval is left as it is: the factor is applied once.
  double with_factor = std::numeric_limits<double>::quiet_NaN();

  std::vector<SectorSummary> sectors;  ///< where the plan asks for them

  bool enough() const { return count >= needed; }
};

/// Finds the clearances of a scenario from rocks that are shown in passes; see read_in_passes().
class ClearanceTally {
 public:
  explicit ClearanceTally(const std::vector<ClearancePlan>& plans);
  void see(const TrialRecords& chunk);
  bool again();
  /// In the order of Scenario::clearances.
  std::vector<ClearanceSummary> summaries() const;

 private:
  std::vector<ClearancePlan> plans_;
  std::vector<Sample> samples_;       ///< of distances
  std::vector<SectorTally> sectors_;  ///< empty ones where none are asked for
};

/// An error at each clearance of the scenario's tree that its rocks and trials are too few for, at any point of the sweep.
/// What a plugin does wrong meanwhile is left to the run to report.
void check_clearances(const Value& root, const Plan& plan, Diagnostics& diagnostics);

}  // namespace flyrock
