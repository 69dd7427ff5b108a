#pragma once
// The chunk files of a result that is not whole yet: a run under way, killed or interrupted, or a shard.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "batch/chunk.h"

namespace flyrock {

/// A chunk and the folder that holds its file. There may be many of them: they share the folder's name.
struct ChunkFile {
  ChunkRange range;
  std::shared_ptr<const std::filesystem::path> folder;

  std::filesystem::path path() const { return *folder / range.file_name(); }
};

/// The files of `chunks` in a folder.
std::vector<ChunkFile> chunk_files(const std::vector<ChunkRange>& chunks,
                                   const std::filesystem::path& folder);

/// The rows of each point, in chunk files in the order of the plan. A pass throws FileError where a file is
/// not what was written.
std::vector<Rows> rows_in(std::vector<ChunkFile> files, int points, const std::string& scenario_hash);

/// Removes every chunk file in a folder, what a kill left of one included, and the folder where nothing else
/// is in it. Throws FileError.
void remove_chunks(const std::filesystem::path& folder);

}  // namespace flyrock
