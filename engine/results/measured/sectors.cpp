#include "results/measured/sectors.h"

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <cmath>
#include <functional>

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
  if (!beyond) return nullptr;
  const auto nearer = [](const SectorSummary& a, const SectorSummary& b) {
    return a.distance.value < b.distance.value;
  };
  return &*std::max_element(sectors.begin(), sectors.end(), nearer);
}

std::optional<std::uint64_t> rocks_beyond(int sectors, double effective, double probability) {
  const auto holds = [&](std::uint64_t k) {
    const double a = sectors * static_cast<double>(k + 1), b = effective + 1 - a;
    if (!(b > 0)) return false;
    return boost::math::quantile(boost::math::beta_distribution<>(a, b), stated_confidence) <= probability;
  };
  if (!holds(0)) return std::nullopt;
  // The mean of the distribution must be below the probability.
  std::uint64_t low = 0, high = static_cast<std::uint64_t>(effective * probability / sectors) + 1;
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

SectorTally::SectorTally(const ClearancePlan& plan) : plan_(plan) {
  if (plan.about) {
    releases_ = {*plan.about};
    centre_ = *plan.about;
  }
}

void SectorTally::add(const TrialRecords& chunk) {
  if (plan_.sectors == 0 || stage_ == Stage::waiting || stage_ == Stage::done) return;
  if (stage_ == Stage::distances && plan_.per_blast) return add_farthest(chunk.rocks);
  for (const RockRecord& rock : chunk.rocks) {
    if (is_fault(rock.reason) || !plan_.counts(rock.group)) continue;
    if (stage_ == Stage::releases)
      widen(rock);
    else
      add(end_of(rock), rock.trial, rock.weight);
  }
}

/// Few of a million places are corners of the hull; the others are dropped from time to time.
void SectorTally::widen(const RockRecord& rock) {
  constexpr std::size_t most = 4096;
  ++rocks_;
  weights_.add(rock.weight);
  weight_ += rock.weight;
  trials_ += rocks_ == 1 || rock.trial != last_trial_;
  last_trial_ = rock.trial;
  if (plan_.about) return;
  releases_.emplace_back(rock.start_x, rock.start_y);
  if (releases_.size() >= most && (releases_.size() & (releases_.size() - 1)) == 0)
    releases_ = plan_hull(std::move(releases_));
}

SectorTally::End SectorTally::end_of(const RockRecord& rock) const {
  const Vec2 place(rock.stop_x, rock.stop_y);
  return {place, {distance_from(releases_, place), rock.censored}};
}

/// Trials are never split between chunks.
void SectorTally::add_farthest(const std::vector<RockRecord>& rocks) {
  std::optional<End> farthest;
  for (std::size_t i = 0; i < rocks.size(); ++i) {
    if (!is_fault(rocks[i].reason) && plan_.counts(rocks[i].group)) {
      const End end = end_of(rocks[i]);
      if (!farthest || end.distance.value > farthest->distance.value)
        farthest =
            End{end.place,
                {end.distance.value, end.distance.censored || (farthest && farthest->distance.censored)}};
      else
        farthest->distance.censored |= end.distance.censored;
    }
    if (i + 1 < rocks.size() && rocks[i + 1].trial == rocks[i].trial) continue;
    if (farthest) add(*farthest, rocks[i].trial, 1);
    farthest.reset();
  }
}

void SectorTally::add(const End& end, std::uint64_t trial, double weight) {
  const std::size_t at = sector_of(end.place - centre_, sectors_.size());
  shares_.add(trial, weight);
  shares_.count(at);
  Sector& sector = sectors_[at];
  sector.greatest = farther(sector.greatest, end.distance);
  const auto nearest_first = std::greater<>();
  const double units =
      (weights_.differ() ? weight * static_cast<double>(rocks_) / weight_ : 1) / design_effect_;
  const auto needed = static_cast<double>(beyond_.value_or(0) + 1);
  sector.farthest.push_back({end.distance.value, units});
  sector.weight += units;
  std::push_heap(sector.farthest.begin(), sector.farthest.end(), nearest_first);
  while (sector.weight - sector.farthest.front().weight >= needed) {
    sector.weight -= sector.farthest.front().weight;
    std::pop_heap(sector.farthest.begin(), sector.farthest.end(), nearest_first);
    sector.farthest.pop_back();
  }
}

bool SectorTally::needs_another_pass(std::optional<double> design_effect) {
  if (plan_.sectors == 0) return false;
  switch (stage_) {
    case Stage::releases:
      if (!plan_.about) {
        releases_ = plan_hull(std::move(releases_));
        centre_ = centroid_of(releases_);
      }
      stage_ = rocks_ == 0 ? Stage::done : Stage::waiting;
      break;
    case Stage::waiting:
      break;
    case Stage::distances:
      shares_.close();
      stage_ = Stage::done;
      break;
    case Stage::done:
      break;
  }
  if (stage_ == Stage::waiting && design_effect) {
    choose_sectors(*design_effect);
    stage_ = Stage::distances;
  }
  return stage_ != Stage::done;
}

void SectorTally::choose_sectors(double design_effect) {
  if (!plan_.per_blast) design_effect_ = design_effect;
  effective_ = static_cast<double>(plan_.per_blast ? trials_ : rocks_) / design_effect_;
  const double probability = plan_.simulated_probability(weights_.greatest());
  int count = plan_.sectors;
  beyond_ = rocks_beyond(count, effective_, probability);
  while (!beyond_ && count > 1) {
    count /= 2;
    beyond_ = rocks_beyond(count, effective_, probability);
  }
  if (!beyond_) count = plan_.sectors;  // no area, but the farthest rock of each sector
  sectors_.resize(static_cast<std::size_t>(count));
  shares_ = ShareTally(sectors_.size());
}

AreaSummary SectorTally::summary() const {
  AreaSummary area{centre_, releases_, beyond_, effective_, {}};
  for (std::size_t i = 0; i < sectors_.size(); ++i) {
    const Sector& sector = sectors_[i];
    SectorSummary& summary = area.sectors.emplace_back();
    summary.azimuth = (static_cast<double>(i) + 0.5) * 2 * pi / static_cast<double>(sectors_.size());
    summary.count = shares_.counted(i);
    summary.share = shares_.of_rocks(i);
    if (summary.count > 0) summary.greatest = sector.greatest;
    if (!beyond_) continue;
    const bool reaches = sector.weight >= static_cast<double>(*beyond_ + 1);
    summary.distance = {reaches ? sector.farthest.front().distance : 0, sector.greatest.censored};
    if (plan_.factor) summary.with_factor = *plan_.factor * summary.distance.value;
  }
  return area;
}

}  // namespace flyrock
