// Every scenario that is shipped, and the example of every plugin, reads without a fault, runs a few trials,
// and meets its expectations as far as these judge so few.

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "batch/trial.h"
#include "load/load.h"
#include "results/results.h"

using namespace flyrock;

namespace {

std::vector<std::string> scenario_files(const std::string& folder, bool examples) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const auto path = entry.path();
    const bool scenario = path.extension() == ".yaml" || (!examples && path.extension() == ".lua");
    if (scenario && (!examples || path.filename() == "example.yaml")) files.push_back(path.string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

void run_few(const std::string& path) {
  INFO(path);
  setenv("FLYROCK_DATA", FLYROCK_SHARE_DIR, 1);
  Overrides overrides;
  Diagnostics diagnostics;
  auto loaded = load_scenario(path, overrides, diagnostics);
  if (loaded && loaded->own_trials > 3) {
    overrides.trials = 3;
    loaded = load_scenario(path, overrides, diagnostics);
  }
  INFO(diagnostics.to_text());
  REQUIRE(loaded);
  std::vector<Rows> rows;
  RunFacts facts{.trials = {}, .full = loaded->own_trials <= 3, .ended_early = {}, .warnings = {}};
  for (const Scenario& scenario : loaded->plan.points) {
    TrialRecords of_point;
    TrialRunner runner(scenario);
    for (std::uint64_t trial = 0; trial < scenario.trials; ++trial) runner.run(trial, of_point);
    for (const RockRecord& rock : of_point.rocks)
      if (rock.reason != StopReason::left_domain) CHECK(rock.fault == "");
    rows.push_back(rows_of(std::move(of_point)));
    facts.trials.push_back(scenario.trials);
  }
  for (const Verdict& verdict : make_results(loaded->plan, rows, facts).verdicts) {
    INFO(verdict.expectation.measure << " is " << verdict.computed << ", expected "
                                     << verdict.expectation.value << " " << verdict.reason);
    CHECK(verdict.judgement != Judgement::failed);
  }
}

}  // namespace

TEST_CASE("every shipped scenario runs", "[heavy]") {
  for (const std::string& path : scenario_files(FLYROCK_SOURCE_DIR "/scenarios", false)) run_few(path);
}

TEST_CASE("the example of every plugin runs") {
  const auto examples = scenario_files(FLYROCK_SOURCE_DIR "/plugins", true);
  int plugins = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(FLYROCK_SOURCE_DIR "/plugins"))
    plugins += entry.path().filename() == "plugin.lua";
  CHECK(static_cast<int>(examples.size()) == plugins);
  for (const std::string& path : examples) run_few(path);
}
