#include "batch/run.h"

#include <fmt/format.h>

#include <chrono>

#include "batch/plan_chunks.h"
#include "cli/conclude.h"
#include "cli/loading.h"
#include "cli/result_folder.h"
#include "cli/runners.h"
#include "cli/shard.h"
#include "cli/summary_text.h"
#include "cli/terminal.h"
#include "files/safe_file.h"
#include "load/try_points.h"

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

/// Checks the replayed trial against the plan, and stores its trajectory.
void prepare(const Only& only, Plan& plan) {
  if (only.point >= plan.points.size())
    throw UsageError(fmt::format("--only: point {} does not exist, the scenario has {} (from 0)", only.point,
                                 plan.points.size()));
  Scenario& scenario = plan.points[only.point];
  if (only.trial >= scenario.trials)
    throw UsageError(fmt::format("--only: trial {} does not exist, the scenario has {} (from 0)", only.trial,
                                 scenario.trials));
  scenario.output.trajectories_first =
      std::max(scenario.output.trajectories_first, static_cast<int>(only.trial) + 1);
}

/// A run cannot be divided further than into its chunks.
void warn_of_empty(const Shard& shard, const Plan& plan) {
  if (const std::size_t chunks = plan_chunks(plan).size(); shard.of > chunks)
    tell("warning: --shard {}/{}: the run has only {} chunk{}: {}\n", shard.number, shard.of, chunks,
         chunks == 1 ? "" : "s",
         shard.number > chunks ? "this shard has nothing to do"
                               : fmt::format("the shards above {} have nothing to do", chunks));
}

std::vector<ChunkRange> chunks_of(const Plan& plan, const std::optional<Only>& only,
                                  const std::optional<Shard>& shard) {
  if (only) return {{static_cast<int>(only->point), only->trial, only->trial, 1}};
  const std::vector<ChunkRange> all = plan_chunks(plan);
  if (!shard) return all;
  std::vector<ChunkRange> chunks;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (shard->holds(i)) chunks.push_back(all[i]);
  return chunks;
}

/// What the command line asks for.
struct Job {
  Request request;
  std::optional<Only> only;
  std::optional<Shard> shard;
  bool in_shard_folder = false;  ///< shard-i of the folder
  int threads = 1;
  bool resume = false, force = false, quiet = false, strict = false;
};

struct Execution {
  RunOutcome outcome;
  RunLog log;
};

/// Runs the trials; `writer`, if any, sees them.
Execution execute(const Job& job, const LoadedScenario& loaded, Runners& runners, const ResultFolder& folder,
                  std::optional<ResultWriter>& writer) {
  RunOptions options{.folder = folder.chunks(),
                     .scenario_hash = loaded.hash,
                     .threads = job.threads,
                     .resume = job.resume,
                     .plan = &loaded.plan,
                     .strict = job.strict,
                     .interrupted = was_interrupted};
  const std::vector<ChunkRange> chunks = chunks_of(loaded.plan, job.only, job.shard);
  Execution execution;
  RunLog& log = execution.log = start_log();
  log.threads = std::min(options.threads, static_cast<int>(chunks.size()));
  const auto start = std::chrono::steady_clock::now();
  TrialWatch watch;  // of the first thread
  for (const auto& runner : runners) runner->report_to(watch);
  ProgressBar bar(!job.quiet, trials_in(chunks), &watch);
  options.report = [&](const RunProgress& progress) { bar.show(progress); };
  options.print = [&](const std::vector<std::string>& lines) { bar.write(lines); };
  if (writer) options.see = [&](int point, const TrialRecords& chunk) { writer->add(point, chunk); };
  execution.outcome = run_chunks(
      chunks, workers(loaded, runners, job.request.scenario, job.request.overrides, folder.hard_problems()),
      options);
  const RunProgress& progress = execution.outcome.progress;
  log.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  log.trials = progress.done - progress.kept;
  log.kept = progress.kept;
  log.rocks = progress.rocks;
  log.times = execution.outcome.times;
  log.store_seconds = 1e-9 * static_cast<double>(execution.outcome.store_time) / log.threads;
  log.table_seconds = 1e-9 * static_cast<double>(execution.outcome.see_time) / log.threads;
  return execution;
}

/// Ends the run of a shard: its chunks stay for `flyrock merge`.
int conclude_shard(const RunOutcome& outcome, const Shard& shard, const std::filesystem::path& chunks,
                   bool quiet) {
  if (!outcome.why.empty()) tell("error: the run ended early: {}\n", outcome.why);
  if (!quiet)
    fmt::print("shard {} of {}: {} trials in {}; `flyrock merge` puts the shards together\n", shard.number,
               shard.of, trials_in(outcome.chunks), chunks.string());
  return outcome.why.empty() && outcome.failed == 0 ? done : faults;
}

/// Refuses options that contradict each other.
void refuse_pairs(const CommandLine& line) {
  for (const auto& [a, b] :
       {std::pair("resume", "force"), std::pair("only", "resume"), std::pair("only", "shard")})
    if (line.has(a) && line.has(b)) throw UsageError(fmt::format("expected one of --{} and --{}", a, b));
}

