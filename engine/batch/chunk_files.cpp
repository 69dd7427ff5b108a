#include "batch/chunk_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "batch/safe_file.h"

namespace flyrock {

namespace fs = std::filesystem;

std::vector<ChunkFile> chunk_files(const std::vector<ChunkRange>& chunks, const fs::path& folder) {
  std::vector<ChunkFile> files;
  for (const ChunkRange& chunk : chunks) files.push_back({chunk, folder / chunk.file_name()});
  return files;
}

std::vector<Rows> rows_in(const std::vector<ChunkFile>& files, int points, const std::string& scenario_hash) {
  std::vector<Rows> rows;
  for (int point = 0; point < points; ++point) {
    std::vector<ChunkFile> own;
    std::copy_if(files.begin(), files.end(), std::back_inserter(own),
                 [&](const ChunkFile& file) { return file.range.point == point; });
    rows.push_back([own = std::move(own), scenario_hash](Part part, const SeeRows& see) {
      for (const auto& [range, path] : own) {
        std::string why;
        const std::optional<TrialRecords> records = decode_chunk(read_file(path), range, scenario_hash, part, why);
        if (!records) throw FileError(fmt::format("{}: {}", path.string(), why));
        see(*records);
      }
    });
  }
  return rows;
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
