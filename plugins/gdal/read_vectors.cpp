// flyrock_gdal.so: layers of points, lines and regions in the formats that GDAL reads.

#include <cpl_conv.h>
#include <cpl_error.h>
#include <fmt/format.h>
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <set>

#include "survey/vector_file.h"

namespace flyrock {

namespace {

constexpr std::size_t most_features = 1'000'000, most_points = 10'000'000;

struct CloseVectors {
  void operator()(void* dataset) const { GDALClose(dataset); }
};
struct DestroyFeature {
  void operator()(void* feature) const { OGR_F_Destroy(static_cast<OGRFeatureH>(feature)); }
};
struct DestroyGeometry {
  void operator()(void* geometry) const { OGR_G_DestroyGeometry(static_cast<OGRGeometryH>(geometry)); }
};
struct DestroySystem {
  void operator()(void* system) const { OSRRelease(static_cast<OGRSpatialReferenceH>(system)); }
};
struct DestroyTransform {
  void operator()(void* transform) const {
    OCTDestroyCoordinateTransformation(static_cast<OGRCoordinateTransformationH>(transform));
  }
};

/// Options of GDAL that hold while a file is read.
class WhileReading {
 public:
  WhileReading() {
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
    CPLSetThreadLocalConfigOption("OGR_ARC_STEPSIZE", "1");  // degrees: 4 mm of 100 m
    CPLSetThreadLocalConfigOption("DXF_INLINE_BLOCKS", "YES");
    CPLSetThreadLocalConfigOption("OGR_GEOJSON_MAX_OBJ_SIZE", "0");
  }
  ~WhileReading() { CPLPopErrorHandler(); }
};

std::string code_of(OGRSpatialReferenceH system) {
  if (!system) return {};
  const char* authority = OSRGetAuthorityName(system, nullptr);
  const char* code = OSRGetAuthorityCode(system, nullptr);
  if (authority && code) return fmt::format("{}:{}", authority, code);
  const char* name = OSRGetName(system);
  return name && *name ? name : "a system without a name";
}

/// Adds the parts of one layer.
class LayerReader {
 public:
  LayerReader(OGRLayerH layer, bool is_drawing, const std::string& drawing_layer, VectorLayer& found)
      : layer_(layer), is_drawing_(is_drawing), drawing_layer_(drawing_layer), found_(found) {}

  std::string read(const std::string& crs) {
    const OGRFeatureDefnH definition = OGR_L_GetLayerDefn(layer_);
    for (int i = 0; i < OGR_FD_GetFieldCount(definition); ++i)
      found_.attributes.emplace_back(OGR_Fld_GetNameRef(OGR_FD_GetFieldDefn(definition, i)));
    with_places_ = crs != any_system;
    if (std::string wrong = with_places_ ? make_transform(crs) : std::string(); !wrong.empty()) return wrong;
    OGR_L_ResetReading(layer_);
    while (const OGRFeatureH next = OGR_L_GetNextFeature(layer_)) {
      const std::unique_ptr<void, DestroyFeature> feature(next);
      ++number_;
      if (static_cast<std::size_t>(number_) > most_features)
        return fmt::format("has more than {} features", most_features);
      if (!is_wanted(next)) continue;
      if (std::string wrong = add(next); !wrong.empty())
        return fmt::format("feature {} of `{}` {}", number_, found_.name, wrong);
    }
    return CPLGetLastErrorType() >= CE_Failure
               ? fmt::format("is cut or damaged: it cannot be read from feature {} on", number_ + 1)
               : std::string();
  }

 private:
  std::string make_transform(const std::string& crs) {
    const OGRSpatialReferenceH own = OGR_L_GetSpatialRef(layer_);
    if (own && OSRIsGeographic(own) && lies_beyond_degrees()) return {};  // GeoJSON that says nothing
    found_.crs = code_of(own);
    if (!own || OSRIsLocal(own)) {
      found_.crs.clear();
      return {};
    }
    if (crs == own_system) {
      if (!OSRIsGeographic(own) && std::abs(OSRGetLinearUnits(own, nullptr) - 1) < 1e-9) return {};
      return fmt::format("is in {}, whose unit is no metre: `ogr2ogr -t_srs EPSG:NUMBER` transforms it",
                         found_.crs);
    }
    if (crs.empty())
      return fmt::format(
          "is in {}, the terrain does not say its system: write `crs: EPSG:NUMBER` in `terrain`", found_.crs);
    if (found_.crs == crs) return {};
    const std::unique_ptr<void, DestroySystem> to(OSRNewSpatialReference(nullptr));
    if (OSRSetFromUserInput(to.get(), crs.c_str()) != OGRERR_NONE)
      return fmt::format("cannot be transformed to {}, which GDAL does not know", crs);
    const std::unique_ptr<void, DestroySystem> from(OSRClone(own));
    OSRSetAxisMappingStrategy(from.get(), OAMS_TRADITIONAL_GIS_ORDER);
    OSRSetAxisMappingStrategy(to.get(), OAMS_TRADITIONAL_GIS_ORDER);
    if (OSRIsSame(from.get(), to.get())) return {};
    transform_.reset(OCTNewCoordinateTransformation(from.get(), to.get()));
    found_.is_transformed = true;
    return transform_ ? std::string()
                      : fmt::format("is in {}, from which no way leads to {}", found_.crs, crs);
  }

