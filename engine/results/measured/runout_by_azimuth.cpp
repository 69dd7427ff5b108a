#include "results/measured/runout_by_azimuth.h"

#include "results/measured/sectors.h"
#include "results/statistics/statistics.h"

namespace flyrock {

AzimuthTally::AzimuthTally() {
  Questions questions;
  for (const double p : azimuth_percentiles) {
    questions.quantiles.push_back(p);
    questions.intervals.push_back({p, stated_confidence});
  }
  sectors_.assign(azimuth_sectors, {Sample(questions), {}});
}

std::optional<std::size_t> azimuth_sector_of(const RockRecord& rock) {
  const Vec2 way(rock.stop_x - rock.start_x, rock.stop_y - rock.start_y);
  if (way == Vec2::Zero()) return std::nullopt;
  return sector_of(way, azimuth_sectors);
}

void AzimuthTally::add(const RockRecord& rock, const std::optional<std::size_t>& sector) {
  if (!sector) {
    still_ += !counted_;
    return;
  }
  if (!counted_) {
    shares_.add(rock.trial, rock.weight);
    shares_.count(*sector);
  }
  Sector& of = sectors_[*sector];
  const Bounded runout = bounded(rock, rock_statistics[rock_statistic("runout")]);
  of.greatest = farther(of.greatest, runout);
  of.sample.add(runout, rock.trial, rock.weight);
}

bool AzimuthTally::needs_another_pass() {
  counted_ = true;
  shares_.close();
  bool more = false;
  for (Sector& sector : sectors_) more |= sector.sample.needs_another_pass();
  return more;
}

RunoutByAzimuth AzimuthTally::summary(Told told) const {
  RunoutByAzimuth summary;
  summary.still = still_;
  if (told == Told::counts) return summary;
  for (std::size_t i = 0; i < sectors_.size(); ++i) {
    const Sector& sector = sectors_[i];
    AzimuthSector& of = summary.sectors.emplace_back();
    of.count = sector.sample.size();
    of.share = shares_.of_rocks(i);
    if (of.count > 0) of.greatest = sector.greatest;
    if (of.count < least_in_sector) continue;
    for (std::size_t p = 0; p < azimuth_percentiles.size(); ++p)
      of.percentiles[p] = {sector.sample.quantile(azimuth_percentiles[p]),
                           sector.sample.quantile_interval(azimuth_percentiles[p], stated_confidence)};
  }
  return summary;
}

}  // namespace flyrock
