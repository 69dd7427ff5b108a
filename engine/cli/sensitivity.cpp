// flyrock sensitivity: which inputs explain the variance of a number of the trials.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/analysis.h"
#include "cli/conclude.h"
#include "cli/loading.h"
#include "cli/result_folder.h"
#include "cli/runners.h"
#include "cli/shard.h"
#include "cli/terminal.h"
#include "files/safe_file.h"

namespace flyrock::cli {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

struct SensitivityJob {
  Request request;
  std::optional<Shard> shard;
  bool in_shard_folder = false;  ///< shard-i of the folder
  int threads = 1;
  bool resume = false, force = false, quiet = false;
};

po::options_description sensitivity_options() {
  po::options_description options("options");
  options.add_options()("output,o", po::value<std::string>()->value_name("DIR"),
                        "folder of the results; default out/<scenario name>-sensitivity")(
      "of", po::value<std::vector<std::string>>()->value_name("MEASURE"),
      "a number of a trial that is explained, once or several times: "
      "rocks.NAME.QUANTITY.mean|max|p95|beyond[300 m], "
      "gate.NAME.per_trial, barrier.NAME.OUTCOME.per_trial, exposure.NAME.per_blast; default the greatest "
      "runout of "
      "each group")("inputs", po::value<std::string>()->value_name("STREAM,..."),
                    "the inputs; default each number that is drawn and read. All others are one input")(
      "group", po::value<std::vector<std::string>>()->value_name("NAME=STREAM,..."),
      "several streams as one input, for inputs that depend on each other")(
      "line", po::value<std::string>()->value_name("VALUE"),
      "from which value of each input on the mean of the first MEASURE is below or above VALUE")(
      "number,n", po::value<std::string>()->value_name("N"),
      "trials of each base; default the trials of the scenario. A run takes (inputs + 2) N trials");
  add_override_options(options);
  options.add_options()("jobs,j", po::value<std::string>()->value_name("N"), "threads; default all cores")(
      "shard", po::value<std::string>()->value_name("i/n|auto"),
      "runs shard i of n, for `flyrock merge`; auto: as the cluster's task says, into shard-i of the folder")(
      "resume", "continues a run that was interrupted or killed")(
      "force", "replaces the results in an existing folder")("quiet", "no progress and no summary");
  return options;
}

SensitivityJob read_sensitivity_job(const CommandLine& line) {
  SensitivityJob job;
  if (line.has("resume") && line.has("force")) throw UsageError("expected one of --resume and --force");
  job.request.scenario = line.words[0];
  job.request.overrides = overrides_of(line);
  if (line.has("number")) {
    if (job.request.overrides.trials) throw UsageError("expected one of -n and --trials");
    job.request.overrides.trials = whole_number(line.text("number"), "-n", 2);
  }
  AnalysisRequest words;
  if (line.has("of")) words.of = line.options["of"].as<std::vector<std::string>>();
  if (line.has("inputs")) words.inputs = line.text("inputs");
  if (line.has("group")) words.groups = line.options["group"].as<std::vector<std::string>>();
  if (line.has("line")) words.line = line.text("line");
  job.request.analysis = words;
  if (line.has("shard")) {
    job.in_shard_folder = line.text("shard") == "auto";
    job.shard = job.request.shard = job.in_shard_folder ? shard_of_task() : read_shard(line.text("shard"));
  }
  job.threads = threads_of(line);
  job.resume = line.has("resume");
  job.force = line.has("force");
  job.quiet = line.has("quiet");
  return job;
}

fs::path folder_of(const CommandLine& line, const SensitivityJob& job, const std::string& scenario) {
  if (line.has("output") && line.text("output").empty()) throw UsageError("--output: expected a folder");
  fs::path path = line.has("output") ? line.text("output") : fmt::format("out/{}-sensitivity", scenario);
  if (job.in_shard_folder) path /= fmt::format("shard-{}", job.shard->number);
  return path;
}

std::vector<ChunkRange> own_chunks(const Analysis& analysis, const std::optional<Shard>& shard) {
  std::vector<ChunkRange> chunks;
  for (std::size_t i = 0; i < analysis.chunks.size(); ++i)
    if (!shard || shard->holds(i)) chunks.push_back(analysis.chunks[i]);
  return chunks;
}

int carry_out_sensitivity(const SensitivityJob& job, LoadedScenario& loaded, const Analysis& analysis,
                          const ResultFolder& folder) {
  catch_interrupt();
  const std::vector<ChunkRange> chunks = own_chunks(analysis, job.shard);
  RunOptions options{.folder = folder.chunks(),
                     .scenario_hash = loaded.hash,
                     .threads = job.threads,
                     .resume = job.resume,
                     .interrupted = was_interrupted};
  ProgressBar bar(!job.quiet, trials_in(chunks));
  options.report = [&](const RunProgress& progress) { bar.show(progress); };
  options.print = [&](const std::vector<std::string>& lines) { bar.write(lines); };
  const RunOutcome outcome = run_chunks(chunks, analysis_workers(loaded, analysis, job.request), options);
  if (outcome.ending == RunEnding::interrupted) {
    tell_interrupted(trials_in(outcome.chunks), outcome.progress.total, folder.chunks().string());
    return interrupted;
  }
  if (!outcome.why.empty()) {
    tell("error: the run ended early: {}\n", outcome.why);
    return faults;
  }
  if (job.shard) {
    if (!job.quiet)
      fmt::print("shard {} of {}: {} trials in {}; `flyrock merge` puts the shards together\n",
                 job.shard->number, job.shard->of, trials_in(outcome.chunks), folder.chunks().string());
    return outcome.failed == 0 ? done : faults;
  }
  const ExplainedVariance found = explain(loaded, analysis, chunk_files(outcome.chunks, folder.chunks()));
  write_analysis(found, folder.path(), job.quiet);
  folder.tidy();
  return exit_code(found);
}

}  // namespace

int sensitivity(const Command& command, const Arguments& arguments) {
  const CommandLine line = parse(command, sensitivity_options(), arguments, 1, 1);
  if (line.help) return done;
  SensitivityJob job = read_sensitivity_job(line);
  std::optional<LoadedScenario> loaded = load(job.request.scenario, job.request.overrides, false);
  if (!loaded) return bad_input;
  if (!try_runners(*loaded, tried_of_analysis)) return bad_input;
  const Analysis analysis = make_analysis(*loaded, *job.request.analysis);
  refuse_few_rocks(*loaded, analysis);
  job.request.analysis->runs = static_cast<int>(analysis.tables.size());
  ResultFolder folder(folder_of(line, job, loaded->name), *loaded,
                      job.resume  ? Existing::continued
                      : job.force ? Existing::replaced
                                  : Existing::refused);
  if (!job.quiet)
    fmt::print("{} inputs: {} trials, {} at each of {} runs\n", analysis.inputs.inputs.size(),
               analysis.trials * analysis.tables.size(), analysis.trials, analysis.tables.size());
  folder.open(*loaded, job.request);
  for (const char* name : {analysis_file, analysis_page}) fs::remove(folder.path() / name);
  try {
    return carry_out_sensitivity(job, *loaded, analysis, folder);
  } catch (const FileError& error) {  // a full disk
    tell("error: {}; what was done is kept in {}, --resume goes on\n", error.what(),
         folder.chunks().string());
    return faults;
  }
}

}  // namespace flyrock::cli
