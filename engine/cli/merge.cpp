// Merges shards: their chunks, in order, become the tables of one run.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <set>

#include "batch/plan_chunks.h"
#include "batch/record_check.h"
#include "cli/analysis.h"
#include "cli/conclude.h"
#include "cli/loading.h"
#include "cli/result_folder.h"
#include "cli/runners.h"
#include "cli/shard_command.h"
#include "cli/summary_text.h"
#include "cli/terminal.h"
#include "files/safe_file.h"
#include "load/try_points.h"

namespace flyrock::cli {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

/// The scenario hash that all shards have in common.
std::string common_hash(const std::vector<std::string>& shards) {
  std::string common;
  for (const std::string& shard : shards) {
    const std::string hash = scenario_hash_in(shard);
    if (hash.empty())
      throw UsageError(
          fmt::format("{} is not a result folder: it has no manifest.json, or a damaged one", shard));
    if (!fs::is_directory(fs::path(shard) / "chunks"))
      throw UsageError(fmt::format("{} has no chunks: it is not a shard but a finished result", shard));
    if (!common.empty() && hash != common)
      throw UsageError(
          fmt::format("{} and {} are of different scenarios, seeds, numbers of trials or versions of flyrock",
                      shards.front(), shard));
    common = hash;
  }
  return common;
}

/// A folder to merge: its part of the chunks, and how many of them are missing.
struct Piece {
  std::string name;
  std::shared_ptr<const fs::path> chunks;  ///< folder
  Shard shard;
  std::size_t wanted = 0, lost = 0;
};

std::vector<Piece> pieces_of(const std::vector<std::string>& shards) {
  std::vector<Piece> pieces;
  for (const std::string& shard : shards) {
    const fs::path chunks = fs::path(shard) / "chunks";
    pieces.push_back({shard, std::make_shared<const fs::path>(chunks), read_request(chunks).shard});
  }
  return pieces;
}

/// The chunks of a plan that the pieces hold, in order. Counts the missing chunks of each piece.
std::vector<ChunkFile> find_chunks(const std::vector<ChunkRange>& chunks, std::vector<Piece>& pieces) {
  std::vector<ChunkFile> files;
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    const Piece* holder = nullptr;
    for (Piece& piece : pieces) {
      const ChunkFile file{chunks[c], piece.chunks};
      const bool wanted = piece.shard.holds(c), found = fs::exists(file.path());
      piece.wanted += wanted;
      piece.lost += wanted && !found;
      if (!found) continue;
      if (holder)
        throw UsageError(fmt::format("{} and {} both hold {}: a shard given twice", holder->name, piece.name,
                                     chunks[c].file_name()));
      if (!wanted)
        throw InputError(fmt::format(
            "{} holds {}, which is not a chunk of shard {} of {}: it, or its request.json, is not "
            "what a run wrote",
            piece.name, chunks[c].file_name(), piece.shard.number, piece.shard.of));
      holder = &piece;
      files.push_back(file);
    }
  }
  return files;
}

/// The shards of which no folder is given. The folders may be shards of different numbers of shards: the
/// missing ones are then counted by the least common multiple, in which each belongs to a folder as a whole
/// or not at all. In a count above the number of chunks that is so too, because a shard has at most one.
std::vector<Shard> missing_shards(const std::vector<ChunkRange>& chunks, const std::vector<Piece>& pieces) {
  std::uint64_t of = 1;
  for (const Piece& piece : pieces)
    if (of <= chunks.size())
      of = piece.shard.of > chunks.size() ? piece.shard.of : std::lcm(of, piece.shard.of);
  std::set<std::uint64_t> numbers;
  for (std::size_t c = 0; c < chunks.size(); ++c)
    if (std::none_of(pieces.begin(), pieces.end(), [&](const Piece& p) { return p.shard.holds(c); }))
      numbers.insert(c % of + 1);
  std::vector<Shard> missing;
  for (const std::uint64_t number : numbers) missing.push_back({number, of});
  return missing;
}

/// Says which shards and chunks are missing, each with the command that computes them.
void tell_missing(const std::vector<ChunkRange>& chunks, const std::vector<Piece>& pieces,
                  const Request& request, const char* grade) {
  constexpr std::size_t most_told = 20;
  std::vector<std::string> lines;
  for (const Piece& piece : pieces)
    if (piece.lost > 0)
      lines.push_back(fmt::format("{} lacks {} of its {} chunks: {} --resume -o {}", piece.name, piece.lost,
                                  piece.wanted, command_of(request, piece.shard), shell_word(piece.name)));
  for (const Shard& shard : missing_shards(chunks, pieces))
    lines.push_back(
        fmt::format("shard {} of {} is missing: {}", shard.number, shard.of, command_of(request, shard)));
  for (std::size_t i = 0; i < std::min(lines.size(), most_told); ++i) tell("{}: {}\n", grade, lines[i]);
  if (lines.size() > most_told) tell("{}: and {} more\n", grade, lines.size() - most_told);
}

/// Reads every chunk once before anything is written. Throws InputError.
void check_whole(const std::vector<ChunkFile>& files, const LoadedScenario& scenario) {
  // All runs of a sensitivity analysis have the scenario of the only point.
  const auto scenario_of = [&](int point) -> const Scenario& {
    const std::vector<Scenario>& points = scenario.plan.points;
    return points[std::min(static_cast<std::size_t>(point), points.size() - 1)];
  };
  for (const ChunkFile& file : files) {
    std::string why;
    const std::optional<TrialRecords> records =
        read_chunk(file.path(), file.range, scenario.hash, Part::whole, why);
    if (records) why = records_fault(*records, file.range, scenario_of(file.range.point));
    if (!why.empty())
      throw InputError(fmt::format("{} is not what a run wrote: {}; run its shard again with --resume",
                                   file.path().string(), why));
  }
}

