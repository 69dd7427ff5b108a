#include "cli/shard.h"

#include <fmt/format.h>

#include <cstdlib>
#include <optional>

#include "cli/command.h"

namespace flyrock::cli {

namespace {

/// A variable of the environment as a whole number of at least `least`; nothing if it is not set or empty.
std::optional<std::uint64_t> variable(const char* name, std::uint64_t least) {
  const char* text = std::getenv(name);
  if (!text || !*text) return std::nullopt;
  return whole_number(text, name, least);
}

Shard checked(const Shard& shard, const char* number, const char* of) {
  if (shard.number <= shard.of) return shard;
  throw UsageError(
      fmt::format("--shard auto: {} names shard {} and {} has only {}", number, shard.number, of, shard.of));
}

}  // namespace

Shard read_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos)
    throw UsageError(fmt::format("--shard: `{}`, expected i/n, as 1/3, or auto", text));
  const Shard shard{whole_number(text.substr(0, slash), "--shard i", 1),
                    whole_number(text.substr(slash + 1), "--shard n", 1)};
  if (shard.number > shard.of) throw UsageError(fmt::format("--shard: `{}`, expected i from 1 to n", text));
  return shard;
}

Shard shard_of_task() {
  if (const auto task = variable("SLURM_ARRAY_TASK_ID", 1)) {
    const auto shards = variable("FLYROCK_SHARDS", 1);
    if (!shards)
      throw UsageError(
          "--shard auto: SLURM_ARRAY_TASK_ID is set and FLYROCK_SHARDS is not, expected the number of shards "
          "there");
    return checked({*task, *shards}, "SLURM_ARRAY_TASK_ID", "FLYROCK_SHARDS");
  }
  const auto rank = variable("OMPI_COMM_WORLD_RANK", 0), ranks = variable("OMPI_COMM_WORLD_SIZE", 1);
  if (rank && ranks) return checked({*rank + 1, *ranks}, "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE");
  const auto process = variable("SLURM_PROCID", 0), processes = variable("SLURM_NTASKS", 1);
  if (process && processes && *processes > 1)
    return checked({*process + 1, *processes}, "SLURM_PROCID", "SLURM_NTASKS");
  throw UsageError(
      "--shard auto: this is no task of a cluster: neither SLURM_ARRAY_TASK_ID, OMPI_COMM_WORLD_RANK nor "
      "SLURM_PROCID is set");
}

}  // namespace flyrock::cli
