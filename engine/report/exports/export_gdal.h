#pragma once
// Maps and layers in the formats that GDAL writes, through the module flyrock_gdal.so.

#include <filesystem>
#include <vector>

namespace flyrock {

/// Writes what export_asc writes as GeoTIFF with numbers of 64 bits, <raster>-p<point>.tif, with the
/// coordinate system where it is known. Returns the files. Throws FileError, and PluginError without the
/// module.
std::vector<std::filesystem::path> export_tif(const std::filesystem::path& results,
                                              const std::filesystem::path& folder);

/// Writes the layers of export_geojson into one GeoPackage for each sweep point, results-p<point>.gpkg; the
/// same result gives the same bytes. Returns the files. Throws FileError, and PluginError without the module.
std::vector<std::filesystem::path> export_gpkg(const std::filesystem::path& results,
                                               const std::filesystem::path& folder);

}  // namespace flyrock
