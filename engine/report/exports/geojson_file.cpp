#include "report/exports/geojson_file.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "document/value.h"

namespace flyrock {

namespace {

std::string place_text(const Vec2& p) { return fmt::format("[{},{}]", shortest(p.x()), shortest(p.y())); }
std::string place_text(const Vec3& p) {
  return fmt::format("[{},{},{}]", shortest(p.x()), shortest(p.y()), shortest(p.z()));
}

/// [a,b,...] of the texts of some things.
template <class Things, class Text>
std::string list_text(const Things& things, Text text) {
  std::string list = "[";
  for (const auto& thing : things) {
    if (list.size() > 1) list += ',';
    list += text(thing);
  }
  return list + ']';
}

template <class Places>
std::string line_text(const Places& places) {
  std::string line = list_text(places, [](const auto& place) { return place_text(place); });
  if (places.size() == 1) line = fmt::format("[{0},{0}]", place_text(places.front()));
  return fmt::format(R"({{"type":"LineString","coordinates":{}}})", line);
}

/// The last place of a ring is its first one.
std::string ring_text(const PlanRing& ring) {
  PlanRing closed = ring;
  if (!ring.empty()) closed.push_back(ring.front());
  return list_text(closed, [](const Vec2& place) { return place_text(place); });
}

std::string polygon_text(const PlanPolygon& polygon) {
  std::vector<PlanRing> rings = {polygon.outline};
  rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
  return list_text(rings, ring_text);
}

std::string json_text(const nlohmann::ordered_json& value) {
  return value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// "EPSG:2056" as the specification of 2008 names it.
std::string crs_member(const std::string& crs) {
  if (!crs.starts_with("EPSG:")) return "";
  const nlohmann::ordered_json name = "urn:ogc:def:crs:EPSG::" + crs.substr(5);
  return fmt::format(R"("crs":{{"type":"name","properties":{{"name":{}}}}},)", json_text(name));
}

}  // namespace

std::string geojson_point(const Vec2& place) {
  return fmt::format(R"({{"type":"Point","coordinates":{}}})", place_text(place));
}
std::string geojson_point(const Vec3& place) {
  return fmt::format(R"({{"type":"Point","coordinates":{}}})", place_text(place));
}
std::string geojson_line(std::span<const Vec2> places) { return line_text(places); }
std::string geojson_line(std::span<const Vec3> places) { return line_text(places); }
std::string geojson_region(std::span<const PlanPolygon> polygons) {
  return fmt::format(R"({{"type":"MultiPolygon","coordinates":{}}})", list_text(polygons, polygon_text));
}

GeoJsonFile::GeoJsonFile(const std::filesystem::path& path, const std::string& crs) : file_(path) {
  const nlohmann::ordered_json name = path.stem().string();
  file_.write(fmt::format("{{\"type\":\"FeatureCollection\",\"name\":{},{}\"features\":[", json_text(name),
                          crs_member(crs)));
}

void GeoJsonFile::add(const nlohmann::ordered_json& properties, const std::string& geometry) {
  file_.write(features_++ == 0 ? "\n" : ",\n");
  file_.write(
      fmt::format(R"({{"type":"Feature","properties":{},"geometry":{}}})", json_text(properties), geometry));
}

void GeoJsonFile::commit() {
  file_.write("\n]}\n");
  file_.commit();
}

}  // namespace flyrock
