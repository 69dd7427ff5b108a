#pragma once
// Terrains from the files of surveys: what their readers found and changed, and all that is wrong with a
// file.

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "geometry/height_grid.h"
#include "geometry/mesh.h"
#include "plugin/models.h"

namespace flyrock {

/// What was read of a file.
struct SurveyReport {
  std::string size;                ///< "227,000 cells of 5 m, 412 to 1,180 m"
  std::string crs;                 ///< "EPSG:2056"; empty: the file does not say
  bool is_converted = false;       ///< its places were made metres: `crs` of the file is not theirs
  std::vector<std::string> notes;  ///< what was changed or may be wrong, a sentence each, for warnings
};

/// A terrain that says what it read.
class SurveyedTerrain : public TerrainModel {
 public:
  /// The report of the last build_3d.
  virtual SurveyReport report() const = 0;
};

/// Several faults of one file. The text has all of them.
struct FileFaults : PluginError {
  explicit FileFaults(std::vector<std::string> all)
      : PluginError(fmt::format("{}", fmt::join(all, "; "))), faults(std::move(all)) {}
  std::vector<std::string> faults;
};

inline constexpr double lowest_ground = -1000,
                        highest_ground = 9000;  ///< m: no quarry and no mountain is beyond
inline bool is_height_of_ground(double z) { return !(z < lowest_ground || z > highest_ground); }

/// 1234567 as "1,234,567".
inline std::string with_commas(std::size_t number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, ",");
  return text;
}

/// "412 to 1,180.5 m"
inline std::string heights_text(double low, double high) {
  const auto text = [](double z) {
    const std::string plain = fmt::format("{:.1f}", std::abs(z) < 0.05 ? 0.0 : z);
    const std::string whole = plain.ends_with(".0") ? plain.substr(0, plain.size() - 2) : plain;
    const std::size_t point = std::min(whole.find('.'), whole.size());
    const std::size_t first = whole.starts_with('-') ? 1 : 0;
    return point - first > 3 ? std::string(whole).insert(point - 3, ",") : whole;
  };
  return fmt::format("{} to {} m", text(low), text(high));
}

inline std::string heights_of(const HeightGrid& grid) {
  double low = infinite, high = -low;
  for (const double z : grid.heights) {
    if (z < low) low = z;  // not of NaN
    if (z > high) high = z;
  }
  return heights_text(low, high);
}

inline std::string heights_of(const Mesh& mesh) {
  double low = infinite, high = -low;
  for (const auto& triangle : mesh.triangles)
    for (const int corner : triangle) {
      low = std::min(low, mesh.vertices[corner].z());
      high = std::max(high, mesh.vertices[corner].z());
    }
  return heights_text(low, high);
}

}  // namespace flyrock
