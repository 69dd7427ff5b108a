#pragma once
// Makes the runners of a scenario's trials for each thread, for the commands.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "batch/run.h"
#include "batch/runners.h"

namespace flyrock::cli {

/// Tries out up to `trials` trials of each point and makes the runners. Prints warnings. If a runner fails,
/// prints why and returns nothing.
std::optional<Runners> try_runners(LoadedScenario& scenario, std::uint64_t trials);

/// Lets Ctrl-C end trials, and stores hard problems in point-<p> of a folder. If this flyrock cannot store
/// them, prints why and returns false.
bool prepare(Runners& runners, const LoadedScenario& scenario, const std::filesystem::path& hard_problems);

/// The workers of a run. Thread 0 uses `runners`. Every other thread reads the scenario again, because a Lua
/// state serves only one thread at a time. Throws FileError (in the thread) if the files have changed
/// meanwhile.
MakeWorker workers(const LoadedScenario& scenario, Runners& runners, const std::string& path,
                   const Overrides& overrides, const std::filesystem::path& hard_problems);

/// The ground of each point, for the pictures of the report. If it cannot be built, every rock is a row that
/// says why.
std::vector<TerrainPicture> first_terrains(Runners& runners);

}  // namespace flyrock::cli
