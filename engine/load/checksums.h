#pragma once
// SHA256SUMS: the SHA-256 of the files of a result, in the format of the tool `sha256sum`. With it a command
// finds a flipped bit or a truncated file before it reads anything. SQLite and text tables do not detect such
// damage.

#include <array>
#include <filesystem>

#include "scenario/last_states.h"

namespace flyrock {

inline constexpr const char* checksums_name = "SHA256SUMS";
/// The files of a result that have a checksum. The page has none, because `flyrock report` draws it again;
/// the log of the run has none either.
inline constexpr std::array summed_names = {last_states_name, "manifest.json", "results.db", "rocks.csv",
                                            "summary.json"};

/// Writes SHA256SUMS of a folder that holds all of these files. Throws FileError.
void write_checksums(const std::filesystem::path& folder);

/// Compares all checksums. Throws UnreadableFile with the name of the first file that the run did not write
/// like this.
void check_checksums(const std::filesystem::path& folder);
/// Compares that of one file.
void check_checksum(const std::filesystem::path& folder, const char* name);

}  // namespace flyrock
