#pragma once
// Lists of points in text files, for shapes and terrains.

#include <string>
#include <vector>

namespace flyrock::plugins {

/// Reads points from a file with `columns` (2 or 3) numbers in metres per line, separated by a comma or
/// blanks; # begins a comment. From an OBJ file (its name ends in .obj) it reads the lines that begin with v.
/// Throws PluginError in the name of the plugin `plugin`, with the line number.
std::vector<std::vector<double>> read_points(const std::string& plugin, const std::string& path, int columns);

}  // namespace flyrock::plugins
