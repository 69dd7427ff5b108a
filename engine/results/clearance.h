#pragma once
// Clearances: distances that rocks, or the farthest rock of each blast, exceed with a given probability.

#include <cstdint>
#include <vector>

#include "batch/clearance_check.h"
#include "results/sectors.h"
#include "results/unknown.h"

namespace flyrock {

struct ClearanceSummary {
  std::uint64_t count = 0;   ///< rocks without faults, of its group where it has one, or trials that have one
  std::uint64_t rocks = 0;   ///< of these trials together
  std::uint64_t needed = 0;  ///< needed_for(probability)
  /// The quantile 1 - probability and its interval with the confidence of the plan, see Sample; NaN where
  /// there are too few. With sectors those of the sector that reaches farthest: the greatest distance of the
  /// polygon.
  Bounded distance{unknown, false};
  Interval interval{unknown, unknown};
  /// factor x distance; NaN without a factor. The interval is left as it is: the factor is applied once.
  double with_factor = unknown;

  AreaSummary area;  ///< where the plan asks for sectors

  bool enough() const { return count >= needed; }
  /// With which the farthest is sought: of one rock a blast it is nearer than of a thousand. NaN without a
  /// blast.
  double rocks_per_blast() const { return static_cast<double>(rocks) / static_cast<double>(count); }
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
  std::vector<std::uint64_t> rocks_;  ///< that are counted in them
  bool counted_ = false;              ///< in the first pass
  std::vector<SectorTally> sectors_;  ///< empty ones where none are asked for
};

}  // namespace flyrock
