#pragma once
// Loads scenario files of the tests as a user would.

#include <catch2/catch.hpp>

#include "batch/trial.h"
#include "load/load.h"

namespace flyrock {

/// The scenario in a file, given relative to the project's folder. If it has errors, the test ends with its
/// messages.
inline LoadedScenario loaded(const std::string& file, const Overrides& overrides = {}) {
  Diagnostics diagnostics;
  std::optional<LoadedScenario> scenario =
      load_scenario(FLYROCK_SOURCE_DIR "/" + file, overrides, diagnostics);
  INFO(diagnostics.to_text());
  REQUIRE(scenario);
  return std::move(*scenario);
}

/// The records of trial 0.
inline TrialRecords first_trial(const LoadedScenario& scenario) {
  TrialRunner runner(scenario.plan.points.front());
  TrialRecords records;
  runner.run(0, records);
  return records;
}

}  // namespace flyrock
