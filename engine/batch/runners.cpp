#include "batch/runners.h"

#include "load/try_points.h"

namespace flyrock {

Runners make_runners(const Plan& plan) {
  Runners runners;
  for (const Scenario& point : plan.points) runners.push_back(std::make_unique<TrialRunner>(point));
  return runners;
}

Runners try_runners(LoadedScenario& scenario, std::uint64_t trials, Diagnostics& diagnostics) {
  try_points(scenario, trials, diagnostics);
  return diagnostics.has_errors() ? Runners() : make_runners(scenario.plan);
}

}  // namespace flyrock
