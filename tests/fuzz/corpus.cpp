#include "corpus.h"

#include <algorithm>
#include <fstream>

#include "files/safe_file.h"
#include "long_scenarios.h"

namespace flyrock::fuzz {

namespace fs = std::filesystem;

namespace {

/// Whether mutants of a file would take seconds each.
bool is_slow(const fs::path& path) {
  const std::string name = fs::relative(path, fs::path(FLYROCK_SOURCE_DIR) / "scenarios").string();
  return long_trials.contains(name) || short_steps.contains(name);
}

std::vector<fs::path> files_below(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() == extension) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<Source> sources_in(const std::vector<std::string>& folders, const std::string& extension,
                               const std::vector<std::string>& beside) {
  const fs::path root = FLYROCK_SOURCE_DIR;
  std::vector<Source> sources;
  for (const std::string& folder : folders)
    for (const fs::path& path : files_below(root / folder, extension)) {
      if (is_slow(path)) continue;
      Source source{fs::relative(path, root).string(), read_file(path), {}};
      for (const std::string& other : beside)
        for (const fs::path& file : files_below(path.parent_path(), other))
          if (file != path)
            source.beside.emplace_back(fs::relative(file, path.parent_path()).string(), read_file(file));
      sources.push_back(std::move(source));
    }
  return sources;
}

std::string read_source(const std::string& name) { return read_file(fs::path(FLYROCK_SOURCE_DIR) / name); }

void write_here(const std::string& name, const std::string& bytes) {
  if (const fs::path folder = fs::path(name).parent_path(); !folder.empty()) fs::create_directories(folder);
  std::ofstream(name, std::ios::binary)
      << bytes;  // not synced as write_file does: mutants are many and go away
}

}  // namespace flyrock::fuzz
