#include "cli/runners.h"

#include <fmt/format.h>

#include "cli/terminal.h"
#include "document/node.h"
#include "files/safe_file.h"
#include "solver/hdf5_file.h"

namespace flyrock::cli {

namespace {

/// From here on, output of Lua's `print` is returned with its trial.
RunTrial trial_of(Runners& runners, LuaSession& session) {
  session.collect_prints();
  return [&](int point, std::uint64_t trial, TrialRecords& out) {
    runners[static_cast<std::size_t>(point)]->run(trial, out);
    return session.take_prints();
  };
}

/// A scenario that a thread has read again, and its runners.
struct Reading {
  std::optional<LoadedScenario> scenario;
  Runners runners;
};

}  // namespace

std::optional<Runners> try_runners(LoadedScenario& scenario, std::uint64_t trials) {
  Diagnostics diagnostics;
  Runners runners = flyrock::try_runners(scenario, trials, diagnostics);
  tell("{}", diagnostics.to_text());
  return diagnostics.has_errors() ? std::nullopt : std::optional(std::move(runners));
}

bool prepare(Runners& runners, const LoadedScenario& scenario, const std::filesystem::path& hard_problems) {
  for (std::size_t p = 0; p < runners.size(); ++p) {
    if (scenario.plan.points[p].output.hard_problems && !has_hdf5()) {
      Diagnostics diagnostics;
      const Node key = node_at(scenario.root, "output.hard_problems");
      key.error(diagnostics, "needs a flyrock that was built with HDF5 (Debian: libhdf5-dev)");
      tell("{}", diagnostics.to_text());
      return false;
    }
    runners[p]->stop_when(was_interrupted);
    runners[p]->keep_hard_problems(hard_problems / fmt::format("point-{}", p));
  }
  return true;
}

MakeWorker workers(const LoadedScenario& scenario, Runners& runners, const std::string& path,
                   const Overrides& overrides, const std::filesystem::path& hard_problems) {
  return [&, path, overrides, hard_problems](int thread) -> RunTrial {
    if (thread == 0) return trial_of(runners, *scenario.session);
    const auto reading = std::make_shared<Reading>();
    Diagnostics diagnostics;
    // The scenario is another one for each thread, because Lua states are; their grounds are the same. Thread
    // 0 has already shown its prints.
    reading->scenario = load_scenario(path, overrides, diagnostics, Prints::collected, &scenario);
    if (!reading->scenario || reading->scenario->hash != scenario.hash)
      throw FileError(fmt::format("{}, or a file that it names, was changed while the run started", path));
    reading->runners = make_runners(reading->scenario->plan);
    prepare(reading->runners, *reading->scenario, hard_problems);
    return [reading, run = trial_of(reading->runners, *reading->scenario->session)](
               int point, std::uint64_t trial, TrialRecords& out) { return run(point, trial, out); };
  };
}

std::vector<TerrainPicture> first_terrains(Runners& runners) {
  std::vector<TerrainPicture> terrains;
  for (const auto& runner : runners) {
    try {
      terrains.push_back(runner->picture_of(0));
    } catch (const TrialError&) {
      terrains.emplace_back();
    }
  }
  return terrains;
}

}  // namespace flyrock::cli