  bool lies_beyond_degrees() const {
    OGREnvelope extent;
    return OGR_L_GetExtent(layer_, &extent, TRUE) == OGRERR_NONE &&
           std::max({std::abs(extent.MinX), std::abs(extent.MaxX), std::abs(extent.MinY),
                     std::abs(extent.MaxY)}) > 360;
  }

  /// Of a drawing: whether an entity is of the layer and has a place in the model, as labels and sheets of
  /// paper have none.
  bool is_wanted(OGRFeatureH feature) const {
    if (!is_drawing_) return true;
    const OGRGeometryH place = OGR_F_GetGeometryRef(feature);
    const bool is_label =
        has_value(feature, "Text") && place && wkbFlatten(OGR_G_GetGeometryType(place)) == wkbPoint;
    if (is_label || text_of(feature, "PaperSpace") == "1") return false;
    return drawing_layer_.empty() || drawing_layer_ == text_of(feature, layer_of_drawing);
  }

  static bool has_value(OGRFeatureH feature, const char* name) {
    const int field = OGR_F_GetFieldIndex(feature, name);
    return field >= 0 && OGR_F_IsFieldSetAndNotNull(feature, field);
  }

  static std::string text_of(OGRFeatureH feature, const char* name) {
    return has_value(feature, name) ? OGR_F_GetFieldAsString(feature, OGR_F_GetFieldIndex(feature, name))
                                    : "";
  }

  std::string add(OGRFeatureH feature) {
    VectorPart part;
    part.feature = number_;
    for (int i = 0; i < OGR_F_GetFieldCount(feature); ++i)
      if (OGR_F_IsFieldSetAndNotNull(feature, i))
        part.attributes.emplace_back(found_.attributes[static_cast<std::size_t>(i)],
                                     OGR_F_GetFieldAsString(feature, i));
    if (!with_places_) {
      found_.parts.push_back(std::move(part));
      return {};
    }
    const OGRGeometryH own = OGR_F_GetGeometryRef(feature);
    if (!own || OGR_G_IsEmpty(own)) return "has no geometry";
    const std::unique_ptr<void, DestroyGeometry> geometry(
        OGR_G_HasCurveGeometry(own, FALSE) ? OGR_G_GetLinearGeometry(own, 1, nullptr) : OGR_G_Clone(own));
    if (transform_ && OGR_G_Transform(geometry.get(), transform_.get()) != OGRERR_NONE)
      return fmt::format("lies where {} cannot be transformed", found_.crs);
    return add_geometry(geometry.get(), part);
  }

  std::string add_geometry(OGRGeometryH geometry, const VectorPart& of) {
    VectorPart part = of;
    part.has_heights = OGR_G_Is3D(geometry) != 0;
    switch (wkbFlatten(OGR_G_GetGeometryType(geometry))) {
      case wkbPoint:
      case wkbLineString:
        part.form = OGR_G_GetPointCount(geometry) == 1 ? FeatureForm::point : FeatureForm::line;
        part.lines = {points_of(geometry)};
        break;
      case wkbPolygon:
      case wkbTriangle:
        part.form = FeatureForm::region;
        for (int i = 0; i < OGR_G_GetGeometryCount(geometry); ++i) {
          std::vector<Vec3> ring = points_of(OGR_G_GetGeometryRef(geometry, i));
          if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
          part.lines.push_back(std::move(ring));
        }
        break;
      case wkbMultiPoint:
      case wkbMultiLineString:
      case wkbMultiPolygon:
      case wkbGeometryCollection:
      case wkbPolyhedralSurface:
      case wkbTIN:
        for (int i = 0; i < OGR_G_GetGeometryCount(geometry); ++i)
          if (std::string wrong = add_geometry(OGR_G_GetGeometryRef(geometry, i), of); !wrong.empty())
            return wrong;
        return {};
      default:
        return fmt::format("is a {}, expected points, lines or polygons", OGR_G_GetGeometryName(geometry));
    }
    for (const auto& line : part.lines)
      for (const Vec3& place : line)
        if (!place.allFinite()) return "has a place that is no number";
    if (points_ > most_points) return fmt::format("is beyond the first {} points of the file", most_points);
    found_.parts.push_back(std::move(part));
    return {};
  }

