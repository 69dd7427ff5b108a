#pragma once
// A clearance by azimuth: the blasting area as a polygon on the plan.

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "math/space.h"
#include "results/share.h"
#include "results/statistics.h"
#include "results/unknown.h"

namespace flyrock {

/// The rocks that ended in one sector of azimuth, by their distance from the releases.
struct SectorSummary {
  double azimuth = 0;       ///< rad, of its middle, from +x towards +y
  std::uint64_t count = 0;  ///< rocks without faults, or trials that have one there
  Share share;              ///< of all rocks, or of all trials
  Bounded greatest{unknown, false};
  /// What the share `probability` of these exceeds, and its interval; NaN where they are fewer than
  /// needed_for(probability).
  Bounded distance{unknown, false};
  Interval interval{unknown, unknown};
  /// factor x distance, or x greatest where there is no distance: where few rocks ended some did; NaN without
  /// a factor or rocks.
  double with_factor = unknown;

  /// The distance of the polygon: `greatest` stands for a distance that is not known. NaN without rocks: no
  /// data.
  const Bounded& reach() const { return std::isnan(distance.value) ? greatest : distance; }
};

/// Distances count from a hull, azimuths about its centroid: from the convex hull of all release places in
/// plan, or from a point.
struct AreaSummary {
  Vec2 centre = Vec2::Zero();
  std::vector<Vec2> hull;  ///< counter-clockwise
  /// In the order of azimuth from 0: sector i holds [i, i + 1) 2 pi / sectors.
  std::vector<SectorSummary> sectors;

  /// The sector that reaches farthest; nullptr where no rock ended anywhere.
  const SectorSummary* farthest() const;
};

/// Finds the area of a clearance with `sectors`, shown in passes; see read_in_passes(). A censored rock
/// counts where it was when its path was cut short.
class SectorTally {
 public:
  explicit SectorTally(const ClearancePlan& plan);
  void see(const TrialRecords& chunk);
  bool again();
  /// `needed` as ClearanceSummary has it.
  AreaSummary summary(std::uint64_t needed) const;

 private:
  struct Sector {
    Sample sample;
    Bounded greatest;
    std::uint64_t trial = 0;  ///< per blast: whose farthest rock `farthest` is
    std::optional<Bounded> farthest;
  };
  void widen(const RockRecord& rock);  ///< the hull, in the first pass
  void add(const RockRecord& rock);    ///< its distance, in later ones
  void end_trial(Sector& sector);

  ClearancePlan plan_;
  bool hull_known_ = false;     ///< from the second pass on, or at once where the plan has a point
  bool counted_ = false;        ///< behind the first pass in which distances are shown
  std::vector<Vec2> releases_;  ///< the corners of the hull of those so far, and some more; then the hull
  Vec2 centre_ = Vec2::Zero();
  std::uint64_t total_ = 0, last_trial_ = 0;  ///< rocks, or trials that have one
  std::vector<Sector> sectors_;
};

}  // namespace flyrock
