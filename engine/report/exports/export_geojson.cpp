#include "report/exports/export_geojson.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "report/exports/area_outline.h"
#include "report/exports/geojson_file.h"
#include "report/tables/database.h"
#include "report/tables/sqlite.h"
#include "report/tables/stored_paths.h"
#include "report/tables/stored_scene.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

Json value_of(const Query& row, int column) {
  switch (row.type(column)) {
    case SQLITE_INTEGER:
      return row.whole(column);
    case SQLITE_FLOAT:
      return row.real(column);
    case SQLITE_TEXT:
      return row.text(column);
    default:
      return nullptr;
  }
}

/// The columns from one on, without the point, which is in the name of the file.
Json properties_of(const Query& row, int from = 0) {
  Json properties = Json::object();
  for (int c = from; c < row.columns(); ++c)
    if (row.name(c) != "point") properties[row.name(c)] = value_of(row, c);
  return properties;
}

/// The texts and numbers of an entry of summary.json, without its lists and groups.
Json scalars_of(const Json& entry) {
  Json scalars = Json::object();
  for (const auto& [key, value] : entry.items())
    if (value.is_primitive()) scalars[key] = value;
  return scalars;
}

Vec2 place_of(const Json& pair) { return {pair.at(0).get<double>(), pair.at(1).get<double>()}; }

std::vector<Vec2> places_of(const Json& list) {
  std::vector<Vec2> places;
  for (const Json& pair : list) places.push_back(place_of(pair));
  return places;
}

/// The layers of one sweep point.
class Layers {
 public:
  Layers(const SqliteReader& database, std::int64_t point, const Json& summary,
         const std::vector<StoredPath>& paths)
      : database_(database), point_(point), summary_(summary), paths_(paths) {}

  void add_paths(GeoJsonFile& file) const {
    for (const StoredPath& path : paths_) {
      Query rock(database_, fmt::format("SELECT * FROM rocks WHERE point = {} AND trial = {} AND rock = {}",
                                        path.point, path.trial, path.rock));
      if (!rock.next()) continue;
      std::vector<Vec3> places;
      for (const StoredMoment& moment : path.moments) places.push_back(moment.place);
      file.add(properties_of(rock), geojson_line(places));
    }
  }

  void add_ends(GeoJsonFile& file) const {
    Query rock(database_, rows_of("stop_x_m, stop_y_m, stop_z_m, rocks.*", "rocks"));
    while (rock.next()) {
      const Json properties = properties_of(rock, 3);
      const bool has_place = has_started(properties) && rock.type(0) != SQLITE_NULL;
      file.add(properties,
               has_place ? geojson_point(Vec3(rock.real(0), rock.real(1), rock.real(2))) : "null");
    }
  }

  void add_releases(GeoJsonFile& file) const {
    Query rock(database_, rows_of("start_x_m, start_y_m, trial, rock, \"group\", mass_kg, launch_speed_m_s, "
                                  "launch_elevation_deg, stop_reason",
                                  "rocks"));
    while (rock.next()) {
      const Json properties = properties_of(rock, 2);
      const bool has_place = has_started(properties) && rock.type(0) != SQLITE_NULL;
      file.add(properties, has_place ? geojson_point(Vec2(rock.real(0), rock.real(1))) : "null");
    }
  }

  void add_trees(GeoJsonFile& file) const {
    Query stem(database_, rows_of("x_m, y_m, stems.*", "stems"));
    while (stem.next()) file.add(properties_of(stem, 2), geojson_point(Vec2(stem.real(0), stem.real(1))));
  }

  void add_gates(GeoJsonFile& file) const { add_lines(file, "gates"); }
  void add_barriers(GeoJsonFile& file) const { add_lines(file, "barriers"); }

  void add_zones(GeoJsonFile& file) const {
    Query corner(database_, rows_of("zone, name, polygon, ring, x_m, y_m", "zones"));
    Json properties;
    std::vector<PlanPolygon> region;
    const auto finish = [&] {
      if (!region.empty()) file.add(properties, geojson_region(region));
      region.clear();
    };
    std::int64_t polygon = -1, ring = -1;
    while (corner.next()) {
      if (region.empty() || properties["zone"] != corner.whole(0)) {
        finish();
        properties = {{"zone", corner.whole(0)}, {"name", corner.text(1)}};
        polygon = -1;
      }
      if (polygon != corner.whole(2)) {
        polygon = corner.whole(2);
        ring = 0;
        region.emplace_back();
      }
      if (ring != corner.whole(3)) {
        ring = corner.whole(3);
        region.back().holes.emplace_back();
      }
      PlanRing& corners = region.back().holes.empty() ? region.back().outline : region.back().holes.back();
      corners.emplace_back(corner.real(4), corner.real(5));
    }
    finish();
  }

