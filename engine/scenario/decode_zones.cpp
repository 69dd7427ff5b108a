// Zones and faces of the terrain, and its origin.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/off_terrain.h"
#include "plugin/params.h"
#include "scenario/decode_sections.h"
#include "scenario/layer.h"
#include "scenario/normalise.h"
#include "survey/geojson_zone.h"
#include "survey/raster_file.h"

namespace flyrock {

namespace {

std::vector<PlanPolygon> read_geojson(DecodeContext& context, const Node& item, const Section& section) {
  if (section.given("property") != section.given("is")) {
    item.error(context.diagnostics,
               "`property` and `is` belong together: the features whose property has the value");
    return {};
  }
  if (section.text("geojson").empty()) return {};  // already reported
  FeatureFilter filter;
  if (section.given("property")) filter = {section.text("property"), section.text("is")};
  try {
    return read_polygons(section.text("geojson"), filter);
  } catch (const PluginError& error) {
    item.find("geojson")->error(context.diagnostics, error.what());
    return {};
  }
}

void read_zone_3d(DecodeContext& context, const Node& item, const Section& section, const std::string& kind,
                  const std::vector<std::string>& parts, Zone& zone) {
  if (const Node polygon = *item.find(kind); kind == "polygon" && is_layer(*polygon.value))
    zone.polygons = layer_region(context, polygon);
  else if (kind == "polygon")
    for (const Vec3& corner : section.points("polygon")) zone.polygon.emplace_back(corner.x(), corner.y());
  if (kind == "geojson") zone.polygons = read_geojson(context, item, section);
  if (kind == "raster") {
    zone.raster = read_raster(context, *item.find("raster"), section, "raster");
    zone.value = section.constant("value");
  }
  if (kind == "group") {
    zone.group = section.text("group");
    std::vector<std::string> names = parts;
    std::erase(names, "");
    if (!parts.empty() && std::find(names.begin(), names.end(), zone.group) == names.end())
      item.find("group")->error(context.diagnostics,
                                fmt::format("the terrain has no part `{}`{}", zone.group,
                                            names.empty() ? "" : suggestion(zone.group, names)));
  }
}

std::vector<Zone> decode_zones(DecodeContext& context, const Node& node, std::vector<std::string> parts) {
  const bool space = context.dimension == 3;
  const std::vector<Zone> zones = decode_list<Zone>(node, [&](const Node& item) {
    const std::optional<Node> key = space ? key_of_zone(item) : std::nullopt;
    const Section section = decode_section(context, item, section_of_zone(key));
    Zone zone;
    zone.name = section.text("name");
    if (key) {
      read_zone_3d(context, item, section, key->key, parts, zone);
    } else {
      zone.from = section.constant("from");
      zone.to = section.constant("to");
      if (section.given("from") && section.given("to") && !(zone.from < zone.to))
        item.error(context.diagnostics, "`from` must be less than `to`");
    }
    parts.push_back(zone.name);
    return zone;
  });
  constexpr std::size_t most_parts = 255;  // a cell of a grid keeps the number of its part in a byte
  if (space && parts.size() > most_parts)
    node.error(context.diagnostics,
               fmt::format("the terrain has {} parts, expected at most {}", parts.size(), most_parts));
  return zones;
}

std::vector<FacePlan> decode_faces(DecodeContext& context, const Node& node, const DecodedTerrain& terrain) {
  const bool space = context.dimension == 3;
  return decode_list<FacePlan>(node, [&](const Node& item) {
    const Section section = decode_section(context, item, space ? "terrain.faces 3D" : "terrain.faces");
    FacePlan face;
    face.name = section.text("name");
    if (std::find(terrain.faces.begin(), terrain.faces.end(), face.name) != terrain.faces.end())
      item.error(context.diagnostics, fmt::format("the terrain has a face `{}` of its own", face.name));
    if (space) {
      face.zone = section.text("zone");
      std::vector<std::string> zones;
      for (const Zone& zone : terrain.plan.zones) zones.push_back(zone.name);
      if (section.given("zone") && std::find(zones.begin(), zones.end(), face.zone) == zones.end())
        item.find("zone")->error(context.diagnostics, fmt::format("there is no zone `{}`{}", face.zone,
                                                                  suggestion(face.zone, zones)));
      return face;
    }
    face.from = section.constant("from");
    face.to = section.constant("to");
    const auto is_outside = [&](double x) {
      return terrain.profile && !(x >= terrain.profile->x_min() && x <= terrain.profile->x_max());
    };
    for (const char* key : {"from", "to"})
      if (section.given(key) && is_outside(section.constant(key)))
        item.find(key)->error(
            context.diagnostics,
            off_terrain(section.constant(key), terrain.profile->x_min(), terrain.profile->x_max()));
    const bool has_ends = section.given("from") && section.given("to");
    if (has_ends && face.from == face.to)
      item.error(context.diagnostics, "`from` and `to` are the same place");
    return face;
  });
}

void decode_origin(DecodeContext& context, const Node& node, TerrainPlan& plan) {
  const Section section = decode_section(context, node, "terrain 3D");
  const std::vector<Number>& numbers = section.vector("origin");
  for (std::size_t k = 0; k < numbers.size() && k < 3; ++k) {
    plan.origin[static_cast<int>(k)] = numbers[k].constant;
    if (numbers[k].constant != std::floor(numbers[k].constant))
      return node.find("origin")->error(context.diagnostics, "expected whole metres");
  }
}

/// That of the scenario, which must be that of the file if both are given.
void decode_crs(DecodeContext& context, const Node& node, DecodedTerrain& terrain) {
  terrain.plan.crs = terrain.crs_of_file;
  const std::optional<Node> key = node.find("crs");
  if (!key) return;
  const std::string crs = decode_section(context, node, "terrain 3D").text("crs");
  const bool is_epsg = crs.starts_with("EPSG:") && crs.size() > 5 && crs.size() <= 11 &&
                       crs.find_first_not_of("0123456789", 5) == crs.npos;
  if (!is_epsg)
    return key->error(context.diagnostics,
                      fmt::format("expected EPSG:n, such as EPSG:2056, found `{}`", crs));
  if (terrain.is_converted)
    return context.diagnostics.warning(
        key->key_at, key->path,
        fmt::format(
            "is {}, a system of the file, whose coordinates `plan_unit` makes metres: maps and exports "
            "carry no code",
            crs));
  if (!terrain.crs_of_file.empty() && terrain.crs_of_file != crs)
    key->error(context.diagnostics, fmt::format("is {}, the file says {}: leave it out, or project the file",
                                                crs, terrain.crs_of_file));
  terrain.plan.crs = crs;
}

}  // namespace

std::shared_ptr<const HeightGrid> read_raster(DecodeContext& context, const Node& node,
                                              const Section& section, const char* key) {
  const std::string& path = section.text(key);
  if (path.empty()) return nullptr;  // already reported
  try {
    return std::make_shared<const HeightGrid>(read_raster_file("raster", path, {}).grid);
  } catch (const PluginError& error) {
    node.error(context.diagnostics, error.what());
    return nullptr;
  }
}

void decode_places_of_terrain(DecodeContext& context, const Node& node, DecodedTerrain& terrain) {
  decode_crs(context, node, terrain);
  context.crs = terrain.plan.crs;
  if (const auto zones = node.find("zones"))
    terrain.plan.zones = decode_zones(context, *zones, terrain.parts);
  if (const auto faces = node.find("faces")) {
    terrain.plan.faces = decode_faces(context, *faces, terrain);
    for (const FacePlan& face : terrain.plan.faces) terrain.faces.push_back(face.name);
  }
  if (context.dimension == 3) {
    terrain.plan.origin = terrain.automatic_origin;
    if (node.find("origin")) decode_origin(context, node, terrain.plan);
  }
  terrain.plan.survey = terrain.survey;
}

}  // namespace flyrock
