// Scenes as a user runs them: with no `solver` section. Each says in its `expect` what must hold, and runs
// without a fault.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "batch/trial.h"
#include "load/load.h"
#include "results/results.h"

using namespace flyrock;

namespace {

std::vector<std::string> scenes() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(FLYROCK_SOURCE_DIR "/tests/data/defaults"))
    if (entry.path().filename() != "memory.lua") paths.push_back(entry.path().string());  // a plugin
  std::sort(paths.begin(), paths.end());
  return paths;
}

void run_at_defaults(const std::string& path) {
  INFO(path);
  setenv("FLYROCK_DATA", FLYROCK_SHARE_DIR, 1);
  Diagnostics diagnostics;
  const auto loaded = load_scenario(path, {}, diagnostics);
  INFO(diagnostics.to_text());
  REQUIRE(loaded);
  const Scenario& scenario = loaded->plan.points.front();
  TrialRecords records;
  TrialRunner runner(scenario);
  for (std::uint64_t trial = 0; trial < scenario.trials; ++trial) runner.run(trial, records);
  for (const RockRecord& rock : records.rocks) CHECK(rock.fault == "");
  CHECK(records.totals.quality.not_converged == 0);
  CHECK(records.totals.quality.energy_gains == 0);
  std::vector<Rows> rows;
  rows.push_back(rows_of(std::move(records)));
  const RunFacts facts{.trials = {scenario.trials}, .full = true, .ended_early = {}, .warnings = {}};
  for (const Verdict& verdict : make_results(loaded->plan, rows, facts).verdicts) {
    INFO(verdict.expectation.measure << " is " << verdict.computed << " " << verdict.reason);
    CHECK(verdict.judgement == Judgement::passed);
  }
}

}  // namespace

TEST_CASE("scenes at the default settings meet their expectations", "[slow]") {
  for (const std::string& path : scenes()) run_at_defaults(path);
}
