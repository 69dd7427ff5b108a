#include "batch/clearance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "scenario/build_trial.h"
#include "scenario/node.h"

namespace flyrock {

namespace {

constexpr double beyond = 10;  // rocks that must be expected farther than a clearance

std::vector<Bounded> distances_of(const std::vector<RockRecord>& rocks, const ClearancePlan& plan) {
  const RockQuantity quantity = plan.of_max_distance ? RockQuantity::max_distance : RockQuantity::runout;
  std::vector<Bounded> values;
  std::map<std::uint64_t, Bounded> farthest;  // of each trial
  for (const RockRecord& rock : rocks) {
    if (is_fault(rock.reason)) continue;
    const Bounded value = quantity_of(rock, quantity);
    if (plan.per_blast) {
      // A censored rock may have gone farther than the farthest known one.
      Bounded& trial = farthest[rock.trial];
      trial = {std::max(trial.value, value.value), trial.censored || value.censored};
    } else {
      values.push_back(value);
    }
  }
  for (const auto& [trial, value] : farthest) values.push_back(value);
  return values;
}

/// Why the trials of a scenario are too few, or an empty text.
std::string too_few(const ClearancePlan& plan, std::uint64_t trials, std::uint64_t rocks_per_trial) {
  const std::uint64_t each = plan.per_blast ? 1 : rocks_per_trial;
  const std::uint64_t needed = needed_for(plan.probability);
  if (each == 0 || trials * each >= needed) return {};
  return fmt::format(
      "only {:.3g} of {} {} would be beyond the distance, at least {} must be: expected at least {} {}, that is `trials: {}`",
      plan.probability * static_cast<double>(trials * each), trials * each, plan.per_blast ? "blasts" : "rocks", beyond,
      needed, plan.per_blast ? "blasts" : "rocks",
      (needed + each - 1) / each);
}

}  // namespace

std::uint64_t needed_for(double probability) {
  // 10 / 0.07 * 0.07 may be a little less than 10.
  return static_cast<std::uint64_t>(std::ceil(beyond / probability * (1 - 1e-12)));
}

std::vector<ClearanceSummary> summarise_clearances(const std::vector<RockRecord>& rocks, const Scenario& scenario) {
  std::vector<ClearanceSummary> summaries;
  for (const ClearancePlan& plan : scenario.clearances) {
    const Sample sample(distances_of(rocks, plan));
    ClearanceSummary summary;
    summary.count = sample.size();
    summary.needed = needed_for(plan.probability);
    if (summary.enough()) {
      summary.distance = sample.quantile(1 - plan.probability);
      summary.interval = sample.quantile_interval(1 - plan.probability, plan.confidence);
      if (plan.factor) summary.with_factor = *plan.factor * summary.distance.value;
    }
    summaries.push_back(summary);
  }
  return summaries;
}

void check_clearances(const Value& root, const Plan& plan, Diagnostics& diagnostics) {
  const auto list = Node::root(root).find("clearance");
  if (!list) return;
  const std::vector<Node> items = list->items();
  std::vector<std::string> faults(items.size());
  for (const Scenario& scenario : plan.points) {
    try {
      const std::uint64_t rocks = TrialBuilder(scenario).build(0).rocks.size();
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
