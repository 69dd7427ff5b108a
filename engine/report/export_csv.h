#pragma once
// The tables of a result as CSV files.

#include <filesystem>
#include <vector>

namespace flyrock {

/// Writes one file for each table of the database `results`, as docs/results.md lists them, into `folder`, in
/// the order of the rows; no value is an empty field. Returns the files. Throws FileError.
std::vector<std::filesystem::path> export_csv(const std::filesystem::path& results,
                                              const std::filesystem::path& folder);

}  // namespace flyrock
