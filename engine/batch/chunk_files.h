#pragma once
// The chunk files of a result that is not complete: a run in progress, killed or interrupted, or a shard.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "batch/chunk.h"

namespace flyrock {

/// A chunk and the folder of its file. All chunks share the folder's name, because there may be many of them.
struct ChunkFile {
  ChunkRange range;
  std::shared_ptr<const std::filesystem::path> folder;

  std::filesystem::path path() const { return *folder / range.file_name(); }
};

/// The files of `chunks` in a folder.
std::vector<ChunkFile> chunk_files(const std::vector<ChunkRange>& chunks,
                                   const std::filesystem::path& folder);

/// The rows of each point in chunk files, in the order of the plan. A pass reads the next chunk while one is
/// shown, and throws FileError if a file is not
/// what was written.
std::vector<Rows> rows_in(std::vector<ChunkFile> files, int points, const std::string& scenario_hash);

/// Removes every chunk file in a folder, including partly written ones of a killed run. Also removes the
/// folder if it is then empty. Throws FileError.
void remove_chunks(const std::filesystem::path& folder);

}  // namespace flyrock
