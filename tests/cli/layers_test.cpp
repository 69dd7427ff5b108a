// Layers of a GIS and of CAD in place of points: the same places in every form.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace flyrock::layers_test {

namespace {

using namespace flyrock::test;
using Json = nlohmann::json;

constexpr const char* soft_points =
    "[[2600020, 1200000], [2600040, 1200000], [2600040, 1200060], [2600020, 1200060]]";
constexpr const char* road_points = "[[2600050, 1200002], [2600052, 1200058]]";
constexpr const char* crest_points = "[[2600004, 1200010], [2600004, 1200050]]";

/// A slope of 80 m by 60 m in Swiss coordinates, and layers or points of its zone, its road and its crest.
std::string scenario(const std::string& soft, const std::string& road, const std::string& crest,
                     const std::string& crs = "crs: EPSG:2056, ") {
  return "flyrock: 1\ndimension: 3\nmethod: lumped_mass\ntrials: 20\n"
         "terrain:\n  { type: mesh, file: slope.obj, " +
         crs + "zones: [{ name: soft, polygon: " + soft +
         " }],\n"
         "    material: rock, materials: { soft: sand } }\n"
         "materials:\n  rock: { restitution: { type: newton, en: 0.5 }, friction: { type: coulomb, mu: 0.4 } "
         "}\n"
         "  sand: { restitution: { type: newton, en: 0.1 }, friction: { type: coulomb, mu: 0.8 } }\n"
         "rocks:\n  - name: loose\n    density: 2700 kg/m3\n    shape: { type: sphere, radius: 0.3 m }\n"
         "    release: { along: " +
         crest +
         ", above_ground: 1 m }\n"
         "    launch: { type: fixed, velocity: [8 m/s, 0 m/s, 0 m/s] }\n"
         "gates: [{ name: road, line: " +
         road + " }]\nstop: { time: 60 s }\n";
}

void write_slope(const Folder& folder) {
  folder.write("slope.obj",
               "v 2600000 1200000 40\nv 2600080 1200000 0\nv 2600080 1200060 0\nv 2600000 1200060 40\nf 1 2 "
               "3\nf 1 3 4\n");
}

std::string closed(const std::string& ring) {
  return ring.substr(0, ring.size() - 1) + "," + ring.substr(1, ring.find(']')) + "]";
}

std::string feature(const char* layer, const char* type, const std::string& coordinates) {
  return fmt::format(
      R"({{"type":"Feature","properties":{{"Layer":"{}","number":{}}},"geometry":{{"type":"{}","coordinates":{}}}}})",
      layer, layer[0] == 's' ? 1 : 2, type, coordinates);
}

void write_site(const Folder& folder) {
  folder.write(
      "site.geojson",
      R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::2056"}},"features":[)" +
          feature("soft", "Polygon", "[" + closed(soft_points) + "]") + "," +
          feature("road", "LineString", road_points) + "," + feature("crest", "LineString", crest_points) +
          "]}");
}

bool has_module() {
  return fs::exists(fs::path(FLYROCK_BINARY).parent_path().parent_path() / "lib/flyrock/flyrock_gdal.so");
}

std::string where(const std::string& file, const char* layer) {
  return "{ layer: " + file + ", where: { Layer: " + layer + " } }";
}

std::vector<std::array<double, 2>> stops_of(const Folder& folder, const std::string& out) {
  REQUIRE(call(folder, "export " + out + " --to geojson -o " + out + "_json").code == 0);
  const Json ends = Json::parse(read(folder.path() / (out + "_json") / "ends-p0.geojson"));
  std::vector<std::array<double, 2>> stops;
  for (const Json& one : ends["features"])
    stops.push_back(
        {one["geometry"]["coordinates"][0].get<double>(), one["geometry"]["coordinates"][1].get<double>()});
  return stops;
}

/// How far the stop places of a scenario are from those with lists of points [m].
double worst_of(const Folder& folder, const std::string& name) {
  const Output run = call(folder, "run " + name + ".yaml --quiet -o " + name);
  INFO(name << ": " << run.err);
  REQUIRE(run.code == 0);
  const auto expected = stops_of(folder, "points"), found = stops_of(folder, name);
  REQUIRE(expected.size() == found.size());
  double worst = 0;
  for (std::size_t i = 0; i < expected.size(); ++i)
    worst = std::max(worst, std::hypot(expected[i][0] - found[i][0], expected[i][1] - found[i][1]));
  return worst;
}

}  // namespace

TEST_CASE("without the module of GDAL each layer is refused in one line with the package and a conversion") {
  if (has_module()) return;
  const Folder folder;
  write_slope(folder);
  for (const std::string ending : {"gpkg", "shp", "kml", "dxf", "geojson"}) {
    folder.write("site." + ending, "x");
    folder.write("s.yaml", scenario("{ layer: site." + ending + " }", road_points, crest_points));
    const Output check = call(folder, "check s.yaml");
    INFO(check.err);
    CHECK(check.code == 2);
    CHECK(check.err.find("install its package flyrock-gdal") != std::string::npos);
    CHECK(check.err.find("ogr2ogr -t_srs EPSG:NUMBER layer.geojson site." + ending) != std::string::npos);
  }
}

