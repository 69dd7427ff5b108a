#include "cli/runners.h"

#include <fmt/format.h>

#include "batch/safe_file.h"
#include "cli/terminal.h"
#include "solver/hdf5_file.h"

namespace flyrock::cli {

namespace {

RunTrial trial_of(Runners& runners) {
  return [&runners](int point, std::uint64_t trial, TrialRecords& out) {
    runners[static_cast<std::size_t>(point)]->run(trial, out);
  };
}

/// A scenario read again, and its runners.
struct Reading {
  std::optional<LoadedScenario> scenario;
  Runners runners;
};

}  // namespace

Runners make_runners(const LoadedScenario& scenario, const std::filesystem::path& hard_problems) {
  Runners runners;
  for (const Scenario& point : scenario.plan.points) {
    if (!hard_problems.empty() && point.output.hard_problems && !has_hdf5())
      throw PluginError("output.hard_problems needs a flyrock that was built with HDF5 (Debian: libhdf5-dev)");
    runners.push_back(std::make_unique<TrialRunner>(point));
    runners.back()->stop_when(was_interrupted);
    if (!hard_problems.empty())
      runners.back()->keep_hard_problems(hard_problems / fmt::format("point-{}", runners.size() - 1));
  }
  return runners;
}

MakeWorker workers(const LoadedScenario& scenario, Runners& runners, const std::string& path,
                   const Overrides& overrides, const std::filesystem::path& hard_problems) {
  return [&, path, overrides, hard_problems](int thread) -> RunTrial {
    if (thread == 0) return trial_of(runners);
    const auto reading = std::make_shared<Reading>();
    Diagnostics diagnostics;
    reading->scenario = load_scenario(path, overrides, diagnostics);
    if (!reading->scenario || reading->scenario->hash != scenario.hash)
      throw FileError(fmt::format("{}, or a file that it names, was changed while the run started", path));
    reading->runners = make_runners(*reading->scenario, hard_problems);
    return [reading, run = trial_of(reading->runners)](int point, std::uint64_t trial, TrialRecords& out) {
      run(point, trial, out);
    };
  };
}

std::vector<Profile> first_terrains(Runners& runners) {
  std::vector<Profile> terrains;
  for (const auto& runner : runners) {
    try {
      terrains.push_back(runner->picture_of(0));
    } catch (const PluginError&) {
      terrains.emplace_back();
    }
  }
  return terrains;
}

}  // namespace flyrock::cli
