#include "batch/chunk_files.h"

#include <fmt/format.h>

#include <future>
#include <utility>

#include "files/safe_file.h"

namespace flyrock {

namespace fs = std::filesystem;

namespace {

TrialRecords records_in(const ChunkFile& file, const std::string& scenario_hash, Part part) {
  std::string why;
  std::optional<TrialRecords> records = read_chunk(file.path(), file.range, scenario_hash, part, why);
  if (!records) throw FileError(fmt::format("{}: {}", file.path().string(), why));
  return std::move(*records);
}

}  // namespace

std::vector<ChunkFile> chunk_files(const std::vector<ChunkRange>& chunks, const fs::path& folder) {
  const auto shared = std::make_shared<const fs::path>(folder);
  std::vector<ChunkFile> files;
  files.reserve(chunks.size());
  for (const ChunkRange& chunk : chunks) files.push_back({chunk, shared});
  return files;
}

std::vector<Rows> rows_in(std::vector<ChunkFile> files, int points, const std::string& scenario_hash) {
  const auto all = std::make_shared<const std::vector<ChunkFile>>(std::move(files));
  std::vector<Rows> rows;
  for (int point = 0; point < points; ++point)
    rows.emplace_back([all, point, scenario_hash](Part part, const TrialRange& trials, const SeeRows& see) {
      std::vector<const ChunkFile*> wanted;
      for (const ChunkFile& file : *all)
        if (file.range.point == point && trials.meets(file.range.first, file.range.count))
          wanted.push_back(&file);
      const auto read_soon = [&](std::size_t i) {
        return i == wanted.size() ? std::future<TrialRecords>() : std::async(std::launch::async, [&, i] {
          return records_in(*wanted[i], scenario_hash, part);
        });
      };
      std::future<TrialRecords> next = read_soon(0);
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        const TrialRecords records = next.get();
        next = read_soon(i + 1);
        see(records);
      }
    });
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
  fs::remove(folder, code);  // fails if the folder holds files of others, which then stay
}

}  // namespace flyrock
