#pragma once
// What runs the trials of a scenario, for each thread, as the commands do it.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "batch/run.h"
#include "batch/runners.h"

namespace flyrock::cli {

/// Tries a scenario out on up to `trials` trials of each point and makes its runners. Nothing where one
/// fails: why is printed, and warnings are.
std::optional<Runners> try_runners(LoadedScenario& scenario, std::uint64_t trials);

/// Lets an interrupt end trials, and hard problems go to point-<p> of a folder. False where this flyrock
/// cannot store them: why is printed.
bool prepare(Runners& runners, const LoadedScenario& scenario, const std::filesystem::path& hard_problems);

/// The workers of a run. Thread 0 uses `runners`; each other one reads the scenario again, since a Lua state
/// serves one thread at a time. Throws FileError (in the thread) where the files have changed in the
/// meantime.
MakeWorker workers(const LoadedScenario& scenario, Runners& runners, const std::string& path,
                   const Overrides& overrides, const std::filesystem::path& hard_problems);

/// The ground of each point for the report's pictures; where it cannot be built, every rock is a row that
/// says why.
std::vector<Profile> first_terrains(Runners& runners);

}  // namespace flyrock::cli
