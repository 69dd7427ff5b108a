// Shipped scenarios with closed-form expectations, run as rows of the suite.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "batch/trial.h"
#include "load/load.h"
#include "results/results.h"
#include "verify/check.h"

namespace flyrock {

namespace {

std::string bound_text(ExpectKind kind) {
  switch (kind) {
    case ExpectKind::equals:
      return "";
    case ExpectKind::below:
      return " below";
    case ExpectKind::above:
      return " above";
    case ExpectKind::between:
      break;
  }
  return " at least";
}

/// Runs a scenario in memory. Its expectations become checks.
void check_scenario(Checks& checks, const std::string& path, const std::string& name) {
  Diagnostics diagnostics;
  const auto loaded = load_scenario(path, {}, diagnostics);
  if (!loaded) throw std::runtime_error(diagnostics.to_text());
  std::vector<Rows> rows;
  RunFacts facts;
  for (const Scenario& point : loaded->plan.points) {
    TrialRunner runner(point);
    TrialRecords records;
    for (std::uint64_t trial = 0; trial < point.trials; ++trial) runner.run(trial, records);
    rows.push_back(rows_of(std::move(records)));
    facts.trials.push_back(point.trials);
  }
  for (const Verdict& verdict : make_results(loaded->plan, rows, facts).verdicts) {
    const Expectation& expectation = verdict.expectation;
    std::string row = fmt::format("{}: {}{}", name, compared_text(expectation), bound_text(expectation.kind));
    if (loaded->plan.points.size() > 1 && !expectation.order) row += fmt::format(", point {}", verdict.point);
    checks.push_back({row, "run", verdict.computed, expectation.value, verdict.tolerance,
                      verdict.judgement == Judgement::passed});
  }
}

}  // namespace

void check_scenarios(Checks& checks, const std::string& share) {
  namespace fs = std::filesystem;
  std::vector<std::pair<std::string, std::string>> files;  // name, path
  for (const auto& entry : fs::directory_iterator(fs::path(share) / "scenarios" / "course"))
    files.emplace_back("course/" + entry.path().stem().string(), entry.path().string());
  for (const char* kind : {"restitution", "friction", "rolling", "unilateral"})
    for (const auto& entry : fs::directory_iterator(fs::path(share) / "plugins" / kind))
      files.emplace_back(std::string(kind) + '/' + entry.path().filename().string(),
                         (entry.path() / "example.yaml").string());
  std::sort(files.begin(), files.end());
  for (const auto& [name, path] : files) check_scenario(checks, path, name);
}

}  // namespace flyrock
