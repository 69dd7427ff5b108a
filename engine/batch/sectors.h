#pragma once
// A clearance by azimuth: the blasting area as a polygon on the plan.

#include <cstdint>
#include <optional>
#include <vector>

#include "batch/statistics.h"

namespace flyrock {

/// The rocks that ended in one sector of azimuth about a point, by their horizontal distance from that point.
struct SectorSummary {
  double azimuth = 0;      ///< rad, of its middle, from +x towards +y
  std::uint64_t count = 0; ///< rocks without faults, or trials that have one there
  Bounded greatest{std::numeric_limits<double>::quiet_NaN(), false};
  /// What the share `probability` of these exceeds; NaN where they are fewer than needed_for(probability).
  Bounded distance{std::numeric_limits<double>::quiet_NaN(), false};
  /// factor x distance, or x greatest where there is no distance: where few rocks ended some did; NaN without a factor or rocks.
  double with_factor = std::numeric_limits<double>::quiet_NaN();
};

/// Finds the distances of a clearance with `sectors`, shown in passes; see read_in_passes(). A censored rock counts where it was
/// when its path was cut short.
class SectorTally {
 public:
  explicit SectorTally(const ClearancePlan& plan);
  void see(const TrialRecords& chunk);
  bool again();
  /// In the order of azimuth from 0: sector i holds [i, i + 1) 2 pi / sectors. `needed` as ClearanceSummary has it.
  std::vector<SectorSummary> summaries(std::uint64_t needed) const;

 private:
  struct Sector {
    Sample sample;
    Bounded greatest;
    std::uint64_t trial = 0;        ///< per blast: whose farthest rock `farthest` is
    std::optional<Bounded> farthest;
  };
  void end_trial(Sector& sector);

  ClearancePlan plan_;
  std::vector<Sector> sectors_;
};

}  // namespace flyrock
