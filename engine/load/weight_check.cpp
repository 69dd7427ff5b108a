#include "load/weight_check.h"

#include <fmt/format.h>

#include <algorithm>

#include "document/node.h"
#include "load/rocks_of_trial.h"
#include "scenario/schema.h"
#include "trial/build_trial.h"

namespace flyrock {

namespace {

bool asks_per_blast(const Scenario& scenario) {
  return !scenario.gates.empty() || !scenario.barriers.empty() || !scenario.exposures.empty() ||
         std::any_of(scenario.clearances.begin(), scenario.clearances.end(),
                     [](const ClearancePlan& plan) { return plan.per_blast; });
}

bool may_weigh(const RockGroup& group) {
  const bool has_population = !group.table && !group.per_hole;
  return group.weight || (has_population && group.population.plugin->spec.name != default_population);
}

/// The greatest weight of each group over the points. A population says it in a trial.
std::vector<double> greatest_weights(const Plan& plan) {
  std::vector<double> greatest(plan.points.front().rocks.size(), 1);
  for (const Scenario& point : plan.points) {
    if (std::none_of(point.rocks.begin(), point.rocks.end(), may_weigh)) continue;
    const std::vector<RocksOfTrial> groups = rocks_of_a_trial(point);
    for (std::size_t g = 0; g < greatest.size(); ++g) greatest[g] = std::max(greatest[g], groups[g].greatest);
  }
  return greatest;
}

}  // namespace

void warn_of_weights(const Value& root, const Plan& plan, Diagnostics& diagnostics) {
  const auto rocks = Node::root(root).find("rocks");
  if (!rocks || !asks_per_blast(plan.points.front())) return;
  try {
    const std::vector<double> weights = greatest_weights(plan);
    const std::vector<Node> groups = rocks->items();
    for (std::size_t g = 0; g < weights.size(); ++g) {
      if (weights[g] < harmless_weight) continue;
      const Node at = groups.at(g).find("weight").value_or(groups.at(g));
      diagnostics.warning(
          at.value->at, at.path,
          fmt::format("a rock stands for {}{:.4g} real ones, and rocks of a blast share its draws: the "
                      "probability that a blast does something is then known only between bounds, which "
                      "lie apart by up to a factor of {:.4g}; below {:g} they tell it. The results name the "
                      "weight that would",
                      groups.at(g).find("weight") ? "" : "up to ", weights[g], weights[g], harmless_weight));
    }
  } catch (const TrialError&) {
    return;  // the run reports it, with the trial
  }
}

}  // namespace flyrock
