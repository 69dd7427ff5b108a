#pragma once
// Clearances: distances that rocks, or the farthest rock of each blast, exceed with a given probability.

#include <cstdint>
#include <optional>
#include <vector>

#include "load/clearance_check.h"
#include "results/measured/least_area.h"
#include "results/statistics/blast_bounds.h"
#include "results/statistics/unknown.h"

namespace flyrock {

/// How many blasts throw at least one rock beyond a distance.
struct BlastsBeyond {
  double distance = unknown;  ///< m
  std::uint64_t blasts = 0;   ///< n
  /// k of n trials, exact (Clopper and Pearson); with weights the bounds for the greatest of them.
  BlastBounds share = unknown_bounds;
  bool is_lower_bound = false;  ///< a rock that was cut short nearer may have gone beyond
};

struct ClearanceSummary {
  std::uint64_t count =
      0;              ///< rocks without faults (of its group, if it has one), or trials with such a rock
  double rocks = 0;   ///< real rocks of all these trials, the sum of the weights
  double weight = 1;  ///< the greatest of the rocks
  std::uint64_t needed = 0;  ///< needed_for(simulated_probability)
  /// The quantile 1 - simulated_probability and its interval with the confidence of the plan (see Sample);
  /// NaN if there are too few rocks or trials. With sectors, the greatest distance of the area, without an
  /// interval: the area holds with stated_confidence.
  Bounded distance{unknown, false};
  Interval interval = unknown_interval;  ///< with trials_needed if too few trials reach beyond the distance
  /// factor x distance; NaN without a factor. The factor is applied only here and not to the interval.
  double with_factor = unknown;

  BlastsBeyond beyond_distance;                  ///< without sectors, if the distance is given
  std::optional<BlastsBeyond> beyond_customary;  ///< if the plan has a customary distance

  AreaSummary area;      ///< if the plan asks for sectors
  LeastArea least_area;  ///< if the plan asks for it

  bool enough() const {
    return area.sectors.empty() ? count >= needed && interval.trials_needed == 0 : area.beyond.has_value();
  }
  /// Per blast, where rocks stand for several: of the real blasts at most `probability` go farther.
  bool is_upper_bound(const ClearancePlan& plan) const { return plan.per_blast && weight > 1; }
  /// The mean number of real rocks in a blast. The farthest rock of few is nearer than the farthest of many.
  /// NaN without a blast.
  double rocks_per_blast() const { return rocks / static_cast<double>(count); }
};

/// Computes the clearances of a scenario from rocks that are shown in passes; see read_in_passes().
class ClearanceTally {
 public:
  explicit ClearanceTally(const std::vector<ClearancePlan>& plans);
  void add(const TrialRecords& chunk);
  bool needs_another_pass();
  /// In the order of Scenario::clearances.
  std::vector<ClearanceSummary> summaries(Told told = Told::all) const;

 private:
  /// The rocks of a clearance, counted in the first pass.
  struct Counted {
    double rocks = 0;
    WeightRange weights;
    std::vector<Bounded> farthest;  ///< distance of each trial that has a rock
  };
  double probability(std::size_t clearance) const;
  BlastsBeyond beyond(std::size_t clearance, double distance) const;
  /// Adds the distances, intervals and areas to the counts.
  void put_distances(std::size_t clearance, ClearanceSummary& summary) const;

  std::vector<ClearancePlan> plans_;
  std::vector<Sample> samples_;       ///< distances
  std::vector<Counted> rocks_;        ///< in each sample
  bool counted_ = false;              ///< first pass is done
  std::vector<SectorTally> sectors_;  ///< empty if no sectors are asked for
  std::vector<LeastAreaTally> least_areas_;
};

}  // namespace flyrock
