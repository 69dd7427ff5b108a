#pragma once
// The tables of a result as CSV files.

#include <filesystem>
#include <vector>

namespace flyrock {

/// Writes each table of the database `results` into its own file in `folder`, as docs/results.md lists them.
/// Rows keep their order; a missing value is an empty field. Returns the files. Throws FileError.
std::vector<std::filesystem::path> export_csv(const std::filesystem::path& results,
                                              const std::filesystem::path& folder);

}  // namespace flyrock