/// "12 of 300 chunks are missing, from trial 40 of point 0 on"; empty if none is missing.
std::string missing_text(const std::vector<ChunkRange>& chunks, const std::vector<ChunkFile>& files) {
  if (files.size() == chunks.size()) return {};
  std::size_t first = 0;
  while (first < files.size() && files[first].range == chunks[first]) ++first;
  return fmt::format("{} of {} chunks are missing, from trial {} of point {} on",
                     chunks.size() - files.size(), chunks.size(), chunks[first].first, chunks[first].point);
}

/// Loads the scenario of shards, and what shards of `flyrock sensitivity` were asked.
std::optional<LoadedScenario> load_again(const CommandLine& line, const std::string& hash, Request& request,
                                         std::optional<Analysis>& analysis) {
  const std::string& shard = line.words.front();
  request = read_request(fs::path(shard) / "chunks");
  request.shard = {};
  if (line.has("scenario"))
    request.scenario = line.text("scenario");
  else if (!fs::exists(request.scenario))
    throw UsageError(fmt::format("the scenario of {}, {}, is not here; name it with --scenario FILE", shard,
                                 request.scenario));
  std::optional<LoadedScenario> loaded = load(request.scenario, request.overrides, false);
  if (loaded && request.analysis) analysis = make_analysis(*loaded, *request.analysis);
  if (loaded && loaded->hash != hash)
    throw UsageError(
        fmt::format("{}, its plugins or flyrock have changed since {} was run", request.scenario, shard));
  return loaded;
}

po::options_description merge_options() {
  po::options_description options("options");
  options.add_options()("output,o", po::value<std::string>()->value_name("DIR"), "result folder; required")(
      "scenario", po::value<std::string>()->value_name("FILE"),
      "the scenario file, if it has moved since the shards ran")(
      "partial", "accept missing shards and chunks: the exit code is then 0, not 3")(
      "force", "replaces the results in an existing folder")("quiet", "no summary");
  return options;
}

}  // namespace

int merge(const Command& command, const Arguments& arguments) {
  const CommandLine line = parse(command, merge_options(), arguments, 1, 100'000);
  if (line.help) return done;
  if (!line.has("output")) throw UsageError("expected -o DIR, the folder of the merged result");
  const std::vector<std::string>& shards = line.words;
  std::error_code
      no_path;  // for example of a name that is too long; it is reported below as not a result folder
  const fs::path output = fs::weakly_canonical(line.text("output"), no_path);
  for (const std::string& shard : shards)
    if (fs::weakly_canonical(shard, no_path) == output && !no_path)
      throw UsageError(fmt::format("{} is a shard: the merged result needs a folder of its own", shard));

  const std::string hash = common_hash(shards);
  Request request;
  std::optional<Analysis> analysis;
  std::optional<LoadedScenario> loaded = load_again(line, hash, request, analysis);
  if (!loaded) return bad_input;
  const Plan& plan = loaded->plan;
  const std::vector<ChunkRange> chunks = analysis ? analysis->chunks : plan_chunks(plan);
  std::vector<Piece> pieces = pieces_of(shards);
  const std::vector<ChunkFile> files = find_chunks(chunks, pieces);
  std::vector<ChunkRange> found;
  for (const ChunkFile& file : files) found.push_back(file.range);

  check_whole(files, *loaded);

  ResultFolder folder(line.text("output"), *loaded,
                      line.has("force") ? Existing::replaced : Existing::refused);
  if (analysis) {
    if (files.size() != chunks.size()) {
      tell_missing(chunks, pieces, request, "error");
      tell("error: a sensitivity analysis needs all of its chunks\n");
      return faults;
    }
    const ExplainedVariance explained = explain(*loaded, *analysis, files);
    folder.open(*loaded, request);
    write_analysis(explained, folder.path(), line.has("quiet"));
    folder.tidy();
    return exit_code(explained);
  }
  std::optional<Runners> runners = try_runners(*loaded, tried_trials);
  if (!runners) return bad_input;
  folder.open(*loaded, request);
  const RunFacts facts{.trials = trials_of(found, plan.points.size()),
                       .full = plan.points.front().trials_of_run() >= loaded->own_trials,
                       .ended_early = missing_text(chunks, files),
                       .warnings = loaded->warnings};
  RunLog log = start_log();
  log.kept = trials_in(found);
  const std::vector<Rows> rows = rows_in(files, static_cast<int>(plan.points.size()), hash);
  ResultWriter writer(folder.path(), *loaded);
  for (std::size_t p = 0; p < rows.size(); ++p)
    rows[p](Part::whole, [&](const TrialRecords& chunk) { writer.add(static_cast<int>(p), chunk); });
  const Results results = folder.build(writer, rows, facts, first_terrains(*runners), log);
  folder.tidy();
  const bool partial = line.has("partial");
  print_faults(results, partial ? "warning: the result is not complete" : "error: the run ended early");
  if (!line.has("quiet"))
    fmt::print("{}report: {}\n", summary_text(plan, results, loaded->warnings), folder.report().string());
  tell_missing(chunks, pieces, request, partial ? "warning" : "error");
  // No expectation is judged from only some of the trials.
  if (partial && !results.ended_early.empty() && results.fault_count == 0) return done;
  return exit_code(results);
}

}  // namespace flyrock::cli
