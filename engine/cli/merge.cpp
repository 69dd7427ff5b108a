// Puts shards together: their chunks, in order, become the tables of one run.

#include <fmt/format.h>

#include <filesystem>

#include "batch/safe_file.h"
#include "cli/conclude.h"
#include "cli/loading.h"
#include "cli/result_folder.h"
#include "cli/runners.h"
#include "cli/summary_text.h"

namespace flyrock::cli {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

/// The hash of the scenario that all of the shards are of.
std::string common_hash(const std::vector<std::string>& shards) {
  std::string common;
  for (const std::string& shard : shards) {
    const std::string hash = scenario_hash_in(shard);
    if (hash.empty()) throw UsageError(fmt::format("{} is no result folder: it has no manifest.json", shard));
    if (!fs::is_directory(fs::path(shard) / "chunks"))
      throw UsageError(fmt::format("{} has no chunks: it is no shard, its results stand", shard));
    if (!common.empty() && hash != common)
      throw UsageError(fmt::format("{} and {} are of different scenarios, seeds, numbers of trials or versions of flyrock",
                                   shards.front(), shard));
    common = hash;
  }
  return common;
}

/// The chunks of a plan that the shards hold, in order.
std::vector<ChunkFile> find_chunks(const std::vector<ChunkRange>& chunks, const std::vector<std::string>& shards) {
  std::vector<std::shared_ptr<const fs::path>> folders;
  for (const std::string& shard : shards) folders.push_back(std::make_shared<const fs::path>(fs::path(shard) / "chunks"));
  std::vector<ChunkFile> files;
  for (const ChunkRange& chunk : chunks) {
    const std::string* holder = nullptr;
    for (std::size_t s = 0; s < shards.size(); ++s) {
      const ChunkFile file{chunk, folders[s]};
      if (!fs::exists(file.path())) continue;
      if (holder) throw UsageError(fmt::format("{} and {} both hold {}: a shard given twice", *holder, shards[s], chunk.file_name()));
      holder = &shards[s];
      files.push_back(file);
    }
  }
  return files;
}

/// Reads every chunk once before anything is written. Throws InputError.
void check_whole(const std::vector<ChunkFile>& files, const std::string& hash) {
  for (const ChunkFile& file : files) {
    std::string why;
    if (!read_chunk(file.path(), file.range, hash, Part::whole, why))
      throw InputError(fmt::format("{} is not what a run wrote: {}; run its shard again with --resume", file.path().string(), why));
  }
}

/// "12 of 300 chunks are missing, from trial 40 of point 0 on", or nothing.
std::string missing_text(const std::vector<ChunkRange>& chunks, const std::vector<ChunkFile>& files) {
  if (files.size() == chunks.size()) return {};
  std::size_t first = 0;
  while (first < files.size() && files[first].range == chunks[first]) ++first;
  return fmt::format("{} of {} chunks are missing, from trial {} of point {} on", chunks.size() - files.size(),
                     chunks.size(), chunks[first].first, chunks[first].point);
}

std::optional<LoadedScenario> load_again(const CommandLine& line, const std::string& hash, Request& request) {
  const std::string& shard = line.words.front();
  request = read_request(fs::path(shard) / "chunks");
  if (line.has("scenario")) request.scenario = line.text("scenario");
  else if (!fs::exists(request.scenario))
    throw UsageError(fmt::format("the scenario of {}, {}, is not here; name it with --scenario FILE", shard, request.scenario));
  std::optional<LoadedScenario> loaded = load(request.scenario, request.overrides, false);
  if (loaded && loaded->hash != hash)
    throw UsageError(fmt::format("{}, its plugins or flyrock have changed since {} was run", request.scenario, shard));
  return loaded;
}

po::options_description merge_options() {
  po::options_description options("options");
  options.add_options()
      ("output,o", po::value<std::string>()->value_name("DIR"), "result folder; required")
      ("scenario", po::value<std::string>()->value_name("FILE"), "the scenario, where it is not where the shards found it")
      ("force", "replaces the results in an existing folder")
      ("quiet", "no summary");
  return options;
}

}  // namespace

int merge(const Command& command, const Arguments& arguments) {
  const CommandLine line = parse(command, merge_options(), arguments, 1, 100'000);
  if (line.help) return done;
  if (!line.has("output")) throw UsageError("expected -o DIR, the folder of the merged result");
  const std::vector<std::string>& shards = line.words;
  for (const std::string& shard : shards)
    if (fs::weakly_canonical(shard) == fs::weakly_canonical(line.text("output")))
      throw UsageError(fmt::format("{} is a shard: the merged result needs a folder of its own", shard));

  const std::string hash = common_hash(shards);
  Request request;
  const std::optional<LoadedScenario> loaded = load_again(line, hash, request);
  if (!loaded) return bad_input;
  const Plan& plan = loaded->plan;
  const std::vector<ChunkRange> chunks =
      plan_chunks(static_cast<int>(plan.points.size()), plan.points.front().trials);
  const std::vector<ChunkFile> files = find_chunks(chunks, shards);
  std::vector<ChunkRange> found;
  for (const ChunkFile& file : files) found.push_back(file.range);

  check_whole(files, hash);

  ResultFolder folder(line.text("output"), *loaded, line.has("force") ? Existing::replaced : Existing::refused);
  Runners runners = make_runners(*loaded);
  folder.open(*loaded, request);
  const RunFacts facts{.trials = trials_of(found, plan.points.size()),
                       .full = plan.points.front().trials >= loaded->own_trials,
                       .ended_early = missing_text(chunks, files),
                       .warnings = loaded->warnings};
  RunLog log = start_log();
  log.kept = trials_in(found);
  const std::vector<Rows> rows = rows_in(files, static_cast<int>(plan.points.size()), hash);
  ResultWriter writer(folder.path(), *loaded);
  for (std::size_t p = 0; p < rows.size(); ++p)
    rows[p](Part::whole, [&](const TrialRecords& chunk) { writer.see(static_cast<int>(p), chunk); });
  const Results results = folder.build(writer, rows, facts, first_terrains(runners), log);
  folder.tidy();
  print_faults(results);
  if (!line.has("quiet"))
    fmt::print("{}report: {}\n", summary_text(plan, results, loaded->warnings), folder.report().string());
  if (!results.ended_early.empty() && results.fault_count == 0) return done;  // some shards are enough, and it was said
  return exit_code(results);
}

}  // namespace flyrock::cli
