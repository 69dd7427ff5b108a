#pragma once
// Clearances: distances that rocks, or the farthest rock of each blast, exceed with a given probability.

#include <cstdint>
#include <vector>

#include "batch/clearance_check.h"
#include "results/least_area.h"
#include "results/unknown.h"

namespace flyrock {

struct ClearanceSummary {
  std::uint64_t count =
      0;  ///< rocks without faults (of its group, if it has one), or trials with such a rock
  std::uint64_t rocks = 0;   ///< rocks of all these trials
  std::uint64_t needed = 0;  ///< needed_for(probability)
  /// The quantile 1 - probability and its interval with the confidence of the plan (see Sample); NaN if there
  /// are too few rocks or trials. With sectors, the greatest distance of the area, without an interval: the
  /// area holds with stated_confidence.
  Bounded distance{unknown, false};
  Interval interval{unknown, unknown};  ///< with trials_needed if too few trials reach beyond the distance
  /// factor x distance; NaN without a factor. The factor is applied only here and not to the interval.
  double with_factor = unknown;

  AreaSummary area;      ///< if the plan asks for sectors
  LeastArea least_area;  ///< if the plan asks for it

  bool enough() const {
    return area.sectors.empty() ? count >= needed && interval.trials_needed == 0 : area.beyond.has_value();
  }
  /// The mean number of rocks in a blast. The farthest rock of few is nearer than the farthest of many. NaN
  /// without a blast.
  double rocks_per_blast() const { return static_cast<double>(rocks) / static_cast<double>(count); }
};

/// Computes the clearances of a scenario from rocks that are shown in passes; see read_in_passes().
class ClearanceTally {
 public:
  explicit ClearanceTally(const std::vector<ClearancePlan>& plans);
  void add(const TrialRecords& chunk);
  bool needs_another_pass();
  /// In the order of Scenario::clearances.
  std::vector<ClearanceSummary> summaries() const;

 private:
  std::vector<ClearancePlan> plans_;
  std::vector<Sample> samples_;       ///< distances
  std::vector<std::uint64_t> rocks_;  ///< rocks counted in each sample
  bool counted_ = false;              ///< first pass is done
  std::vector<SectorTally> sectors_;  ///< empty if no sectors are asked for
  std::vector<LeastAreaTally> least_areas_;
};

}  // namespace flyrock
