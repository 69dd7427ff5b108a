#pragma once
// What the measures of rocks are read from: of all trials of a point, or of one of its runs.

#include <optional>
#include <vector>

#include "results/measured/measures.h"
#include "results/statistics/statistics.h"

namespace flyrock {

/// Computes it from rocks that are shown in passes; see read_in_passes().
class MeasureTally {
 public:
  explicit MeasureTally(const Scenario& scenario);
  void add(const TrialRecords& chunk);
  bool needs_another_pass();
  /// The runouts of all rocks, then of each group if there is more than one; after the first pass.
  std::vector<RunoutExtent> runout_extents() const { return rocks_.runout_extents(); }
  /// The distance of each clearance; NaN for those with sectors, which count from the release of each rock.
  /// Nothing while they are looked for.
  std::optional<std::vector<double>> clearance_distances() const;
  /// Counts only, where too many rocks failed; after the first pass.
  Told told() const;
  /// After the last pass. `trials`: all that ran, also those without rocks.
  void put(PointResult& result, std::uint64_t trials);

 private:
  const Scenario& scenario_;
  RockTally rocks_;
  CrossingTallies crossings_;
  std::optional<TreeTally> trees_;
  BlockTally blocks_;
  ClearanceTally clearances_;
  ExposureTally exposures_;
  bool first_pass_ = true, seeks_distances_ = true;
};

}  // namespace flyrock
