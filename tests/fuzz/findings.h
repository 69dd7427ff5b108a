#pragma once
// Saves mutants with findings, so that they can be looked at and run again.

#include <cstdint>
#include <filesystem>
#include <string>

namespace flyrock::fuzz {

struct Finding {
  std::string kind;
  std::uint64_t seed = 0, number = 0;
  std::string what;        ///< "signal 11", "without a line: s.yaml: error: ..."
  std::string lines;       ///< the command lines that were called, if known
  std::string err;         ///< output on stderr
  bool is_listed = false;  ///< no failure (Calls::only_list)
};

/// Copies the files of the mutant from `from` to <folder>/<kind>-<seed>-<number>, adds what.txt, and appends
/// a line to <folder>/findings.txt, or listed.txt if it is no failure. Keeps at most 100 mutants of each
/// kind.
void save(const Finding& finding, const std::filesystem::path& from, const std::filesystem::path& folder);

/// Appends a line to <folder>/rock_faults.txt. Rocks may fail, but the reason is worth a look.
void note_rocks(const Finding& finding, const std::filesystem::path& folder);

}  // namespace flyrock::fuzz
