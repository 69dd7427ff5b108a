#pragma once
// The runout by azimuth: how far rocks went in each direction from their own release, in 3D.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "record/records.h"
#include "results/statistics/share.h"
#include "results/statistics/unknown.h"

namespace flyrock {

/// Sectors of 10 deg, in the order of sector_of().
inline constexpr std::size_t azimuth_sectors = 36;

/// Percentiles of fewer rocks than these are not given.
inline constexpr std::uint64_t least_in_sector = 20;

inline constexpr std::array<double, 2> azimuth_percentiles = {0.5, 0.95};

/// The rocks whose runout points into one sector.
struct AzimuthSector {
  std::uint64_t count = 0;
  Share share;                       ///< of all rocks with a runout
  Bounded greatest{unknown, false};  ///< m; NaN without rocks
  struct Percentile {
    Bounded value{unknown, false};        ///< m; NaN with fewer than least_in_sector rocks
    Interval interval{unknown, unknown};  ///< with stated_confidence
  };
  std::array<Percentile, azimuth_percentiles.size()> percentiles;
};

struct RunoutByAzimuth {
  std::vector<AzimuthSector> sectors;  ///< none with Told::counts
  std::uint64_t still = 0;             ///< rocks that ended where they began: they have no azimuth
};

/// The sector that the runout of a rock points into; none if the rock ended where it began.
std::optional<std::size_t> azimuth_sector_of(const RockRecord& rock);

/// Computes it from rocks without faults, shown in passes; see read_in_passes().
class AzimuthTally {
 public:
  AzimuthTally();
  /// `sector`: azimuth_sector_of() the rock, which costs more than the rest and serves several tallies.
  void add(const RockRecord& rock, const std::optional<std::size_t>& sector);
  bool needs_another_pass();
  RunoutByAzimuth summary(Told told = Told::all) const;

 private:
  struct Sector {
    Sample sample;
    Bounded greatest;
  };
  std::vector<Sector> sectors_;
  ShareTally shares_{azimuth_sectors};
  std::uint64_t still_ = 0;
  bool counted_ = false;  ///< first pass is done
};

}  // namespace flyrock
