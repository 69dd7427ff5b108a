#pragma once
// The sound inputs that mutants are made of: what flyrock ships, and the few files of tests/fuzz/corpus.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace flyrock::fuzz {

struct Source {
  std::string name;  ///< its path below the source tree
  std::string text;
  std::vector<std::pair<std::string, std::string>>
      beside;  ///< names and texts of files of its folder that it may name

  std::filesystem::path file() const { return std::filesystem::path(name).filename(); }
};

/// The files with this extension below folders of the source tree, by name; `beside` those with the
/// extensions given.
std::vector<Source> sources_in(const std::vector<std::string>& folders, const std::string& extension,
                               const std::vector<std::string>& beside = {});

std::string read_source(const std::string& name);

/// Into the current folder.
void write_here(const std::string& name, const std::string& bytes);

}  // namespace flyrock::fuzz