  void add_area(GeoJsonFile& file) const {
    for (const Json& clearance : summary_.at("clearance")) {
      add_least_area(clearance, file);
      const auto area = clearance.find("area");
      if (area == clearance.end() || area->at("beyond").is_null()) continue;
      for (const auto& [limit, key] :
           {std::pair("area", "distance"), std::pair("with_factor", "with_factor")})
        if (const PlanRing ring = outline_of(*area, key); ring.size() > 2) {
          Json properties = scalars_of(clearance);
          properties["limit"] = limit;
          file.add(properties, geojson_region(std::vector{PlanPolygon{ring, {}}}));
        }
    }
  }

 private:
  static void add_least_area(const Json& clearance, GeoJsonFile& file) {
    const auto area = clearance.find("area_least");
    if (area == clearance.end() || area->at("polygons").empty()) return;
    std::vector<PlanPolygon> region;
    for (const Json& polygon : area->at("polygons")) region.push_back({places_of(polygon), {}});
    Json properties = scalars_of(clearance);
    properties["limit"] = "area_least";
    properties["hectares"] = area->at("hectares");
    file.add(properties, geojson_region(region));
  }

  std::string rows_of(const char* columns, const char* table) const {
    return fmt::format("SELECT {} FROM {} WHERE point = {} ORDER BY {}.rowid", columns, table, point_, table);
  }

  static bool has_started(const Json& rock) { return rock.value("stop_reason", Json()) != "not_started"; }

  void add_lines(GeoJsonFile& file, const char* kind) const {
    for (const Json& entry : summary_.at(kind)) {
      const Json& line = entry.at("line");
      file.add(scalars_of(entry),
               geojson_line(line.is_null() ? line_at(entry.at("x").get<double>()) : places_of(line)));
    }
  }

  /// Across the ground where rocks were.
  std::vector<Vec2> line_at(double x) const {
    const std::optional<std::int64_t> ground = stored_ground(database_, point_);
    Query extent(
        database_,
        ground ? fmt::format("SELECT min(y_m), max(y_m) FROM ground_vertices WHERE ground = {}", *ground)
               : fmt::format("SELECT min(stop_y_m), max(stop_y_m) FROM rocks WHERE point = {}", point_));
    extent.next();
    return {{x, extent.real(0)}, {x, extent.real(1)}};
  }

  /// Empty where the sectors have no such distance.
  static PlanRing outline_of(const Json& area, const char* distance) {
    std::vector<AreaSector> sectors;
    for (const Json& sector : area.at("sectors")) {
      if (sector.at(distance).is_null()) return {};
      sectors.push_back(
          {sector.at("azimuth_deg").get<double>() * pi / 180, sector.at(distance).get<double>()});
    }
    return area_outline({area.at("x").get<double>(), area.at("y").get<double>()}, places_of(area.at("hull")),
                        sectors);
  }

  const SqliteReader& database_;
  std::int64_t point_;
  const Json& summary_;
  const std::vector<StoredPath>& paths_;
};

struct Layer {
  const char* name;
  void (Layers::*add)(GeoJsonFile&) const;
};

constexpr Layer all_layers[] = {{"paths", &Layers::add_paths},       {"ends", &Layers::add_ends},
                                {"releases", &Layers::add_releases}, {"gates", &Layers::add_gates},
                                {"barriers", &Layers::add_barriers}, {"trees", &Layers::add_trees},
                                {"zones", &Layers::add_zones},       {"area", &Layers::add_area}};

std::vector<fs::path> write_layers(const SqliteReader& database, const Json& summary,
                                   const fs::path& folder) {
  std::vector<fs::path> files;
  StoredPaths stored(database);
  std::vector<StoredPath> paths = stored.next_point();
  const std::string crs = summary.value("crs", std::string());
  const Json& points = summary.at("points");
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto point = static_cast<std::int64_t>(p);
    const bool has_paths = !paths.empty() && paths.front().point == point;
    const std::vector<StoredPath> here = has_paths ? std::exchange(paths, {}) : std::vector<StoredPath>();
    const Layers layers(database, point, points[p], here);
    for (const auto& [name, add] : all_layers) {
      const fs::path path = folder / fmt::format("{}-p{}.geojson", name, p);
      GeoJsonFile file(path, crs);
      (layers.*add)(file);
      if (file.features() == 0) continue;
      file.commit();
      files.push_back(path);
    }
    if (has_paths) paths = stored.next_point();
  }
  return files;
}

}  // namespace

std::vector<fs::path> export_geojson(const fs::path& results, const fs::path& folder) try {
  const SqliteReader database(results);
  const Json summary = Json::parse(stored_report(results)).at("summary");
  if (summary.at("dimension") != 3) return {};
  make_folder(folder);
  return write_layers(database, summary, folder);
} catch (const nlohmann::json::exception&) {
  throw UnreadableFile(
      fmt::format("{} is damaged: the data of its report are not those of a result", results.string()));
}

}  // namespace flyrock
