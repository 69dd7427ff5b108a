#pragma once
// The surfaces of rocks in their attitudes over time, for ParaView.

#include <filesystem>
#include <vector>

#include "report/tables/stored_paths.h"

namespace flyrock {

/// Writes `index` (.pvd) and a folder of the same name with one file a step: the surfaces of the rocks of
/// one sweep point at their places and in their attitudes. Polyhedra, boxes and polygons have their faces,
/// spheres are triangulated balls and disks polygons, both inscribed. Cell data: trial, rock, runout_m,
/// speed_m_s, energy_J, mode. Steps are a round number of seconds. There are at most 500 of them, and fewer
/// (at least 20) if the files would exceed about 100 MB. The first rocks are shown, as many as fit then.
/// Coordinates are rounded to 0.1 mm. Throws FileError.
void write_shapes(const std::filesystem::path& index, const SqliteReader& database,
                  const std::vector<StoredPath>& paths);

}  // namespace flyrock
