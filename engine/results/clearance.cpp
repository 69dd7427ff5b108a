#include "results/clearance.h"

#include <algorithm>
#include <optional>

namespace flyrock {

namespace {

/// Adds the distances of rocks, or of the farthest rock of each trial, for a clearance. Returns the number of
/// rocks considered.
std::uint64_t add_distances(const std::vector<RockRecord>& rocks, const ClearancePlan& plan, Sample& sample) {
  const RockStatistic& distance =
      rock_statistics[plan.of_max_distance ? rock_statistic("max_distance") : rock_statistic("runout")];
  std::uint64_t count = 0;
  std::optional<Bounded> farthest;  // in the trial
  for (std::size_t i = 0; i < rocks.size(); ++i) {
    if (!is_fault(rocks[i].reason) && plan.counts(rocks[i].group)) {
      ++count;
      const Bounded value = bounded(rocks[i], distance);
      if (!plan.per_blast) sample.add(value, rocks[i].trial, rocks[i].weight);
      // A censored rock may have gone farther than the farthest known one.
      farthest = farthest
                     ? Bounded{std::max(farthest->value, value.value), farthest->censored || value.censored}
                     : value;
    }
    if (i + 1 < rocks.size() && rocks[i + 1].trial == rocks[i].trial) continue;
    if (plan.per_blast && farthest) sample.add(*farthest, rocks[i].trial);
    farthest.reset();
  }
  return count;
}

/// With sectors, the distance is the farthest one of the area. If another sector is a lower bound, that
/// sector may reach farther still.
void take_farthest(ClearanceSummary& summary) {
  const SectorSummary* farthest = summary.area.farthest();
  if (!farthest) return;
  summary.distance = farthest->distance;
  for (const SectorSummary& sector : summary.area.sectors)
    summary.distance.censored |= sector.distance.censored;
}

}  // namespace

ClearanceTally::ClearanceTally(const std::vector<ClearancePlan>& plans) : plans_(plans) {
  for (const ClearancePlan& plan : plans_) {
    const double p = 1 - plan.probability;
    samples_.emplace_back(Questions{{p}, {{p, plan.confidence}}});
    rocks_.push_back(0);
    sectors_.emplace_back(plan);
    least_areas_.emplace_back(plan);
  }
}

void ClearanceTally::add(const TrialRecords& chunk) {
  for (std::size_t c = 0; c < plans_.size(); ++c) {
    const std::uint64_t rocks = add_distances(chunk.rocks, plans_[c], samples_[c]);
    if (!counted_) rocks_[c] += rocks;
    sectors_[c].add(chunk);
    least_areas_[c].add(chunk);
  }
}

bool ClearanceTally::needs_another_pass() {
  counted_ = true;
  bool more = false;
  for (std::size_t c = 0; c < plans_.size(); ++c) {
    const double p = 1 - plans_[c].probability;
    std::optional<LeastAreaTally::Clearance> found;
    if (samples_[c].needs_another_pass())
      more = true;
    else if (samples_[c].size() > 0)
      found = {samples_[c].quantile(p).value,
               samples_[c].quantile_interval(p, plans_[c].confidence).design_effect};
    more |= sectors_[c].needs_another_pass(found ? std::optional(found->design_effect) : std::nullopt);
    more |= least_areas_[c].needs_another_pass(found);
  }
  return more;
}

std::vector<ClearanceSummary> ClearanceTally::summaries() const {
  std::vector<ClearanceSummary> summaries;
  for (std::size_t c = 0; c < plans_.size(); ++c) {
    const ClearancePlan& plan = plans_[c];
    ClearanceSummary& summary = summaries.emplace_back();
    summary.count = samples_[c].size();
    summary.rocks = rocks_[c];
    summary.needed = needed_for(plan.probability);
    if (plan.sectors > 0) {
      summary.area = sectors_[c].summary();
      take_farthest(summary);
    } else if (summary.count >= summary.needed) {
      summary.interval = samples_[c].quantile_interval(1 - plan.probability, plan.confidence);
      if (summary.enough()) summary.distance = samples_[c].quantile(1 - plan.probability);
    }
    summary.least_area = least_areas_[c].summary();
    if (plan.factor) summary.with_factor = *plan.factor * summary.distance.value;
  }
  return summaries;
}

}  // namespace flyrock
