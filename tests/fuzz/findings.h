#pragma once
// Mutants that found something, saved so that they can be looked at and tried again.

#include <cstdint>
#include <filesystem>
#include <string>

namespace flyrock::fuzz {

struct Finding {
  std::string kind;
  std::uint64_t seed = 0, number = 0;
  std::string what;   ///< "signal 11", "without a line: s.yaml: error: ..."
  std::string lines;  ///< the command lines that were called, where they are known
  std::string err;    ///< what was said on stderr
};

/// Copies the files of the mutant from `from` to <folder>/<kind>-<seed>-<number>, with what.txt beside them,
/// and appends a line to <folder>/findings.txt. Of a kind 100 are kept.
void save(const Finding& finding, const std::filesystem::path& from, const std::filesystem::path& folder);

/// Appends a line to <folder>/rock_faults.txt: rocks may fail, but why is worth a look.
void note_rocks(const Finding& finding, const std::filesystem::path& folder);

}  // namespace flyrock::fuzz
