#pragma once
// What a result shows, as a drawing for CAD programs.

#include <filesystem>
#include <vector>

namespace flyrock {

/// Writes into `folder`, for each sweep point of the database `results`, a drawing results-p<point>.dxf in
/// the coordinates of the scenario, in metres:
///   3D  in plan with heights: PATHS, ENDS, RELEASES, GATES, BARRIERS, TREES, ZONES as the layers of
///       export_geojson.h; AREA, AREA_WITH_FACTOR, AREA_LEAST: the outlines of its areas by `limit`
///   2D  a section, x to the right and heights up: GROUND, PATHS, ENDS; GATES: their place on the ground;
///       BARRIERS: as high as they are; ENVELOPE_P50, ENVELOPE_P95, ENVELOPE_MAX: the greatest heights of
///       centres of mass above the ground, in the middle of each bin that rocks pass
/// Returns the files. Throws FileError.
std::vector<std::filesystem::path> export_dxf(const std::filesystem::path& results,
                                              const std::filesystem::path& folder);

}  // namespace flyrock
