#include "results/sectors.h"

#include <algorithm>
#include <cmath>

#include "geometry/plan_hull.h"

namespace flyrock {

std::size_t sector_of(const Vec2& direction, std::size_t n) {
  double turns = std::atan2(direction.y(), direction.x()) / (2 * pi);
  turns -= std::floor(turns);
  return std::min(static_cast<std::size_t>(turns * static_cast<double>(n)), n - 1);
}

Bounded farther(const Bounded& a, const Bounded& b) {
  return {std::max(a.value, b.value), a.censored || b.censored};
}

const SectorSummary* AreaSummary::farthest() const {
  const SectorSummary* best = nullptr;
  for (const SectorSummary& sector : sectors)
    if (sector.count > 0 && (!best || sector.reach().value > best->reach().value)) best = &sector;
  return best;
}

SectorTally::SectorTally(const ClearancePlan& plan) : plan_(plan) {
  if (plan.about) {
    releases_ = {*plan.about};
    centre_ = *plan.about;
    hull_known_ = true;
  }
  const double p = 1 - plan.probability;
  for (int i = 0; i < plan.sectors; ++i)
    sectors_.push_back({Sample(Questions{{p}, {{p, plan.confidence}}}), {}, 0, {}});
}

void SectorTally::add(const TrialRecords& chunk) {
  for (const RockRecord& rock : chunk.rocks) {
    if (is_fault(rock.reason) || !plan_.counts(rock.group)) continue;
    if (hull_known_)
      add(rock);
    else
      widen(rock);
  }
}

/// Few of a million places are corners of the hull; the others are dropped from time to time.
void SectorTally::widen(const RockRecord& rock) {
  constexpr std::size_t most = 4096;
  releases_.emplace_back(rock.start_x, rock.start_y);
  if (releases_.size() >= most && (releases_.size() & (releases_.size() - 1)) == 0)
    releases_ = plan_hull(std::move(releases_));
}

void SectorTally::add(const RockRecord& rock) {
  if (!counted_ && (!plan_.per_blast || total_ == 0 || last_trial_ != rock.trial)) ++total_;
  last_trial_ = rock.trial;
  const Vec2 end(rock.stop_x, rock.stop_y);
  Sector& sector = sectors_[sector_of(end - centre_, sectors_.size())];
  const Bounded distance{distance_from(releases_, end), rock.censored};
  sector.greatest = farther(sector.greatest, distance);
  if (!plan_.per_blast) return sector.sample.add(distance);
  if (sector.farthest && sector.trial != rock.trial) end_trial(sector);
  sector.trial = rock.trial;
  sector.farthest = sector.farthest ? farther(*sector.farthest, distance) : distance;
}

void SectorTally::end_trial(Sector& sector) {
  if (sector.farthest) sector.sample.add(*sector.farthest);
  sector.farthest.reset();
}

bool SectorTally::needs_another_pass() {
  if (sectors_.empty()) return false;
  if (!hull_known_) {
    releases_ = plan_hull(std::move(releases_));
    centre_ = centroid_of(releases_);
    hull_known_ = true;
    return !releases_.empty();
  }
  counted_ = true;
  bool more = false;
  for (Sector& sector : sectors_) {
    end_trial(sector);
    more |= sector.sample.needs_another_pass();
  }
  return more;
}

AreaSummary SectorTally::summary(std::uint64_t needed) const {
  AreaSummary area{centre_, releases_, {}};
  for (std::size_t i = 0; i < sectors_.size(); ++i) {
    const Sector& sector = sectors_[i];
    SectorSummary& summary = area.sectors.emplace_back();
    summary.azimuth = (static_cast<double>(i) + 0.5) * 2 * pi / plan_.sectors;
    summary.count = sector.sample.size();
    summary.share = share_of(summary.count, total_);
    if (summary.count > 0) summary.greatest = sector.greatest;
    if (summary.count >= needed) {
      summary.distance = sector.sample.quantile(1 - plan_.probability);
      summary.interval = sector.sample.quantile_interval(1 - plan_.probability, plan_.confidence);
    }
    if (plan_.factor) summary.with_factor = *plan_.factor * summary.reach().value;
  }
  return area;
}

}  // namespace flyrock
