#pragma once
// Lists of points in text files, for shapes and terrains.

#include <span>
#include <string>
#include <vector>

#include "document/table.h"
#include "math/space.h"

namespace flyrock::plugins {

struct PointFile {
  std::vector<std::vector<double>> points;  ///< m, in the order of the columns
  std::vector<std::string> other_heads;     ///< which are no columns
};

/// Reads points from a table (document/table.h, TableForm::points) with these columns. Throws FileFaults in
/// the name of the plugin `plugin`.
PointFile read_points(const std::string& plugin, const std::string& path,
                      std::span<const TableColumn> columns);

/// The vertices of an OBJ file: its lines that begin with v. Throws PluginError in the name of the plugin.
std::vector<Vec3> read_obj_points(const std::string& plugin, const std::string& path);

}  // namespace flyrock::plugins
