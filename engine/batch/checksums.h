#pragma once
// SHA256SUMS: the SHA-256 of the files of a result, as the tool `sha256sum` writes and checks them. With it a
// command finds a flipped bit, or a file that is cut short, before it reads anything: neither SQLite nor a
// table of text would.

#include <array>
#include <filesystem>

namespace flyrock {

inline constexpr const char* checksums_name = "SHA256SUMS";
/// The files of a result that are summed: all but the page, which `flyrock report` draws again, and the log
/// of the run.
inline constexpr std::array summed_names = {"manifest.json", "results.db", "rocks.csv", "summary.json"};

/// Writes SHA256SUMS of a folder in which all of them stand. Throws FileError.
void write_checksums(const std::filesystem::path& folder);

/// Compares all of them. Throws UnreadableFile that names the first that is not what the run wrote.
void check_checksums(const std::filesystem::path& folder);

}  // namespace flyrock
