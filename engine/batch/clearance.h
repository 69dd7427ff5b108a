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
  std::uint64_t count = 0;   ///< rocks without faults, of its group where it has one, or trials that have one
  std::uint64_t rocks = 0;   ///< of these trials together
  std::uint64_t needed = 0;  ///< needed_for(probability)
  /// The quantile 1 - probability and its interval with the confidence of the plan, see Sample; NaN where there are too few. With
  /// sectors those of the sector that reaches farthest: the greatest distance of the polygon.
  Bounded distance{std::numeric_limits<double>::quiet_NaN(), false};
  Interval interval{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  /// factor x distance; NaN without a factor. The interval is left as it is: the factor is applied once.
  double with_factor = std::numeric_limits<double>::quiet_NaN();

  AreaSummary area;  ///< where the plan asks for sectors

  bool enough() const { return count >= needed; }
  /// With which the farthest is sought: of one rock a blast it is nearer than of a thousand. NaN without a blast.
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

/// Rocks of a blast below which its farthest says little: a blast throws thousands.
inline constexpr std::uint64_t few_rocks_per_blast = 100;

/// At any point of the sweep: an error at each clearance of the scenario's tree that its rocks and trials are too few for, where the
/// run is a `full` one; a warning at each `per: blast` with few rocks a blast. What a plugin does wrong meanwhile is left to the run to
/// report.
void check_clearances(const Value& root, const Plan& plan, bool full, Diagnostics& diagnostics);

}  // namespace flyrock
