#pragma once
// Layers of points, lines and regions in the files of a GIS or of CAD.

#include <string>
#include <utility>
#include <vector>

#include "math/space.h"

namespace flyrock {

enum class FeatureForm { point, line, region };

/// A feature, or one part of it where it has several.
struct VectorPart {
  int feature = 0;  ///< from 1, in the order of the file
  FeatureForm form = FeatureForm::point;
  /// A point; the points of a line; the rings of a region, the outer one first, each without its repeated
  /// last corner.
  std::vector<std::vector<Vec3>> lines;
  bool has_heights = false;
  std::vector<std::pair<std::string, std::string>> attributes;  ///< name and value as text; of NULL none

  /// The value of an attribute; null: it has none.
  const std::string* value_of(const std::string& attribute) const;
};

struct VectorLayer {
  std::string name;
  std::vector<VectorPart> parts;
  std::vector<std::string> attributes;  ///< names
  std::string crs;                      ///< of the file, "EPSG:4326" or a name; empty: it does not say
  bool is_transformed = false;          ///< from that system to the one that was asked for
};

/// In place of a system: places stay in that of the file, which must be in metres.
inline constexpr const char* own_system = "own";
/// In place of a system: the attributes of each feature alone, without its places.
inline constexpr const char* any_system = "any";

/// Reads a layer through the module flyrock_gdal.so: GeoPackage, shapefile, KML, DXF (the layers of the
/// drawing; arcs as chords of a degree), GeoJSON and what else GDAL reads. `layer`: empty for the only one.
/// `crs`: of the terrain, "EPSG:2056", to which places are transformed [m]; empty: it has none, and then a
/// file that says its own is an error. x is east, whatever the order of the axes of a system. Throws
/// PluginError, which begins with the path; where the module is not installed, it ends with `conversion`.
VectorLayer read_vector_layer(const std::string& path, const std::string& layer, const std::string& crs,
                              const std::string& conversion);

/// The attribute of the features of a DXF file that is the layer of the drawing.
inline constexpr const char* layer_of_drawing = "Layer";

/// The entry of flyrock_gdal.so: fills `found`, or says in `wrong` what is wrong with the file; where no
/// layer has the name, `names` has those that there are.
using VectorReader = void (*)(const std::string& path, const std::string& layer, const std::string& crs,
                              VectorLayer& found, std::vector<std::string>& names, std::string& wrong);
inline constexpr const char* vector_entry = "flyrock_read_vectors";

}  // namespace flyrock
