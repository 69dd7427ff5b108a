#pragma once
// Points of laser scans and surveys in files: XYZ and LAS.

#include <optional>
#include <string>
#include <vector>

#include "math/space.h"

namespace flyrock {

struct PointCloud {
  std::vector<Vec3> points;  ///< in the units of the file
  std::size_t all = 0;       ///< points of the file, those of other classes too
  std::string plan_unit;     ///< m, ft or us_ft; empty: the file does not say
  std::string crs;           ///< "EPSG:2056"; empty: the file does not say
  std::vector<std::string> notes;
};

/// Whether the name of a file is that of a cloud: .xyz, .pts, .las, .laz.
bool is_point_cloud(const std::string& path);

/// Reads a cloud. XYZ: lines of numbers, of which three are x, y and z (survey/xyz_lines.h). LAS 1.2 to 1.4
/// (ASPRS), point formats 0 to 10: places, and the class by which points are chosen (2 is the ground;
/// withheld points are left out). `of_class`: only these points; an XYZ file has no classes. `who` begins
/// each error: "plugin points". Throws PluginError; for LAZ with the command that unpacks it.
PointCloud read_point_cloud(const std::string& who, const std::string& path, std::optional<int> of_class);

}  // namespace flyrock
