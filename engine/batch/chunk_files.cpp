#include "batch/chunk_files.h"

#include <fmt/format.h>

#include "batch/safe_file.h"

namespace flyrock {

namespace fs = std::filesystem;

std::vector<ChunkFile> chunk_files(const std::vector<ChunkRange>& chunks, const fs::path& folder) {
  std::vector<ChunkFile> files;
  for (const ChunkRange& chunk : chunks) files.push_back({chunk, folder / chunk.file_name()});
  return files;
}

std::vector<TrialRecords> merge_chunks(const std::vector<ChunkFile>& files, int points,
                                       const std::string& scenario_hash, const SeeChunk& see) {
  std::vector<TrialRecords> merged(static_cast<std::size_t>(points));
  for (const auto& [range, path] : files) {
    std::string why;
    std::optional<TrialRecords> records = decode_chunk(read_file(path), range, scenario_hash, why);
    if (!records) throw FileError(fmt::format("{}: {}", path.string(), why));
    see(range, *records);
    records->inputs.clear();
    records->impacts.clear();
    append(merged.at(static_cast<std::size_t>(range.point)), std::move(*records));
  }
  return merged;
}

void remove_chunks(const fs::path& folder) {
  std::error_code code;
  if (!fs::exists(folder, code)) return;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(".chunk") && !name.ends_with(".chunk.partial")) continue;
    fs::remove(entry.path(), code);
    if (code) throw FileError(fmt::format("cannot remove {}: {}", entry.path().string(), code.message()));
  }
  fs::remove(folder, code);  // refused where somebody else's files are in it: they stay
}

}  // namespace flyrock
