#include "batch/sectors.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

namespace {

/// The farther of two, where a censored rock may have gone farther than the farthest known one.
Bounded farther(const Bounded& a, const Bounded& b) { return {std::max(a.value, b.value), a.censored || b.censored}; }

}  // namespace

SectorTally::SectorTally(const ClearancePlan& plan) : plan_(plan) {
  const Questions question{{1 - plan.probability}, {}};
  for (int i = 0; i < plan.sectors; ++i) sectors_.push_back({Sample(question), {}, 0, {}});
}

void SectorTally::end_trial(Sector& sector) {
  if (sector.farthest) sector.sample.add(*sector.farthest);
  sector.farthest.reset();
}

void SectorTally::see(const TrialRecords& chunk) {
  for (const RockRecord& rock : chunk.rocks) {
    if (is_fault(rock.reason)) continue;
    const double x = rock.stop_x - plan_.x, y = rock.stop_y - plan_.y;
    double turns = std::atan2(y, x) / (2 * pi);
    turns -= std::floor(turns);
    const auto last = static_cast<std::size_t>(plan_.sectors - 1);
    Sector& sector = sectors_[std::min(static_cast<std::size_t>(turns * plan_.sectors), last)];
    const Bounded distance{std::hypot(x, y), rock.censored};
    sector.greatest = farther(sector.greatest, distance);
    if (!plan_.per_blast) {
      sector.sample.add(distance);
      continue;
    }
    if (sector.farthest && sector.trial != rock.trial) end_trial(sector);
    sector.trial = rock.trial;
    sector.farthest = sector.farthest ? farther(*sector.farthest, distance) : distance;
  }
}

bool SectorTally::again() {
  bool more = false;
  for (Sector& sector : sectors_) {
    end_trial(sector);
    more |= sector.sample.again();
  }
  return more;
}

std::vector<SectorSummary> SectorTally::summaries(std::uint64_t needed) const {
  std::vector<SectorSummary> summaries;
  for (std::size_t i = 0; i < sectors_.size(); ++i) {
    const Sector& sector = sectors_[i];
    SectorSummary summary;
    summary.azimuth = (static_cast<double>(i) + 0.5) * 2 * pi / plan_.sectors;
    summary.count = sector.sample.size();
    if (summary.count > 0) summary.greatest = sector.greatest;
    if (summary.count >= needed) summary.distance = sector.sample.quantile(1 - plan_.probability);
    if (plan_.factor) summary.with_factor = *plan_.factor * (summary.count >= needed ? summary.distance : summary.greatest).value;
    summaries.push_back(summary);
  }
  return summaries;
}

}  // namespace flyrock
