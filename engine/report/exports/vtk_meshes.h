#pragma once
// The meshes of deformable bodies over time, for ParaView.

#include <filesystem>

#include "report/tables/sqlite.h"

namespace flyrock {

/// Writes `index` (.pvd) and a folder of the same name with one file (.vtu) for each instant of the first
/// trial that has nodes and cells (`output.series`): all deformable bodies, their nodes where they are. Point
/// data: displacement_m, rate_m_s (in the axes of the world); cell data: body (by number), tension_Pa,
/// compression_Pa. Returns whether there are any. Throws FileError.
bool write_meshes(const std::filesystem::path& index, const SqliteReader& database, std::int64_t point,
                  const std::string& crs);

}  // namespace flyrock
