#include "cli/shard_news.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

#include "batch/chunk.h"
#include "cli/command.h"
#include "files/folder_lock.h"
#include "files/safe_file.h"

namespace flyrock::cli {

namespace fs = std::filesystem;

namespace {

/// What the manifest of a shard says of its run.
struct Extent {
  std::string hash;
  int points = 1;
  std::uint64_t trials = 1, runs = 1, chunk_size = 1;

  bool operator==(const Extent&) const = default;
};

/// Greater numbers are not what a run writes, and would only fill the memory.
constexpr double most_points = 1e4, most_of_trials = 1e9, most_chunks = 1e7, most_shards = 1e6;

/// A whole number of at least 1.
std::uint64_t count_in(const nlohmann::json& data, const char* key, double most) {
  const double number = data.at(key).get<double>();
  if (!(number >= 1 && number <= most && number == std::floor(number)))
    throw UnreadableFile(fmt::format("`{}` is {:.6g}", key, number));
  return static_cast<std::uint64_t>(number);
}

Extent read_extent(const fs::path& folder) {
  const fs::path file = folder / "manifest.json";
  const auto fail = [&](const std::string& why) {
    throw InputError(fmt::format("{} is not what a run writes{}", file.string(), why));
  };
  Extent extent;
  try {
    const auto manifest = nlohmann::json::parse(read_file(file));
    extent.hash = manifest.at("scenario_sha256");
    extent.points = static_cast<int>(count_in(manifest, "points", most_points));
    extent.trials = count_in(manifest, "trials", most_of_trials);
    extent.runs = count_in(manifest, "outer", most_of_trials);
    extent.chunk_size = count_in(manifest, "chunk_size", most_of_trials);
  } catch (const nlohmann::json::exception&) {
    fail("");
  } catch (const UnreadableFile& fault) {
    fail(fmt::format(": {}", fault.what()));
  }
  if (extent.trials % extent.runs != 0)
    fail(fmt::format(": {} trials make no {} runs", extent.trials, extent.runs));
  if (static_cast<double>(extent.points) * static_cast<double>(extent.trials) /
          static_cast<double>(extent.chunk_size) >
      most_chunks)
    fail(fmt::format(": it has more than {:.0e} chunks", most_chunks));
  return extent;
}

bool is_run(const fs::path& folder) {
  std::error_code code;
  return fs::exists(folder / "chunks" / "request.json", code) && fs::exists(folder / "manifest.json", code);
}

/// The folders of runs: this one, or those in it.
std::vector<fs::path> runs_in(const fs::path& folder) {
  if (is_run(folder)) return {folder};
  std::vector<fs::path> runs;
  std::error_code code;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, code))
    if (is_run(entry.path())) runs.push_back(entry.path());
  if (code) throw InputError(fmt::format("{}: {}", folder.string(), code.message()));
  std::sort(runs.begin(), runs.end());
  return runs;
}

double age_of(const fs::path& file) {
  std::error_code code;
  const auto written = fs::last_write_time(file, code);
  if (code) return 0;
  return std::max(0.0, std::chrono::duration<double>(fs::file_time_type::clock::now() - written).count());
}

/// Counts the chunks of a shard that are there.
void count_chunks(ShardNews& news, const std::vector<ChunkRange>& plan) {
  for (std::size_t c = 0; c < plan.size(); ++c) {
    if (!news.shard.holds(c)) continue;
    ++news.wanted;
    const fs::path file = news.folder / "chunks" / plan[c].file_name();
    std::error_code code;
    if (!fs::exists(file, code)) continue;
    const double age = age_of(file);
    news.first = news.chunks ? std::max(news.first, age) : age;
    news.last = news.chunks ? std::min(news.last, age) : age;
    ++news.chunks;
  }
}

ShardNews news_of(const fs::path& folder, const Shard& shard, const std::vector<ChunkRange>& plan) {
  ShardNews news{.shard = shard, .folder = folder};
  count_chunks(news, plan);
  std::error_code code;
  if (fs::exists(folder, code)) news.writer = FolderLock::writer(folder);
  if (!news.writer.empty())
    news.state = ShardState::running;
  else if (news.chunks == news.wanted)
    news.state = ShardState::done;
  else if (fs::exists(folder, code))
    news.state = ShardState::stopped;
  return news;
}

}  // namespace

std::uint64_t RunNews::chunks() const {
  return std::accumulate(shards.begin(), shards.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const ShardNews& one) { return sum + one.chunks; });
}

std::uint64_t RunNews::wanted() const {
  return std::accumulate(shards.begin(), shards.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const ShardNews& one) { return sum + one.wanted; });
}

double RunNews::rate() const {
  double sum = 0;
  for (const ShardNews& one : shards)
    if (one.state == ShardState::running && one.chunks > 1 && one.first > 0)
      sum += static_cast<double>(one.chunks - 1) / one.first;
  return sum;
}

RunNews read_news(const fs::path& folder) {
  const std::vector<fs::path> folders = runs_in(folder);
  if (folders.empty())
    throw InputError(fmt::format("{} has no shards: no folder in it is a run that waits for `flyrock merge`",
                                 folder.string()));
  RunNews news;
  const Extent extent = read_extent(folders.front());
  news.request = read_request(folders.front() / "chunks");
  const std::uint64_t of = news.request.shard.of;
  if (static_cast<double>(of) > most_shards)
    throw InputError(fmt::format("{} is one of {} shards, expected at most {:.0e}", folders.front().string(),
                                 of, most_shards));
  const std::vector<ChunkRange> plan =
      plan_chunks(news.request.analysis ? news.request.analysis->runs : extent.points, extent.trials,
                  extent.chunk_size, extent.runs);
  std::vector<std::optional<fs::path>> folder_of(of);
  for (const fs::path& one : folders) {
    const Shard shard = read_request(one / "chunks").shard;
    if (shard.of != of || !(read_extent(one) == extent))
      throw InputError(
          fmt::format("{} and {} are shards of different runs: one folder is for the shards of one run",
                      folders.front().string(), one.string()));
    if (folder_of[shard.number - 1])
      throw InputError(
          fmt::format("{} and {} are the same shard", folder_of[shard.number - 1]->string(), one.string()));
    folder_of[shard.number - 1] = one;
  }
  for (std::uint64_t i = 0; i < of; ++i)
    news.shards.push_back(
        news_of(folder_of[i].value_or(folder / fmt::format("shard-{}", i + 1)), {i + 1, of}, plan));
  return news;
}

}  // namespace flyrock::cli
