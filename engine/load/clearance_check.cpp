#include "load/clearance_check.h"

#include <fmt/format.h>

#include <cmath>

#include "document/node.h"
#include "document/value.h"
#include "load/rocks_of_trial.h"
#include "scenario/plan.h"
#include "trial/build_trial.h"

namespace flyrock {

namespace {

constexpr double beyond = 10;  // rocks that must be expected beyond a clearance

/// Why a scenario has too few trials; empty if it has enough.
std::string too_few(const ClearancePlan& plan, std::uint64_t trials, const RocksOfTrial& rocks) {
  const std::uint64_t each = plan.per_blast ? 1 : rocks.count;
  const double probability = plan.simulated_probability(rocks.greatest);
  const std::uint64_t needed = needed_for(probability);
  if (rocks.count == 0 || trials * each >= needed) return {};
  const std::uint64_t enough = (needed + each - 1) / each;
  return fmt::format(
      "only {:.3g} of {} {} would be beyond the distance, at least {} must be: expected at least {} {}, {}",
      probability * static_cast<double>(trials * each), trials * each, plan.per_blast ? "blasts" : "rocks",
      beyond, needed, plan.per_blast ? "blasts" : "rocks",
      enough <= most_trials ? fmt::format("that is `trials: {}`", enough) : "more than a run may have");
}

RocksOfTrial rocks_of(const ClearancePlan& plan, const std::vector<RocksOfTrial>& groups) {
  RocksOfTrial rocks;
  for (std::size_t g = 0; g < groups.size(); ++g)
    if (plan.counts(static_cast<int>(g))) rocks.add(groups[g]);
  return rocks;
}

/// What is wrong with a clearance of the scenario's tree.
struct Objections {
  std::string error, warning;
};

void object(const ClearancePlan& plan, std::uint64_t trials, const RocksOfTrial& rocks, bool full,
            Objections& objections) {
  if (full && objections.error.empty()) objections.error = too_few(plan, trials, rocks);
  if (plan.per_blast && rocks.real < few_rocks_per_blast && objections.warning.empty())
    objections.warning = fmt::format(
        "each simulated blast has only {:.4g} rock{}. A real blast throws thousands, and the farthest of "
        "them "
        "goes "
        "farther; expected at least {} a blast, or `per: rock`",
        rocks.real, rocks.real == 1 ? "" : "s", few_rocks_per_blast);
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
      const std::vector<RocksOfTrial> rocks = rocks_of_a_trial(scenario);
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
