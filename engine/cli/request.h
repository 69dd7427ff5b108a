#pragma once
// The file that a run was started with, stored with its chunks, because merging shards needs the scenario and
// its plugins again.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenario/decode.h"

namespace flyrock::cli {

/// The part of the chunks that a run makes: every `of`-th chunk, so that the shards of a sweep take equally
/// long.
struct Shard {
  std::uint64_t number = 1, of = 1;

  /// Whether the shard contains the chunk with this index among all chunks of the plan.
  bool holds(std::size_t chunk) const { return chunk % of == number - 1; }
};

/// What `flyrock sensitivity` is asked, as it was written.
struct AnalysisRequest {
  std::vector<std::string> of, groups;  ///< each --of and --group
  std::string inputs, line;             ///< empty: not given
  int runs = 0;                         ///< the points of its chunks
};

struct Request {
  std::string scenario;  ///< path
  Overrides overrides;
  Shard shard = {};                              ///< all chunks, unless --shard is given
  std::optional<AnalysisRequest> analysis = {};  ///< of `flyrock sensitivity`; absent: of `flyrock run`
};

/// Writes chunks/request.json, with the path made absolute. Throws FileError.
void write_request(const std::filesystem::path& chunks, const Request& request);
/// Throws UnreadableFile if there is none.
Request read_request(const std::filesystem::path& chunks);
void remove_request(const std::filesystem::path& chunks);

}  // namespace flyrock::cli
