#pragma once
// What the shards of a run have done by now, as their folders say.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/request.h"

namespace flyrock::cli {

/// A shard: done, or written by a task, or without one: stopped in the middle or not begun.
enum class ShardState { done, running, stopped, not_begun };

struct ShardNews {
  Shard shard;
  std::filesystem::path folder = {};  ///< where it is, or where it belongs
  ShardState state = ShardState::not_begun;
  std::string writer = {};  ///< the process that writes it
  std::uint64_t chunks = 0, wanted = 0;
  double first = 0,
         last = 0;  ///< s before now: when its first and its last chunk were written, if `chunks` > 0
};

/// All shards of a run.
struct RunNews {
  Request request;  ///< of all shards
  std::vector<ShardNews> shards;

  std::uint64_t chunks() const;
  std::uint64_t wanted() const;
  /// Chunks a second of the shards that run: each since its first chunk; 0 if that is not known.
  double rate() const;
};

/// Reads a folder of shards, or the folder of one run. Throws InputError if it is neither, and if its shards
/// are of different runs.
RunNews read_news(const std::filesystem::path& folder);

}  // namespace flyrock::cli
