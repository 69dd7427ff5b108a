#include "batch/run.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <ctime>

#include "batch/trial.h"
#include "cli/loading.h"
#include "cli/result_folder.h"
#include "cli/summary_text.h"
#include "cli/terminal.h"

namespace flyrock::cli {

namespace po = boost::program_options;

namespace {

/// The one trial of --only.
struct Only {
  std::size_t point = 0;
  std::uint64_t trial = 0;
};

/// "point=0,trial=17"
Only read_only(const std::string& text) {
  const std::size_t comma = text.find(',');
  const std::string point = text.substr(0, comma);
  const std::string trial = comma == std::string::npos ? "" : text.substr(comma + 1);
  if (!point.starts_with("point=") || !trial.starts_with("trial="))
    throw UsageError(fmt::format("--only: `{}`, expected point=P,trial=T", text));
  return {whole_number(point.substr(6), "--only point", 0), whole_number(trial.substr(6), "--only trial", 0)};
}

/// Bounds the replay by the plan, and makes its trajectory one that is stored.
void prepare(const Only& only, Plan& plan) {
  if (only.point >= plan.points.size())
    throw UsageError(fmt::format("--only: point {} does not exist, the scenario has {} (from 0)", only.point, plan.points.size()));
  Scenario& scenario = plan.points[only.point];
  if (only.trial >= scenario.trials)
    throw UsageError(fmt::format("--only: trial {} does not exist, the scenario has {} (from 0)", only.trial, scenario.trials));
  scenario.output.trajectories_first = std::max(scenario.output.trajectories_first, static_cast<int>(only.trial) + 1);
}

std::vector<ChunkRange> chunks_of(const Plan& plan, const std::optional<Only>& only) {
  if (only) return {{static_cast<int>(only->point), only->trial, only->trial, 1}};
  return plan_chunks(static_cast<int>(plan.points.size()), plan.points.front().trials);
}

std::vector<std::uint64_t> trials_of(const std::vector<ChunkRange>& chunks, std::size_t points) {
  std::vector<std::uint64_t> trials(points, 0);
  for (const ChunkRange& chunk : chunks) trials[static_cast<std::size_t>(chunk.point)] += chunk.count;
  return trials;
}

std::string host_name() {
  char name[256] = {};
  return ::gethostname(name, sizeof name - 1) == 0 ? name : "unknown";
}

/// One runner a point; constructing them makes the sampled calls of every plugin. Throws PluginError.
using Runners = std::vector<std::unique_ptr<TrialRunner>>;
Runners make_runners(const LoadedScenario& loaded) {
  Runners runners;
  for (const Scenario& point : loaded.plan.points)
    runners.push_back(std::make_unique<TrialRunner>(point));
  return runners;
}

struct Execution {
  RunOutcome outcome;
  RunLog log;
};

Execution execute(const LoadedScenario& loaded, Runners& runners, const std::vector<ChunkRange>& chunks,
                  const std::filesystem::path& folder, bool strict, bool quiet) {
  Execution execution;
  RunLog& log = execution.log;
  log.started = fmt::format("{:%Y-%m-%dT%H:%M:%S%z}", fmt::localtime(std::time(nullptr)));
  log.host = host_name();
  const auto start = std::chrono::steady_clock::now();
  ProgressBar bar(!quiet);
  const RunTrial run_trial = [&](int point, std::uint64_t trial, TrialRecords& out) {
    runners[static_cast<std::size_t>(point)]->run(trial, out);
  };
  execution.outcome = run_chunks(chunks, run_trial,
                                 {.folder = folder,
                                  .scenario_hash = loaded.hash,
                                  .strict = strict,
                                  .interrupted = was_interrupted,
                                  .report = [&](const RunProgress& progress) { bar.show(progress); }});
  log.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  log.trials = execution.outcome.progress.done;
  log.rocks = execution.outcome.progress.rocks;
  log.times = execution.outcome.times;
  return execution;
}

/// The ground for the report's picture; where it cannot be built, every rock is a row that says why.
Profile first_terrain(TrialRunner& runner) {
  try {
    return runner.terrain_of(0)->profile();
  } catch (const PluginError&) {
    return {};
  }
}

void print_faults(const Results& results) {
  for (const Fault& fault : results.faults)
    fmt::print(stderr, "error: point {}, trial {}, rock {}: {}: {}\n", fault.point, fault.trial, fault.rock,
               name_of(fault.reason), fault.text);
  if (results.fault_count > results.faults.size())
    fmt::print(stderr, "error: and {} more rocks that failed\n", results.fault_count - results.faults.size());
  if (!results.ended_early.empty()) fmt::print(stderr, "error: the run ended early: {}\n", results.ended_early);
}

int exit_code(const Results& results) {
  if (!results.ended_early.empty() || results.fault_count > 0) return faults;
  return results.count(Judgement::failed) > 0 ? expectation_failed : done;
}

po::options_description run_options() {
  po::options_description options("options");
  options.add_options()("output,o", po::value<std::string>()->value_name("DIR"),
                        "result folder; default out/<scenario name>");
  add_override_options(options);
  options.add_options()
      ("only", po::value<std::string>()->value_name("point=P,trial=T"), "replays one trial and shows its rocks")
      ("force", "replaces the results in an existing folder")
      ("quiet", "no progress and no summary")
      ("strict", "keys that nothing reads are errors; ends at the first fault or step that did not converge");
  return options;
}

}  // namespace

int run(const Command& command, const Arguments& arguments) {
  const CommandLine line = parse(command, run_options(), arguments, 1, 1);
  if (line.help) return done;
  std::optional<Only> only;
  if (line.has("only")) only = read_only(line.text("only"));
  const bool quiet = line.has("quiet"), strict = line.has("strict");

  std::optional<LoadedScenario> loaded = load(line.words[0], overrides_of(line), strict);
  if (!loaded) return bad_input;
  Plan& plan = loaded->plan;
  if (only) prepare(*only, plan);
  const std::string suffix = only ? fmt::format("-p{}-t{}", only->point, only->trial) : "";
  ResultFolder folder(line.has("output") ? line.text("output") : "out/" + loaded->name + suffix, line.has("force"));
  Runners runners;
  try {
    runners = make_runners(*loaded);
  } catch (const PluginError& error) {
    fmt::print(stderr, "{}: error: {}\n", line.words[0], error.what());
    return bad_input;
  }

  folder.open(*loaded);
  catch_interrupt();
  const auto [outcome, log] = execute(*loaded, runners, chunks_of(plan, only), folder.chunks(), strict, quiet);
  if (outcome.ending == RunEnding::interrupted) {
    fmt::print(stderr, "interrupted after {} of {} trials; what was done is kept in {}\n", outcome.progress.done,
               outcome.progress.total, folder.chunks().string());
    return interrupted;
  }

  const int points = static_cast<int>(plan.points.size());
  const RunFacts facts{.trials = trials_of(outcome.chunks, plan.points.size()),
                       .full = !only && plan.points.front().trials >= loaded->own_trials,
                       .ended_early = outcome.why,
                       .warnings = loaded->warnings};
  Results results = make_results(plan, merge_chunks(outcome.chunks, points, folder.chunks(), loaded->hash), facts);
  for (std::size_t p = 0; p < runners.size(); ++p) results.points[p].terrain = first_terrain(*runners[p]);
  folder.write(*loaded, results, log);
  remove_chunks(outcome.chunks, folder.chunks());
  print_faults(results);
  if (!quiet) {
    fmt::print("{}", summary_text(plan, results, loaded->warnings));
    if (only) fmt::print("{}", trial_text(plan.points[only->point], results.points[only->point].records));
    fmt::print("report: {}\n", folder.report().string());
  }
  return exit_code(results);
}

}  // namespace flyrock::cli
