#pragma once
// flyrock_gdal.so, the module that reads and writes the formats of GDAL, so that flyrock runs without GDAL.

#include <string>
#include <vector>

namespace flyrock {

/// Whether the module is there.
bool has_gdal();

/// An entry of the module, which is beside flyrock_plugins.so. Throws PluginError, which begins with `where`
/// ("raster: dem.tif") and ends with `conversion`, where the module is not installed.
void* gdal_entry_point(const std::string& where, const char* entry, const std::string& conversion);

/// The entries that write a raster, or layers, in another format, with the options of the programs
/// gdal_translate and ogr2ogr. False if GDAL cannot.
using GdalTranslator = bool (*)(const std::vector<std::string>& options, const std::string& from,
                                const std::string& to);
inline constexpr const char* raster_translator = "flyrock_translate_raster";
inline constexpr const char* layer_translator = "flyrock_translate_layers";

}  // namespace flyrock