po::options_description run_options() {
  po::options_description options("options");
  options.add_options()("output,o", po::value<std::string>()->value_name("DIR"),
                        "result folder; default out/<scenario name>");
  add_override_options(options);
  options.add_options()("only", po::value<std::string>()->value_name("point=P,trial=T"),
                        "replays one trial and shows its rocks")(
      "jobs,j", po::value<std::string>()->value_name("N"), "threads; default all cores")(
      "shard", po::value<std::string>()->value_name("i/n|auto"),
      "runs shard i of n, for `flyrock merge`; auto: as the cluster's task says, into shard-i of the folder")(
      "resume", "continues a run that was interrupted or killed")(
      "force", "replaces the results in an existing folder")("quiet", "no progress and no summary")(
      "strict",
      "treats unused keys and unusual values as errors, and stops the run at the first rock that fails or "
      "step that does not converge");
  return options;
}

Job read_job(const CommandLine& line) {
  refuse_pairs(line);
  Job job;
  job.request.scenario = line.words[0];
  job.request.overrides = overrides_of(line);
  job.threads = threads_of(line);
  if (line.has("only")) job.only = read_only(line.text("only"));
  if (line.has("shard")) {
    job.in_shard_folder = line.text("shard") == "auto";
    job.shard = job.request.shard = job.in_shard_folder ? shard_of_task() : read_shard(line.text("shard"));
  }
  job.resume = line.has("resume");
  job.force = line.has("force");
  job.quiet = line.has("quiet");
  job.strict = line.has("strict");
  return job;
}

std::string default_folder(const Job& job, const std::string& scenario) {
  std::string name = "out/" + scenario;
  if (job.only) name += fmt::format("-p{}-t{}", job.only->point, job.only->trial);
  if (job.shard && !job.in_shard_folder)
    name += fmt::format("-shard-{}-of-{}", job.shard->number, job.shard->of);
  return name;
}

/// Runs the trials in an open folder and builds the results.
int carry_out(const Job& job, const LoadedScenario& loaded, Runners& runners, const ResultFolder& folder) {
  const Plan& plan = loaded.plan;
  catch_interrupt();
  std::optional<ResultWriter> writer;
  if (!job.shard) writer.emplace(folder.path(), loaded);
  const auto [outcome, log] = execute(job, loaded, runners, folder, writer);
  if (outcome.ending == RunEnding::interrupted) {
    tell_interrupted(trials_in(outcome.chunks), outcome.progress.total, folder.chunks().string());
    return interrupted;
  }
  if (job.shard) return conclude_shard(outcome, *job.shard, folder.chunks(), job.quiet);

  const RunFacts facts{.trials = trials_of(outcome.chunks, plan.points.size()),
                       .full = !job.only && plan.points.front().trials_of_run() >= loaded.own_trials,
                       .ended_early = outcome.why,
                       .warnings = loaded.warnings};
  const std::vector<Rows> rows = rows_in(chunk_files(outcome.chunks, folder.chunks()),
                                         static_cast<int>(plan.points.size()), loaded.hash);
  const Results results = folder.build(*writer, rows, facts, first_terrains(runners), log);
  folder.tidy();
  print_faults(results);
  if (!job.quiet) {
    fmt::print("{}", summary_text(plan, results, loaded.warnings));
    if (job.only)
      fmt::print("{}", trial_text(plan.points[job.only->point], results.points[job.only->point].first_trial));
    fmt::print("report: {}\n", folder.report().string());
  }
  return exit_code(results);
}

}  // namespace

int run(const Command& command, const Arguments& arguments) {
  const CommandLine line = parse(command, run_options(), arguments, 1, 1);
  if (line.help) return done;
  const Job job = read_job(line);
  std::optional<LoadedScenario> loaded = load(job.request.scenario, job.request.overrides, job.strict);
  if (!loaded) return bad_input;
  if (job.only) prepare(*job.only, loaded->plan);
  if (job.shard) warn_of_empty(*job.shard, loaded->plan);
  std::filesystem::path path = line.has("output") ? line.text("output") : default_folder(job, loaded->name);
  if (job.in_shard_folder) path /= fmt::format("shard-{}", job.shard->number);
  ResultFolder folder(path, *loaded,
                      job.resume  ? Existing::continued
                      : job.force ? Existing::replaced
                                  : Existing::refused);
  if (const std::optional<int> code = folder.complete(loaded->plan)) {
    folder.tidy();  // a run that was killed at the very end has left chunks
    if (!job.quiet) fmt::print("nothing to do, all trials are done\nreport: {}\n", folder.report().string());
    return *code;
  }
  std::optional<Runners> runners = try_runners(*loaded, tried_trials);
  if (!runners || !prepare(*runners, *loaded, folder.hard_problems())) return bad_input;
  folder.open(*loaded, job.request);
  try {
    return carry_out(job, *loaded, *runners, folder);
  } catch (const FileError& error) {  // a full disk
    tell("error: {}; what was done is kept in {}, --resume goes on\n", error.what(),
         folder.chunks().string());
    return faults;
  }
}

}  // namespace flyrock::cli
