#pragma once
// The stored ground of a sweep point, for exports.

#include <cstdint>

#include "report/exports/vtk_file.h"
#include "report/tables/sqlite.h"

namespace flyrock {

/// The ground of trial 0, in 2D a line for each segment, in 3D the triangles where rocks were
/// (report/pictures/ground_pictures.h); cell data: its part.
VtkPoints stored_ground_surface(const SqliteReader& database, std::int64_t point);

}  // namespace flyrock
