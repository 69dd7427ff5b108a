#pragma once
// The tables of a result as an HDF5 file.

#include <filesystem>
#include <vector>

namespace flyrock {

/// Writes each table of the database `results` (exported_tables.h) as a group of the file results.h5 in
/// `folder`, each column as a data set of one dimension, in the order of the rows: whole numbers of 64 bits;
/// doubles, NaN where a value is missing; texts of equal length in UTF-8, filled up with zeros. Returns the
/// file. Throws FileError, also where this flyrock was built without HDF5.
std::vector<std::filesystem::path> export_hdf5(const std::filesystem::path& results,
                                               const std::filesystem::path& folder);

}  // namespace flyrock
