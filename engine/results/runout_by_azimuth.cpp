#include "results/runout_by_azimuth.h"

#include "results/sectors.h"
#include "results/statistics.h"

namespace flyrock {

AzimuthTally::AzimuthTally() {
  Questions questions;
  for (const double p : azimuth_percentiles) {
    questions.quantiles.push_back(p);
    questions.intervals.push_back({p, stated_confidence});
  }
  sectors_.assign(azimuth_sectors, {Sample(questions), {}});
}

void AzimuthTally::add(const RockRecord& rock) {
  const Vec2 way(rock.stop_x - rock.start_x, rock.stop_y - rock.start_y);
  if (way == Vec2::Zero()) {
    still_ += !counted_;
    return;
  }
  Sector& sector = sectors_[sector_of(way, azimuth_sectors)];
  const Bounded runout = bounded(rock, rock_statistics[rock_statistic("runout")]);
  sector.greatest = farther(sector.greatest, runout);
  sector.sample.add(runout);
}

bool AzimuthTally::needs_another_pass() {
  counted_ = true;
  bool more = false;
  for (Sector& sector : sectors_) more |= sector.sample.needs_another_pass();
  return more;
}

RunoutByAzimuth AzimuthTally::summary() const {
  RunoutByAzimuth summary;
  summary.still = still_;
  std::uint64_t all = 0;
  for (const Sector& sector : sectors_) all += sector.sample.size();
  for (const Sector& sector : sectors_) {
    AzimuthSector& of = summary.sectors.emplace_back();
    of.count = sector.sample.size();
    of.share = share_of(of.count, all);
    if (of.count > 0) of.greatest = sector.greatest;
    if (of.count < least_in_sector) continue;
    for (std::size_t p = 0; p < azimuth_percentiles.size(); ++p)
      of.percentiles[p] = {sector.sample.quantile(azimuth_percentiles[p]),
                           sector.sample.quantile_interval(azimuth_percentiles[p], stated_confidence)};
  }
  return summary;
}

}  // namespace flyrock
