#include "batch/clearance_check.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "document/node.h"
#include "document/value.h"
#include "scenario/plan.h"
#include "trial/build_trial.h"

namespace flyrock {

namespace {

constexpr double beyond = 10;  // rocks that must be expected beyond a clearance

/// Why a scenario has too few trials; empty if it has enough.
std::string too_few(const ClearancePlan& plan, std::uint64_t trials, std::uint64_t rocks_per_trial) {
  const std::uint64_t each = plan.per_blast ? 1 : rocks_per_trial;
  const std::uint64_t needed = needed_for(plan.probability);
  if (each == 0 || trials * each >= needed) return {};
  const std::uint64_t enough = (needed + each - 1) / each;
  return fmt::format(
      "only {:.3g} of {} {} would be beyond the distance, at least {} must be: expected at least {} {}, {}",
      plan.probability * static_cast<double>(trials * each), trials * each,
      plan.per_blast ? "blasts" : "rocks", beyond, needed, plan.per_blast ? "blasts" : "rocks",
      enough <= most_trials ? fmt::format("that is `trials: {}`", enough) : "more than a run may have");
}

/// The number of rocks of each group in a trial. The first trial stands for all.
std::vector<std::uint64_t> rocks_of_a_trial(const Scenario& scenario) {
  std::vector<std::uint64_t> counts(scenario.rocks.size(), 0);
  const auto count = [&](const auto& trial) {
    for (const TrialRock& rock : trial.rocks) ++counts.at(static_cast<std::size_t>(rock.group));
  };
  if (scenario.dimension == 2)
    count(TrialBuilder<2>(scenario).build(0));
  else
    count(TrialBuilder<3>(scenario).build(0));
  return counts;
}

std::uint64_t rocks_of(const ClearancePlan& plan, const std::vector<std::uint64_t>& groups) {
  if (plan.group >= 0) return groups.at(static_cast<std::size_t>(plan.group));
  return std::accumulate(groups.begin(), groups.end(), std::uint64_t{0});
}

/// What is wrong with a clearance of the scenario's tree.
struct Objections {
  std::string error, warning;
};

void object(const ClearancePlan& plan, std::uint64_t trials, std::uint64_t rocks, bool full,
            Objections& objections) {
  if (full && objections.error.empty()) objections.error = too_few(plan, trials, rocks);
  if (plan.per_blast && rocks < few_rocks_per_blast && objections.warning.empty())
    objections.warning = fmt::format(
        "each simulated blast has only {} rock{}. A real blast throws thousands, and the farthest of them "
        "goes "
        "farther; expected at least {} a blast, or `per: rock`",
        rocks, rocks == 1 ? "" : "s", few_rocks_per_blast);
}

}  // namespace

std::uint64_t needed_for(double probability) {
  // 10 / 0.07 * 0.07 may be slightly less than 10. For a tiny probability the result does not fit into the
  // count.
  const double needed = std::ceil(beyond / probability * (1 - 1e-12));
  constexpr auto most = std::uint64_t{1} << 62;
  return needed < static_cast<double>(most) ? static_cast<std::uint64_t>(needed) : most;
}

void check_clearances(const Value& root, const Plan& plan, bool full, Diagnostics& diagnostics) {
  const auto list = Node::root(root).find("clearance");
  if (!list) return;
  const std::vector<Node> items = list->items();
  std::vector<Objections> objections(items.size());
  for (const Scenario& scenario : plan.points) {
    try {
      const std::vector<std::uint64_t> rocks = rocks_of_a_trial(scenario);
      for (std::size_t i = 0; i < items.size(); ++i)
        object(scenario.clearances[i], scenario.trials, rocks_of(scenario.clearances[i], rocks), full,
               objections[i]);
    } catch (const TrialError&) {
      return;
    }
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!objections[i].error.empty()) items[i].find("probability")->error(diagnostics, objections[i].error);
    if (objections[i].warning.empty()) continue;
    const Node per = *items[i].find("per");
    diagnostics.warning(per.value->at, per.path, objections[i].warning);
  }
}

}  // namespace flyrock
