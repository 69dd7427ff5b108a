#pragma once
// What a result of a 3D run has in plan, as layers for a GIS.

#include <filesystem>
#include <vector>

namespace flyrock {

/// Writes into `folder`, for each sweep point of a 3D result in the database `results`, a file
/// <layer>-p<point>.geojson for each layer that has features:
///   paths      a line for each stored path, with heights. Properties as of ends
///   ends       where each rock ended. Properties: the columns of `rocks`
///   releases   where each rock started, in plan. Properties: trial, rock, group, launch
///   gates, barriers   their lines. Properties: the numbers of their entries in summary.json
///   trees      the foot of each tree. Properties: the columns of `stems`
///   zones      the region of each zone of the terrain. Properties: zone, name
///   area       the blasting area of each clearance with sectors, and the area of least size. Properties: the
///              numbers of its entry in summary.json, and `limit`: "area", "with_factor" or "area_least"
/// A rock that did not start has no geometry. Returns the files; none in 2D. Throws FileError.
std::vector<std::filesystem::path> export_geojson(const std::filesystem::path& results,
                                                  const std::filesystem::path& folder);

}  // namespace flyrock
