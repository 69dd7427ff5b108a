#pragma once
// The valid inputs for mutation: the files that flyrock ships, and the few files of tests/fuzz/corpus.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace flyrock::fuzz {

struct Source {
  std::string name;  ///< path relative to the source tree
  std::string text;
  std::vector<std::pair<std::string, std::string>>
      beside;  ///< names and texts of files in its folder that it may name

  std::filesystem::path file() const { return std::filesystem::path(name).filename(); }
};

/// The files with this extension in folders of the source tree, sorted by name. `beside` lists the extensions
/// of files to add from their folders.
std::vector<Source> sources_in(const std::vector<std::string>& folders, const std::string& extension,
                               const std::vector<std::string>& beside = {});

std::string read_source(const std::string& name);

/// Writes a file into the current folder.
void write_here(const std::string& name, const std::string& bytes);

}  // namespace flyrock::fuzz
