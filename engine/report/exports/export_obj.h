#pragma once
// Exports the blocks between joints as they stand at the start.

#include <filesystem>
#include <vector>

#include "report/exports/vtk_file.h"
#include "report/tables/sqlite.h"

namespace flyrock {

/// Writes into `folder`, for each sweep point with blocks in the database `results`, the file
/// blocks-p<point>.obj: the blocks of trial 0 with shared vertices once, each block a group `block_<number>`
/// and the group of its mode (record/block_row.h). In 2D a block is a face in the plane z = 0. Returns the
/// files; none without blocks. Throws FileError.
std::vector<std::filesystem::path> export_obj(const std::filesystem::path& results,
                                              const std::filesystem::path& folder);

/// The faces of the blocks of trial 0 of a point as polygons; cell data: block, rock, removable, mode (0
/// falls, 1 plane, 2 wedge, 3 held, 4 locked), factor (-1: none), volume_m3. No polygons without blocks.
VtkPoints stored_blocks(const SqliteReader& database, std::int64_t point);

}  // namespace flyrock
