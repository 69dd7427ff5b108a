#pragma once
// Grids of heights in files.

#include <string>

#include "geometry/height_grid.h"

namespace flyrock::plugins {

/// Reads a file of any other format through the module flyrock_gdal.so beside the plugins. Throws
/// PluginError; where the module is absent, it names the package that it needs.
HeightGrid read_with_gdal(const std::string& plugin, const std::string& path);

/// Reads a grid: the names .asc, .txt and .grd are ESRI ASCII, others go through GDAL.
HeightGrid read_raster(const std::string& plugin, const std::string& path);

/// The entry of flyrock_gdal.so: fills `grid`, or says in `wrong` what is wrong with the file.
using GdalReader = void (*)(const std::string& path, HeightGrid& grid, std::string& wrong);
inline constexpr const char* gdal_entry = "flyrock_read_with_gdal";

}  // namespace flyrock::plugins
