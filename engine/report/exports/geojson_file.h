#pragma once
// Features for a GIS as a GeoJSON file (RFC 7946), a feature a line.
//
// RFC 7946 knows longitudes and latitudes only. Places here are in the coordinates of the scenario; the
// member `crs` of the GeoJSON specification of 2008, which GIS still read, names their system.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "files/safe_file.h"
#include "geometry/plan_region.h"

namespace flyrock {

/// Geometries as text. A missing one is `null`.
std::string geojson_point(const Vec2& place);
std::string geojson_point(const Vec3& place);
std::string geojson_line(std::span<const Vec2> places);
/// A line has two places: a single one stands twice.
std::string geojson_line(std::span<const Vec3> places);
std::string geojson_region(std::span<const PlanPolygon> polygons);

class GeoJsonFile {
 public:
  /// `crs` is "EPSG:2056", or empty: not known. This and the other functions throw FileError.
  GeoJsonFile(const std::filesystem::path& path, const std::string& crs);
  void add(const nlohmann::ordered_json& properties, const std::string& geometry);
  std::size_t features() const { return features_; }
  /// Without it there is no file.
  void commit();

 private:
  FileWriter file_;
  std::size_t features_ = 0;
};

}  // namespace flyrock
