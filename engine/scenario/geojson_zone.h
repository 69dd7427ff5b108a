#pragma once
// Regions in plan from the polygons of a GeoJSON file.

#include <string>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// Which features of a file.
struct FeatureFilter {
  std::string property;  ///< empty: all features
  std::string value;     ///< of that property, a text, a number or a truth value as text
};

/// The outlines of the polygons and their holes, each without its repeated last corner: a place is inside
/// where an odd number of them is about it. Coordinates as in the file [m]. Throws PluginError: "FILE: what
/// is wrong", with the number of the feature from 1, or line and column where the file is no JSON.
std::vector<std::vector<Vec2>> read_outlines(const std::string& path, const FeatureFilter& filter);

}  // namespace flyrock
