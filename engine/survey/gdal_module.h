#pragma once
// flyrock_gdal.so, the module that reads the formats of GDAL, so that flyrock runs without GDAL.

#include <string>

namespace flyrock {

/// Whether the module is there.
bool has_gdal();

/// An entry of the module, which is beside flyrock_plugins.so. Throws PluginError, which begins with `where`
/// ("raster: dem.tif") and ends with `conversion`, where the module is not installed.
void* gdal_entry_point(const std::string& where, const char* entry, const std::string& conversion);

}  // namespace flyrock
