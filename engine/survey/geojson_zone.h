#pragma once
// Regions in plan from the polygons of a GeoJSON file.

#include <string>
#include <vector>

#include "geometry/plan_region.h"

namespace flyrock {

/// Which features of a file.
struct FeatureFilter {
  std::string property;  ///< empty: all features
  std::string value;     ///< of that property, a text, a number or a truth value as text
};

/// The polygons of the features, each ring without its repeated last corner. The region is their union:
/// features may overlap, and only inner rings are holes. Coordinates as in the file [m]. Throws PluginError:
/// "FILE: what is wrong", with the number of the feature from 1, or line and column where the file is no
/// JSON.
std::vector<PlanPolygon> read_polygons(const std::string& path, const FeatureFilter& filter);

}  // namespace flyrock
