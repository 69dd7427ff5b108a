#pragma once
// A clearance by azimuth: the blasting area as a polygon in plan view.

#include <cstdint>
#include <optional>
#include <vector>

#include "math/space.h"
#include "results/statistics/share.h"
#include "results/statistics/statistics.h"
#include "results/statistics/unknown.h"

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
  std::uint64_t count = 0;  ///< rocks without faults, or trials whose farthest rock is there
  Share share;              ///< of all rocks, or of all trials
  Bounded greatest{unknown, false};
  /// Where the area ends in this sector [m]: the (k + 1)-th greatest distance of effective rocks; 0 with
  /// fewer. NaN: no area.
  Bounded distance{unknown, false};
  double with_factor = unknown;  ///< factor x distance; NaN without a factor
};

/// The area that rocks leave with at most the probability of the clearance. Distances count from the convex
/// hull of all release places in plan view and azimuths about its centroid, or both count from a point. The
/// area is the union of the sectors, each up to its distance from the hull.
///
/// k of N independent rocks stop outside in each of s sectors. The share of new rocks that stop outside is
/// then distributed as Beta(s (k + 1), N + 1 - s (k + 1)) or less (order statistics; Wald 1943, An extension
/// of Wilks' method for setting tolerance limits). k is the greatest for which its 95 % quantile is at most
/// the probability. N counts effective rocks, and so does k: where rocks share their blast, a rock counts
/// 1 / design effect, so that a sector ends where the rocks from there on make k + 1 effective ones; with
/// weights it counts its share of the mean weight, too. Without any k, the number of sectors is halved;
/// without any in one sector there is no area.
struct AreaSummary {
  Vec2 centre = {unknown, unknown};
  std::vector<Vec2> hull;               ///< counter-clockwise
  std::optional<std::uint64_t> beyond;  ///< k; none: there is no area
  double effective = unknown;           ///< N: rocks / design effect, or trials
  /// In the order of azimuth from 0; see sector_of().
  std::vector<SectorSummary> sectors;

  /// The sector that reaches farthest; nullptr if there is no area.
  const SectorSummary* farthest() const;
};

/// k for s sectors and N effective rocks; none if there is no area.
std::optional<std::uint64_t> rocks_beyond(int sectors, double effective, double probability);

/// Computes the area of a clearance with `sectors` from rocks shown in passes; see read_in_passes(). A
/// censored rock counts at the place where its path was cut short.
class SectorTally {
 public:
  explicit SectorTally(const ClearancePlan& plan);
  void add(const TrialRecords& chunk);
  /// `design_effect`: of the share of rocks beyond the clearance without sectors, once it is known.
  bool needs_another_pass(std::optional<double> design_effect);
  AreaSummary summary() const;

 private:
  enum class Stage { releases, waiting, distances, done };
  struct Far {
    double distance, weight;  ///< in effective rocks
    bool operator>(const Far& other) const { return distance > other.distance; }
  };
  struct Sector {
    std::vector<Far>
        farthest;       ///< that weigh k + 1 together, and not without the nearest: a heap, it in front
    double weight = 0;  ///< of these
    Bounded greatest{0, false};
  };
  /// The end of a rock, or of the farthest rock of a trial.
  struct End {
    Vec2 place = Vec2::Zero();
    Bounded distance{-1, false};
  };
  void widen(const RockRecord& rock);
  End end_of(const RockRecord& rock) const;
  void add(const End& end, std::uint64_t trial, double weight);
  void add_farthest(const std::vector<RockRecord>& rocks);
  void choose_sectors(double design_effect);

  ClearancePlan plan_;
  Stage stage_ = Stage::releases;
  std::vector<Vec2> releases_;  ///< corners of the hull of the places so far, and some others; later the hull
  Vec2 centre_ = Vec2::Zero();
  std::uint64_t rocks_ = 0, trials_ = 0, last_trial_ = 0;
  WeightRange weights_;
  double weight_ = 0;  ///< of all rocks
  double effective_ = 0, design_effect_ = 1;
  std::optional<std::uint64_t> beyond_;
  std::vector<Sector> sectors_;
  ShareTally shares_;
};

}  // namespace flyrock
