#include "load/try_points.h"

#include <algorithm>

#include "document/node.h"
#include "load/try_out.h"

namespace flyrock {

void try_points(LoadedScenario& scenario, std::uint64_t trials, Diagnostics& diagnostics) {
  const auto place = [&](const std::string& path) { return node_at(scenario.root, path).key_at; };
  // Each point of a large sweep is tried with fewer rocks, so that this never takes longer than some seconds.
  constexpr std::size_t most_rocks = 2000, most_of_all_points = 40'000;
  const TryLimits limits{.trials = trials,
                         .rocks = std::min(most_rocks, most_of_all_points / scenario.plan.points.size())};
  for (const Scenario& point : scenario.plan.points) {
    const TriedOut tried = try_out(point, limits);
    for (const ScenarioError& error : tried.errors)
      diagnostics.error(place(error.path), error.path, error.what());
    for (const ScenarioError& warning : tried.warnings)
      diagnostics.warning(place(warning.path), warning.path, warning.what());
    if (scenario.tiers.empty()) scenario.tiers = tried.tiers;
    if (scenario.pile_cost.empty()) scenario.pile_cost = tried.pile_cost;
    if (scenario.deformable.empty()) scenario.deformable = tried.deformable;
  }
  for (std::string& warning : diagnostics.warnings()) scenario.warnings.push_back(std::move(warning));
}

}  // namespace flyrock
