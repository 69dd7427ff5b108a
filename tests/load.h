#pragma once
// Scenario files of the tests, as a user's.

#include <catch2/catch.hpp>

#include "batch/load.h"
#include "batch/trial.h"

namespace flyrock {

/// The scenario of a file, named from the project's folder. Where it is wrong the test ends with its
/// messages.
inline LoadedScenario loaded(const std::string& file, const Overrides& overrides = {}) {
  Diagnostics diagnostics;
  std::optional<LoadedScenario> scenario =
      load_scenario(FLYROCK_SOURCE_DIR "/" + file, overrides, diagnostics);
  INFO(diagnostics.to_text());
  REQUIRE(scenario);
  return std::move(*scenario);
}

/// What trial 0 leaves.
inline TrialRecords first_trial(const LoadedScenario& scenario) {
  TrialRunner runner(scenario.plan.points.front());
  TrialRecords records;
  runner.run(0, records);
  return records;
}

}  // namespace flyrock
