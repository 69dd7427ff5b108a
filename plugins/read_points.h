#pragma once
// Lists of points in text files, for shapes and terrains.

#include <string>
#include <vector>

namespace flyrock::plugins {

/// The points of a file of `columns` (2 or 3) numbers in metres a line, apart by a comma or blanks; # begins
/// a comment. Of an OBJ file (its name ends in .obj) the lines that begin with v. Throws PluginError, as the
/// plugin `plugin`, naming the line.
std::vector<std::vector<double>> read_points(const std::string& plugin, const std::string& path, int columns);

}  // namespace flyrock::plugins
