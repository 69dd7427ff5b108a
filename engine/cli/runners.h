#pragma once
// What runs the trials of a scenario, for each thread.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "batch/load.h"
#include "batch/run.h"
#include "batch/trial.h"

namespace flyrock::cli {

/// One a point; constructing them makes the sampled calls of every plugin.
using Runners = std::vector<std::unique_ptr<TrialRunner>>;
/// Hard problems go to point-<p> of a folder, if one is named. Throws PluginError: bad input.
Runners make_runners(const LoadedScenario& scenario, const std::filesystem::path& hard_problems = {});

/// The workers of a run. Thread 0 uses `runners`; each other one reads the scenario again, since a Lua state serves
/// one thread at a time. Throws FileError (in the thread) where the files have changed in the meantime.
MakeWorker workers(const LoadedScenario& scenario, Runners& runners, const std::string& path,
                   const Overrides& overrides, const std::filesystem::path& hard_problems);

/// The ground of each point for the report's pictures; where it cannot be built, every rock is a row that says why.
std::vector<Profile> first_terrains(Runners& runners);

}  // namespace flyrock::cli
