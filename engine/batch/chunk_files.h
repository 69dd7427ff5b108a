#pragma once
// The chunk files of a result that is not whole yet: a run under way, killed or interrupted, or a shard.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "batch/chunk.h"

namespace flyrock {

/// A chunk and the file that holds it.
struct ChunkFile {
  ChunkRange range;
  std::filesystem::path path;
};

/// The files of `chunks` in a folder.
std::vector<ChunkFile> chunk_files(const std::vector<ChunkRange>& chunks, const std::filesystem::path& folder);

/// Shown each chunk in order, with all its rows.
using SeeChunk = std::function<void(const ChunkRange& range, const TrialRecords& records)>;

/// The records of each point, from chunk files in the order of the plan; of inputs and impacts nothing is kept once
/// they were shown, since there are many of them and only tables read them. One chunk at a time is in memory. Throws
/// FileError where a file is not what was written.
std::vector<TrialRecords> merge_chunks(const std::vector<ChunkFile>& files, int points,
                                       const std::string& scenario_hash,
                                       const SeeChunk& see = [](const ChunkRange&, const TrialRecords&) {});

/// Removes every chunk file in a folder, what a kill left of one included, and the folder where nothing else is in
/// it. Throws FileError.
void remove_chunks(const std::filesystem::path& folder);

}  // namespace flyrock
