#include "batch/clearance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "scenario/build_trial.h"
#include "scenario/node.h"

namespace flyrock {

namespace {

constexpr double beyond = 10;  // rocks that must be expected farther than a clearance

/// The distances of rocks, or of the farthest rock of each trial, that a clearance is of.
void add_distances(const std::vector<RockRecord>& rocks, const ClearancePlan& plan, Sample& sample) {
  const RockQuantity quantity = plan.of_max_distance ? RockQuantity::max_distance : RockQuantity::runout;
  std::optional<Bounded> farthest;  // of the trial
  for (std::size_t i = 0; i < rocks.size(); ++i) {
    if (!is_fault(rocks[i].reason)) {
      const Bounded value = quantity_of(rocks[i], quantity);
      if (!plan.per_blast) sample.add(value);
      // A censored rock may have gone farther than the farthest known one.
      farthest = farthest ? Bounded{std::max(farthest->value, value.value), farthest->censored || value.censored} : value;
    }
    if (i + 1 < rocks.size() && rocks[i + 1].trial == rocks[i].trial) continue;
    if (plan.per_blast && farthest) sample.add(*farthest);
    farthest.reset();
  }
}

/// Why the trials of a scenario are too few, or an empty text.
std::string too_few(const ClearancePlan& plan, std::uint64_t trials, std::uint64_t rocks_per_trial) {
  const std::uint64_t each = plan.per_blast ? 1 : rocks_per_trial;
  const std::uint64_t needed = needed_for(plan.probability);
  if (each == 0 || trials * each >= needed) return {};
  const std::uint64_t enough = (needed + each - 1) / each;
  return fmt::format(
      "only {:.3g} of {} {} would be beyond the distance, at least {} must be: expected at least {} {}, {}",
      plan.probability * static_cast<double>(trials * each), trials * each, plan.per_blast ? "blasts" : "rocks", beyond,
      needed, plan.per_blast ? "blasts" : "rocks",
      enough <= most_trials ? fmt::format("that is `trials: {}`", enough) : "more than a run may have");
}

}  // namespace

std::uint64_t needed_for(double probability) {
  // 10 / 0.07 * 0.07 may be a little less than 10; of a tiny probability it is more than a count can be.
  const double needed = std::ceil(beyond / probability * (1 - 1e-12));
  constexpr auto most = std::uint64_t{1} << 62;
  return needed < static_cast<double>(most) ? static_cast<std::uint64_t>(needed) : most;
}

ClearanceTally::ClearanceTally(const std::vector<ClearancePlan>& plans) : plans_(plans) {
  for (const ClearancePlan& plan : plans_) {
    const double p = 1 - plan.probability;
    samples_.emplace_back(Questions{{p}, {{p, plan.confidence}}});
    sectors_.emplace_back(plan);
  }
}

void ClearanceTally::see(const TrialRecords& chunk) {
  for (std::size_t c = 0; c < plans_.size(); ++c) {
    add_distances(chunk.rocks, plans_[c], samples_[c]);
    if (plans_[c].sectors > 0) sectors_[c].see(chunk);
  }
}

bool ClearanceTally::again() {
  bool more = false;
  for (Sample& sample : samples_) more |= sample.again();
  for (SectorTally& sectors : sectors_) more |= sectors.again();
  return more;
}

std::vector<ClearanceSummary> ClearanceTally::summaries() const {
  std::vector<ClearanceSummary> summaries;
  for (std::size_t c = 0; c < plans_.size(); ++c) {
    const ClearancePlan& plan = plans_[c];
    ClearanceSummary summary;
    summary.count = samples_[c].size();
    summary.needed = needed_for(plan.probability);
    if (summary.enough()) {
      summary.distance = samples_[c].quantile(1 - plan.probability);
      summary.interval = samples_[c].quantile_interval(1 - plan.probability, plan.confidence);
      if (plan.factor) summary.with_factor = *plan.factor * summary.distance.value;
    }
    summary.sectors = sectors_[c].summaries(summary.needed);
    summaries.push_back(summary);
  }
  return summaries;
}

namespace {
std::uint64_t rocks_of_a_trial(const Scenario& scenario) {
  return scenario.dimension == 2 ? TrialBuilder<2>(scenario).build(0).rocks.size()
                                 : TrialBuilder<3>(scenario).build(0).rocks.size();
}
}  // namespace

void check_clearances(const Value& root, const Plan& plan, Diagnostics& diagnostics) {
  const auto list = Node::root(root).find("clearance");
  if (!list) return;
  const std::vector<Node> items = list->items();
  std::vector<std::string> faults(items.size());
  for (const Scenario& scenario : plan.points) {
    try {
      const std::uint64_t rocks = rocks_of_a_trial(scenario);
      for (std::size_t i = 0; i < items.size(); ++i)
        if (faults[i].empty()) faults[i] = too_few(scenario.clearances[i], scenario.trials, rocks);
    } catch (const PluginError&) {
      return;
    }
  }
  for (std::size_t i = 0; i < items.size(); ++i)
    if (!faults[i].empty()) items[i].find("probability")->error(diagnostics, faults[i]);
}

}  // namespace flyrock
