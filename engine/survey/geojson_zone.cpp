#include "survey/geojson_zone.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "document/printable.h"
#include "document/wording.h"
#include "geometry/plan_zone.h"
#include "plugin/params.h"
#include "survey/file_form.h"
#include "units/units.h"

namespace flyrock {

namespace {

using nlohmann::json;

class PolygonReader {
 public:
  PolygonReader(const std::string& path, const FeatureFilter& filter) : path_(path), filter_(filter) {}

  std::vector<PlanPolygon> read() {
    const json file = parsed();
    const std::string type = text_of(file, "type");
    if (type == "FeatureCollection" && file.contains("features") && file["features"].is_array())
      for (const json& feature : file["features"]) add_feature(feature);
    else if (type == "Feature")
      add_feature(file);
    else
      fail("is no GeoJSON: expected an object of `type` FeatureCollection");
    if (polygons_.empty()) fail_empty();
    refuse_degrees(file);
    return std::move(polygons_);
  }

 private:
  [[noreturn]] void fail(const std::string& text) const {
    throw PluginError(fmt::format("{}: {}", path_, text));
  }
  [[noreturn]] void fail_feature(const std::string& text) const {
    fail(fmt::format("feature {} {}", feature_, text));
  }

  /// What to do with a file of another format.
  void refuse_other_formats(const std::string& text) const {
    const std::string ending = ending_of(path_);
    const bool is_kml = ending == ".kml" || ending == ".kmz" || text.find("<kml") < 1000;
    const bool is_layer = ending == ".shp" || ending == ".dbf" || ending == ".gpkg" || ending == ".gml";
    if (is_kml || is_layer)
      fail(fmt::format(
          "is {}, expected GeoJSON: `ogr2ogr -t_srs EPSG:NUMBER zones.geojson {}` converts it; NUMBER is "
          "the system of the terrain",
          is_kml ? "KML" : "no GeoJSON", path_.substr(path_.rfind('/') + 1)));
  }

  json parsed() const {
    std::ifstream file(path_, std::ios::binary);
    if (!file) throw PluginError(fmt::format("cannot read the file {}", path_));
    std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
    refuse_other_formats(text);
    try {
      return json::parse(text);
    } catch (const json::parse_error& error) {
      const std::size_t at = std::min(error.byte, text.size());
      const auto begin = text.begin(), end = begin + static_cast<std::ptrdiff_t>(at);
      const std::size_t line_begin = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;  // npos + 1 is 0
      throw PluginError(fmt::format("{}:{}:{}: is no JSON: expected GeoJSON with polygons", path_,
                                    std::count(begin, end, '\n') + 1, at - std::min(at, line_begin) + 1));
    } catch (const json::exception&) {
      fail("is no JSON: a number is too large");
    }
  }

  static std::string text_of(const json& object, const char* key) {
    const bool has = object.is_object() && object.contains(key) && object[key].is_string();
    return has ? object[key].get<std::string>() : std::string();
  }

  void add_feature(const json& feature) {
    ++feature_;
    if (!is_wanted(feature)) return;
    if (!feature.is_object() || !feature.contains("geometry") || !feature["geometry"].is_object())
      fail_feature("has no geometry, expected a Polygon or MultiPolygon");
    const json& geometry = feature["geometry"];
    const std::string type = text_of(geometry, "type");
    if ((type != "Polygon" && type != "MultiPolygon") || !geometry.contains("coordinates"))
      fail_feature(fmt::format("is a `{}`, expected a Polygon or MultiPolygon", printable(type)));
    if (type == "Polygon")
      add_polygon(geometry["coordinates"]);
    else
      for (const json& polygon : geometry["coordinates"]) add_polygon(polygon);
  }

  bool is_wanted(const json& feature) {
    if (filter_.property.empty()) return true;
    const bool has = feature.is_object() && feature.contains("properties") &&
                     feature["properties"].is_object() && feature["properties"].contains(filter_.property);
    if (!has) return false;
    const json& value = feature["properties"][filter_.property];
    const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    if (std::find(values_.begin(), values_.end(), text) == values_.end()) values_.push_back(text);
    return text == filter_.value;
  }

  void add_polygon(const json& rings) {
    if (!rings.is_array()) fail_feature("has a polygon without a list of outlines");
    PlanPolygon polygon;
    for (const json& ring : rings) {
      std::vector<Vec2> outline = corners_of(ring);
      if (outline.size() > 1 && outline.front() == outline.back()) outline.pop_back();
      if (const std::string wrong = polygon_fault(outline); !wrong.empty())
        fail_feature("is no region: " + wrong);
      if (polygon.outline.empty())
        polygon.outline = std::move(outline);
      else
        polygon.holes.push_back(std::move(outline));
    }
    if (!polygon.outline.empty()) polygons_.push_back(std::move(polygon));
  }

  std::vector<Vec2> corners_of(const json& ring) const {
    if (!ring.is_array()) fail_feature("has an outline that is no list of places");
    std::vector<Vec2> corners;
    for (const json& place : ring) {
      if (!place.is_array() || place.size() < 2 || !place[0].is_number() || !place[1].is_number())
        fail_feature("has a corner that is not [x, y]");
      const Vec2 corner(place[0].get<double>(), place[1].get<double>());
      if (corners.empty() || corner != corners.back()) corners.push_back(corner);
    }
    return corners;
  }

  /// Longitudes and latitudes, which no terrain has: the file says so, or all of it lies in a degree of them.
  void refuse_degrees(const json& file) const {
    Vec2 low = Vec2::Constant(infinite), high = -low;
    for (const PlanPolygon& polygon : polygons_)
      for (const Vec2& corner : polygon.outline) {
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
      }
    const bool may_be = std::max(-low.x(), high.x()) <= 180 && std::max(-low.y(), high.y()) <= 90;
    const std::string system = file.contains("crs") ? file["crs"].dump() : "";
    const bool says_so = system.find("CRS84") != system.npos || system.find("4326") != system.npos ||
                         system.find("4258") != system.npos;
    if (may_be && (says_so || (high - low).maxCoeff() < 1))
      fail(fmt::format(
          "is in degrees (from {:.6g} to {:.6g} and {:.6g} to {:.6g}), expected metres: `ogr2ogr -t_srs "
          "EPSG:NUMBER zones.geojson {}` converts it; NUMBER is the system of the terrain",
          low.x(), high.x(), low.y(), high.y(), path_.substr(path_.rfind('/') + 1)));
  }

  [[noreturn]] void fail_empty() const {
    if (filter_.property.empty()) fail("has no feature");
    if (values_.empty()) fail(fmt::format("no feature has the property `{}`", printable(filter_.property)));
    fail(fmt::format("no feature has `{}` of `{}`{}", printable(filter_.value), printable(filter_.property),
                     suggestion(filter_.value, values_)));
  }

  const std::string& path_;
  const FeatureFilter& filter_;
  int feature_ = 0;  ///< from 1
  std::vector<std::string> values_;
  std::vector<PlanPolygon> polygons_;
};

}  // namespace

std::vector<PlanPolygon> read_polygons(const std::string& path, const FeatureFilter& filter) {
  return PolygonReader(path, filter).read();
}

}  // namespace flyrock