  std::vector<Vec3> points_of(OGRGeometryH line) {
    std::vector<Vec3> points;
    for (int i = 0; i < OGR_G_GetPointCount(line); ++i) {
      const Vec3 place(OGR_G_GetX(line, i), OGR_G_GetY(line, i), OGR_G_GetZ(line, i));
      if (points.empty() || place != points.back()) points.push_back(place);
      ++points_;
    }
    return points;
  }

  OGRLayerH layer_;
  bool is_drawing_;
  const std::string& drawing_layer_;
  VectorLayer& found_;
  std::unique_ptr<void, DestroyTransform> transform_;
  bool with_places_ = true;
  int number_ = 0;
  std::size_t points_ = 0;
};

/// The layers of a drawing, by their entities.
std::vector<std::string> drawing_layers(OGRLayerH layer) {
  std::set<std::string> names;
  OGR_L_ResetReading(layer);
  while (const OGRFeatureH next = OGR_L_GetNextFeature(layer)) {
    const std::unique_ptr<void, DestroyFeature> feature(next);
    const int field = OGR_F_GetFieldIndex(next, layer_of_drawing);
    if (field >= 0) names.insert(OGR_F_GetFieldAsString(next, field));
  }
  return {names.begin(), names.end()};
}

/// Whether a file is a DXF of AutoCAD 2007 (AC1021) or later, whose text is UTF-8 whatever code page its head
/// names; GDAL goes by the code page.
bool is_drawing_in_utf8(const std::string& path) {
  constexpr std::streamsize head_size = 4096;
  constexpr std::string_view variable = "$ACADVER", number = "AC", first = "AC1021";
  std::string head(head_size, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), head_size);
  head.resize(static_cast<std::size_t>(file.gcount()));
  const std::size_t at = head.find(variable);
  const std::size_t version = at == head.npos ? at : head.find(number, at + variable.size());
  return version != head.npos && std::string_view(head).substr(version, first.size()) >= first;
}

std::string read_file(const std::string& path, const std::string& name, const std::string& crs,
                      VectorLayer& found, std::vector<std::string>& names) {
  GDALAllRegister();
  CPLSetThreadLocalConfigOption("DXF_ENCODING", is_drawing_in_utf8(path) ? "UTF-8" : nullptr);
  const std::unique_ptr<void, CloseVectors> dataset(
      GDALOpenEx(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
  if (!dataset)
    return "is no file of layers that can be read: it is damaged, or of another format, such as DWG or "
           "binary "
           "DXF: save it as GeoPackage, GeoJSON, or DXF in text";
  const bool is_drawing = std::string(GDALGetDriverShortName(GDALGetDatasetDriver(dataset.get()))) == "DXF";
  std::vector<std::string> all;
  OGRLayerH chosen = nullptr;
  for (int i = 0; i < GDALDatasetGetLayerCount(dataset.get()); ++i) {
    const OGRLayerH layer = GDALDatasetGetLayer(dataset.get(), i);
    all.emplace_back(OGR_L_GetName(layer));
    if (is_drawing || all.back() == name) chosen = layer;
  }
  if (all.empty()) return "has no layer";
  if (is_drawing) {
    const std::vector<std::string> drawn = drawing_layers(chosen);
    if (!name.empty() && std::find(drawn.begin(), drawn.end(), name) == drawn.end()) {
      names = drawn;
      return names.empty() ? "has no entity" : "";
    }
  } else if (!chosen) {
    if (!name.empty() || all.size() > 1) {
      names = all;
      return {};
    }
    chosen = GDALDatasetGetLayer(dataset.get(), 0);
  }
  found.name = is_drawing && !name.empty() ? name : OGR_L_GetName(chosen);
  CPLErrorReset();
  return LayerReader(chosen, is_drawing, name, found).read(crs);
}

}  // namespace

extern "C" __attribute__((visibility("default"))) void flyrock_read_vectors(
    const std::string& path, const std::string& layer, const std::string& crs, VectorLayer& found,
    std::vector<std::string>& names, std::string& wrong) {
  const WhileReading options;
  try {
    wrong = read_file(path, layer, crs, found, names);
  } catch (const std::exception& error) {
    wrong = error.what();
  }
}

}  // namespace flyrock
