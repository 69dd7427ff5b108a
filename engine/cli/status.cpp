// flyrock status: how far the shards of a run are, and what runs the lost ones again.

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "cli/command.h"
#include "cli/shard_command.h"
#include "cli/shard_news.h"

namespace flyrock::cli {

namespace fs = std::filesystem;

namespace {

/// "1:02:11", or "2:11" below an hour.
std::string duration(double seconds) {
  const auto whole = static_cast<long>(std::lround(seconds));
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string line_of(const ShardNews& news) {
  const std::string done = fmt::format("{} of {} chunks", news.chunks, news.wanted);
  const std::string last = news.chunks ? fmt::format(", the last one {} ago", duration(news.last)) : "";
  switch (news.state) {
    case ShardState::done:
      return "done";
    case ShardState::running:
      return fmt::format("{}{}: {}", done, last, news.writer);
    case ShardState::stopped:
      return fmt::format("{}{}, and no task writes it", done, last);
    case ShardState::not_begun:
      return "not begun";
  }
  return {};
}

/// "130 of 200 chunks are done (65 %), 3.2 chunks a minute, 22:10 left"
std::string whole_text(const RunNews& news) {
  const std::uint64_t chunks = news.chunks(), wanted = news.wanted();
  std::string text = fmt::format(
      "{} of {} chunks are done ({:.0f} %)", chunks, wanted,
      wanted ? std::floor(100 * static_cast<double>(chunks) / static_cast<double>(wanted)) : 100.0);
  if (const double rate = news.rate(); rate > 0)
    text += fmt::format(", {:.3g} chunks a minute, {} left at this rate", 60 * rate,
                        duration(static_cast<double>(wanted - chunks) / rate));
  return text;
}

/// The numbers of an array of Slurm: "3-5,7".
std::string array_text(const std::vector<std::uint64_t>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text += fmt::format("{}{}", text.empty() ? "" : ",", numbers[i]);
    if (last > i) text += fmt::format("-{}", numbers[last]);
    i = last + 1;
  }
  return text;
}

/// The commands that run the shards without a task again.
std::vector<std::string> commands_for_lost(const RunNews& news, const fs::path& folder) {
  std::vector<std::uint64_t> numbers;
  std::vector<std::string> commands;
  for (const ShardNews& one : news.shards) {
    if (one.state == ShardState::done || one.state == ShardState::running) continue;
    numbers.push_back(one.shard.number);
    commands.push_back(fmt::format("{} --resume -o {}", command_of(news.request, one.shard),
                                   shell_word(one.folder.string())));
  }
  const fs::path script = folder / "array.sbatch";
  if (!numbers.empty() && fs::exists(script))
    return {fmt::format("sbatch --array={} {}", array_text(numbers), shell_word(script.string()))};
  return commands;
}

}  // namespace

int status(const Command& command, const Arguments& arguments) {
  boost::program_options::options_description options("options");
  options.add_options()("all", "a line for every shard, also for those that are done");
  const CommandLine line = parse(command, options, arguments, 1, 1);
  if (line.help) return done;
  const fs::path folder = line.words[0];
  std::error_code error;
  if (fs::exists(folder / "run.log", error) && !fs::exists(folder / "chunks", error)) {
    fmt::print("{}: done, the results are complete\n", folder.string());
    return done;
  }
  const RunNews news = read_news(folder);
  fmt::print("{}: {}\n", folder.string(), whole_text(news));
  for (const ShardNews& one : news.shards)
    if (one.state != ShardState::done || line.has("all"))
      fmt::print("  shard {} of {}: {}\n", one.shard.number, one.shard.of, line_of(one));
  const std::vector<std::string> commands = commands_for_lost(news, folder);
  if (!commands.empty()) fmt::print("lost, or not begun yet; this runs them again:\n");
  for (const std::string& again : commands) fmt::print("  {}\n", again);
  if (news.chunks() == news.wanted()) fmt::print("all shards are done: `flyrock merge` puts them together\n");
  return done;
}

}  // namespace flyrock::cli
