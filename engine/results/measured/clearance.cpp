#include "results/measured/clearance.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "results/statistics/share.h"

namespace flyrock {

namespace {

/// Adds the distances of rocks, or of the farthest rock of each trial, for a clearance. Shows each rock to
/// `see`, and the farthest one of each trial to `see_farthest`.
template <class See, class SeeFarthest>
void add_distances(const std::vector<RockRecord>& rocks, const ClearancePlan& plan, Sample& sample, See see,
                   SeeFarthest see_farthest) {
  const RockStatistic& distance =
      rock_statistics[plan.of_max_distance ? rock_statistic("max_distance") : rock_statistic("runout")];
  std::optional<Bounded> farthest;  // in the trial
  for (std::size_t i = 0; i < rocks.size(); ++i) {
    if (!is_fault(rocks[i].reason) && plan.counts(rocks[i].group)) {
      see(rocks[i]);
      const Bounded value = bounded(rocks[i], distance);
      if (!plan.per_blast) sample.add(value, rocks[i].trial, rocks[i].weight);
      // A censored rock may have gone farther than the farthest known one.
      farthest = farthest
                     ? Bounded{std::max(farthest->value, value.value), farthest->censored || value.censored}
                     : value;
    }
    if (i + 1 < rocks.size() && rocks[i + 1].trial == rocks[i].trial) continue;
    if (farthest) see_farthest(*farthest);
    if (plan.per_blast && farthest) sample.add(*farthest, rocks[i].trial);
    farthest.reset();
  }
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
    samples_.emplace_back();
    rocks_.emplace_back();
    sectors_.emplace_back(plan);
    least_areas_.emplace_back(plan);
  }
}

void ClearanceTally::add(const TrialRecords& chunk) {
  for (std::size_t c = 0; c < plans_.size(); ++c) {
    const auto count = [&](const RockRecord& rock) {
      if (counted_) return;
      rocks_[c].rocks += rock.weight;
      rocks_[c].weights.add(rock.weight);
    };
    const auto count_trial = [&](const Bounded& farthest) {
      if (!counted_) rocks_[c].farthest.push_back(farthest);
    };
    add_distances(chunk.rocks, plans_[c], samples_[c], count, count_trial);
    sectors_[c].add(chunk);
    least_areas_[c].add(chunk);
  }
}

double ClearanceTally::probability(std::size_t clearance) const {
  return plans_[clearance].simulated_probability(rocks_[clearance].weights.greatest());
}

bool ClearanceTally::needs_another_pass() {
  for (std::size_t c = 0; c < plans_.size() && !counted_; ++c) {
    const double p = 1 - probability(c);
    samples_[c].ask({{p}, {{p, plans_[c].confidence}}});
  }
  counted_ = true;
  bool more = false;
  for (std::size_t c = 0; c < plans_.size(); ++c) {
    const double p = 1 - probability(c);
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

BlastsBeyond ClearanceTally::beyond(std::size_t clearance, double distance) const {
  std::uint64_t blasts = 0, open = 0;
  for (const Bounded& farthest : rocks_[clearance].farthest) {
    if (farthest.value > distance)
      ++blasts;
    else if (farthest.censored)
      ++open;
  }
  const Share share = share_of(blasts, rocks_[clearance].farthest.size(), open);
  const WeightRange& weights = rocks_[clearance].weights;
  const SimulatedBlasts simulated{share.value, share.interval, share.value, share.interval, weights, {}};
  return {distance, rocks_[clearance].farthest.size(), bounds_of(simulated), share.censored};
}

void ClearanceTally::put_distances(std::size_t c, ClearanceSummary& summary) const {
  const ClearancePlan& plan = plans_[c];
  summary.interval = {unknown, unknown};
  if (plan.sectors > 0) {
    summary.area = sectors_[c].summary();
    take_farthest(summary);
  } else if (summary.count >= summary.needed) {
    summary.interval = samples_[c].quantile_interval(1 - probability(c), plan.confidence);
    if (summary.enough()) summary.distance = samples_[c].quantile(1 - probability(c));
  }
  if (plan.factor) summary.with_factor = *plan.factor * summary.distance.value;
  if (plan.sectors == 0 && !std::isnan(summary.distance.value))
    summary.beyond_distance = beyond(c, summary.distance.value);
  if (plan.customary) summary.beyond_customary = beyond(c, *plan.customary);
}

std::vector<ClearanceSummary> ClearanceTally::summaries(Told told) const {
  std::vector<ClearanceSummary> summaries;
  for (std::size_t c = 0; c < plans_.size(); ++c) {
    ClearanceSummary& summary = summaries.emplace_back();
    summary.count = samples_[c].size();
    summary.rocks = rocks_[c].rocks;
    if (rocks_[c].weights.any_rock()) summary.weight = rocks_[c].weights.greatest();
    summary.needed = needed_for(probability(c));
    if (plans_[c].customary) summary.beyond_customary = BlastsBeyond{.distance = *plans_[c].customary};
    summary.least_area = least_areas_[c].summary(told);
    if (told == Told::all) put_distances(c, summary);
  }
  return summaries;
}

}  // namespace flyrock
