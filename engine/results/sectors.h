#pragma once
// A clearance by azimuth: the blasting area as a polygon in plan view.

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "math/space.h"
#include "results/share.h"
#include "results/statistics.h"
#include "results/unknown.h"

namespace flyrock {

/// The sector of a direction in plan: sector i of n holds azimuths, from +x towards +y, from i to i + 1 times
/// 2 pi / n, without its end.
std::size_t sector_of(const Vec2& direction, std::size_t n);

/// The greater of two distances; censored if either is, because a censored rock may have gone farther than
/// the farthest known one.
Bounded farther(const Bounded& a, const Bounded& b);

/// The rocks that ended in one sector of azimuth, by their distance from the release places.
struct SectorSummary {
  double azimuth = 0;       ///< rad, middle of the sector, from +x towards +y
  std::uint64_t count = 0;  ///< rocks without faults, or trials with such a rock there
  Share share;              ///< share of all rocks, or of all trials
  Bounded greatest{unknown, false};
  /// The distance that a share `probability` of these exceeds, and its interval; NaN if there are fewer than
  /// needed_for(probability).
  Bounded distance{unknown, false};
  Interval interval{unknown, unknown};
  /// factor x distance, or factor x greatest if the distance is unknown, because even with few rocks some
  /// ended here. NaN without a factor or rocks.
  double with_factor = unknown;

  /// The distance of the polygon: `distance`, or `greatest` if that is unknown. NaN without rocks: no data.
  const Bounded& reach() const { return std::isnan(distance.value) ? greatest : distance; }
};

/// The area by azimuth. Distances count from the convex hull of all release places in plan view and azimuths
/// about its centroid, or both count from a point.
struct AreaSummary {
  Vec2 centre = Vec2::Zero();
  std::vector<Vec2> hull;  ///< counter-clockwise
  /// In the order of azimuth from 0; see sector_of().
  std::vector<SectorSummary> sectors;

  /// The sector that reaches farthest; nullptr if no rock ended anywhere.
  const SectorSummary* farthest() const;
};

/// Computes the area of a clearance with `sectors` from rocks shown in passes; see read_in_passes(). A
/// censored rock counts at the place where its path was cut short.
class SectorTally {
 public:
  explicit SectorTally(const ClearancePlan& plan);
  void add(const TrialRecords& chunk);
  bool needs_another_pass();
  /// `needed`: as in ClearanceSummary.
  AreaSummary summary(std::uint64_t needed) const;

 private:
  struct Sector {
    Sample sample;
    Bounded greatest;
    std::uint64_t trial = 0;  ///< per blast: the trial of the rock `farthest`
    std::optional<Bounded> farthest;
  };
  void widen(const RockRecord& rock);  ///< widens the hull, in the first pass
  void add(const RockRecord& rock);    ///< adds the distance, in later passes
  void end_trial(Sector& sector);

  ClearancePlan plan_;
  bool hull_known_ = false;     ///< from the second pass on, or at once if the plan has a point
  bool counted_ = false;        ///< the first pass with distances is done
  std::vector<Vec2> releases_;  ///< corners of the hull of the places so far, and some others; later the hull
  Vec2 centre_ = Vec2::Zero();
  std::uint64_t total_ = 0, last_trial_ = 0;  ///< rocks, or trials with such a rock
  std::vector<Sector> sectors_;
};

}  // namespace flyrock