TEST_CASE(
    "zones, releases and gates stop the same rocks at the same places, whatever the form of their layer") {
  if (!has_module()) return;
  const Folder folder;
  write_slope(folder);
  write_site(folder);
  folder.write("points.yaml", scenario(soft_points, road_points, crest_points));
  REQUIRE(call(folder, "run points.yaml --quiet -o points").code == 0);
  constexpr double same = 1e-6;
  folder.write("geojson.yaml", scenario(where("site.geojson", "soft"), where("site.geojson", "road"),
                                        where("site.geojson", "crest")));
  CHECK(worst_of(folder, "geojson") < same);
  if (shell(folder, "ogr2ogr --version").code != 0) return;
  const auto made = [&](const std::string& words) {
    const Output output = shell(folder, "ogr2ogr " + words);
    INFO(words << output.err);
    REQUIRE(output.code == 0);
  };
  made("-f GPKG site.gpkg site.geojson");
  folder.write("gpkg.yaml",
               scenario(where("site.gpkg", "soft"), where("site.gpkg", "road"), where("site.gpkg", "crest")));
  CHECK(worst_of(folder, "gpkg") < same);
  for (const std::string kind : {"soft", "road", "crest"})
    made(kind + ".shp site.geojson -where \"Layer='" + kind + "'\"");
  folder.write("shp.yaml", scenario("{ layer: soft.shp }", "{ layer: road.shp, where: { number: 2 } }",
                                    "{ layer: crest.shp }"));
  CHECK(worst_of(folder, "shp") < same);
  CHECK(read(folder.path() / "shp/manifest.json").find("\"road.dbf\"") != std::string::npos);
  made("-f DXF site.dxf site.geojson -select Layer --config DXF_WRITE_HATCH NO");
  folder.write("dxf.yaml", scenario("{ layer: site.dxf, name: soft }", "{ layer: site.dxf, name: road }",
                                    "{ layer: site.dxf, name: crest }"));
  CHECK(worst_of(folder, "dxf") < same);
  for (const std::string kind : {"soft", "road", "crest"})
    made("-f KML -t_srs EPSG:4326 " + kind + ".kml site.geojson -where \"Layer='" + kind + "'\"");
  folder.write("kml.yaml", scenario("{ layer: soft.kml }", "{ layer: road.kml }", "{ layer: crest.kml }"));
  CHECK(worst_of(folder, "kml") < 1e-2);  // degrees, and back
  const Output check = call(folder, "check kml.yaml");
  CHECK(check.out.find("EPSG:4326 made EPSG:2056") != std::string::npos);
}

TEST_CASE("a layer that fits not says why, and what to write") {
  if (!has_module()) return;
  const Folder folder;
  write_slope(folder);
  write_site(folder);
  const auto said = [&](const std::string& soft, const std::string& crs = "crs: EPSG:2056, ") {
    folder.write("s.yaml", scenario(soft, road_points, crest_points, crs));
    const Output check = call(folder, "check s.yaml");
    CHECK(check.code == 2);
    return check.err;
  };
  const auto has = [](const std::string& text, const std::string& piece) {
    INFO(text);
    CHECK(text.find(piece) != std::string::npos);
  };
  has(said(where("site.geojson", "sofd")), "has no feature whose `Layer` is `sofd`, did you mean `soft`?");
  has(said("{ layer: site.geojson, where: { layer: soft } }"),
      "has no attribute `layer`, did you mean `Layer`?");
  has(said(where("site.geojson", "road")), "has an open line, expected polygons");
  has(said("{ layer: site.geojson, name: zones }"), "has no layer `zones`, it has `site`");
  has(said(where("site.geojson", "soft"), ""),
      "is in EPSG:2056, the terrain does not say its system: write `crs: EPSG:NUMBER`");
  has(said("{ layer: none.gpkg }"), "there is no file `none.gpkg`");
  folder.write("cut.gpkg", "SQLite format 3");
  has(said("{ layer: cut.gpkg }"), "is no file of layers that can be read");
  folder.write("s.yaml", scenario(soft_points, "{ layer: site.geojson }", crest_points));
  has(call(folder, "check s.yaml").err,
      "has 3 parts of these features, expected one line: `where` chooses it by an attribute");
}

TEST_CASE("a profile is cut along a line with heights") {
  if (!has_module()) return;
  const Folder folder;
  folder.write(
      "line.geojson",
      R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::2056"}},"features":[)"
      R"({"type":"Feature","properties":{},"geometry":{"type":"LineString","coordinates":[[2600000,1200000,30],[2600003,1200004,20],[2600063,1200084,0]]}}]})");
  folder.write("s.yaml",
               "flyrock: 1\ndimension: 2\nmethod: ballistic\nterrain: { type: profile, points: { layer: "
               "line.geojson } }\n"
               "rocks:\n  - { name: a, density: 2700, shape: { type: disk, radius: 0.1 }, release: { "
               "position: [1, 40] }, "
               "launch: { type: fixed, velocity: [5, 0] } }\nstop: { time: 60 s }\n");
  const Output run = call(folder, "run s.yaml --quiet -o out");
  INFO(run.err);
  REQUIRE(run.code == 0);
  REQUIRE(call(folder, "export out --to csv -o tables").code == 0);
  const std::string ground = read(folder.path() / "tables/ground.csv");
  CHECK(ground.find("0,0,30") != std::string::npos);
  CHECK(ground.find("0,5,20") != std::string::npos);
  CHECK(ground.find("0,105,0") != std::string::npos);
}

}  // namespace flyrock::layers_test
