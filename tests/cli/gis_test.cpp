// What GIS get: the layers of a result in plan, and its coordinate system in all exports.

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "program.h"
#include "rows.h"

using namespace flyrock::test;

namespace gis_test {

namespace {

using nlohmann::json;

/// A hill of 30 x 24 cells of 5 m in national coordinates, which falls towards the east.
std::string hill() {
  std::string text = "ncols 30\nnrows 24\nxllcorner 2600000\nyllcorner 1200000\ncellsize 5\n";
  for (int row = 0; row < 24; ++row)
    for (int column = 0; column < 30; ++column)
      text += std::to_string(60 - 2.5 * column + 0.3 * std::sin(row)) + (column < 29 ? " " : "\n");
  return text;
}

/// A soil map on cells of its own: soil 3 in a ring about a cell of soil 1, and in a cell that touches the
/// ring at a corner.
const char* soil = R"(ncols 5
nrows 4
xllcorner 2600080
yllcorner 1200040
cellsize 10
1 1 1 1 3
1 3 3 3 1
1 3 1 3 1
1 3 3 3 1
)";

const char* meadow =
    R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"use":"meadow"},"geometry":
{"type":"Polygon","coordinates":[[[2600010,1200005],[2600060,1200005],[2600060,1200030],[2600010,1200030],
[2600010,1200005]],[[2600020,1200010],[2600020,1200020],[2600030,1200020],[2600030,1200010],
[2600020,1200010]]]}}]})";

const char* scenario = R"(flyrock: 1
title: all that a map has
dimension: 3
method: lumped_mass
trials: 120
terrain:
  type: raster
  file: hill.asc
  crs: EPSG:2056
  zones:
    - { name: road, polygon: [[2600120, 1200010], [2600130, 1200010], [2600130, 1200110], [2600120, 1200110]] }
    - { name: wet, raster: soil.asc, value: 3 }
    - { name: meadow, geojson: meadow.geojson, property: use, is: meadow }
  material: ground
  materials: { road: ground, wet: ground, meadow: ground }
materials:
  ground: { restitution: { type: newton, en: 0.4 }, friction: { type: coulomb, mu: 0.7 } }
rocks:
  - name: blocks
    density: 2700 kg/m3
    shape: { type: sphere, radius: { uniform: [0.2 m, 0.4 m] } }
    release: { inside: [[2600020, 1200040], [2600030, 1200040], [2600030, 1200080], [2600020, 1200080]], above_ground: 2 m }
    launch: { type: fixed, speed: { uniform: [2 m/s, 9 m/s] }, elevation: 20 deg, azimuth: { normal: { mean: 0 deg, sd: 40 deg } } }
forest: { file: trees.csv }
gates:
  - { name: line, line: [[2600070, 1200020], [2600075, 1200100]] }
  - { name: across, x: 2600090 }
barriers: [{ name: fence, line: [[2600100, 1200020], [2600100, 1200060], [2600105, 1200100]], height: 3 m, capacity: 100 kJ }]
clearance: [{ name: blasting, probability: 0.1, sectors: 4, factor: 2 }]
output: { trajectories: { first: 7 } }
stop: { time: 60 s }
)";

void run_all(const Folder& folder, const std::string& text, const std::string& more = "") {
  folder.write("hill.asc", hill());
  folder.write("soil.asc", soil);
  folder.write("meadow.geojson", meadow);
  folder.write("trees.csv", "x,y,dbh_cm,height_m\n2600060,1200050,30,20\n2600061,1200062,45,25\n");
  folder.write("s.yaml", text);
  const Output ran = call(folder, "run s.yaml -o r --quiet " + more);
  INFO(ran.err);
  REQUIRE(ran.code == 0);
}

json layer(const Folder& folder, const std::string& name) {
  return json::parse(read(folder.path() / "r/geojson" / (name + ".geojson")));
}

double ring_area(const json& ring) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i)
    sum += (ring[i][0].get<double>() - 2600000) * (ring[i + 1][1].get<double>() - 1200000) -
           (ring[i + 1][0].get<double>() - 2600000) * (ring[i][1].get<double>() - 1200000);
  return sum / 2;
}

/// Of a MultiPolygon: outlines count, holes are taken off.
double region_area(const json& geometry) {
  double area = 0;
  for (const json& polygon : geometry["coordinates"])
    for (const json& ring : polygon) {
      CHECK(ring.front() == ring.back());
      area += ring_area(ring);
    }
  return area;
}

std::string without_crs() {
  std::string text = scenario;
  return text.erase(text.find("  crs: EPSG:2056\n"), 17);
}

bool has_ogr() { return std::system("ogr2ogr --version > /dev/null 2>&1") == 0; }

}  // namespace

TEST_CASE("GeoJSON has the rows of the database as layers, in the coordinates of the scenario") {
  const Folder folder;
  run_all(folder, scenario);
  const Output done = call(folder, "export r --to geojson");
  INFO(done.err);
  REQUIRE(done.code == 0);
  CHECK(done.out ==
        "r/geojson/paths-p0.geojson\nr/geojson/ends-p0.geojson\nr/geojson/releases-p0.geojson\n"
        "r/geojson/gates-p0.geojson\nr/geojson/barriers-p0.geojson\nr/geojson/trees-p0.geojson\n"
        "r/geojson/zones-p0.geojson\nr/geojson/area-p0.geojson\n");
  const fs::path db = folder.path() / "r/results.db";
  const std::map<std::string, std::string> counts = {
      {"paths", "SELECT count(*) FROM (SELECT DISTINCT trial, rock FROM trajectories)"},
      {"ends", "SELECT count(*) FROM rocks"},
      {"releases", "SELECT count(*) FROM rocks"},
      {"trees", "SELECT count(*) FROM stems"},
      {"zones", "SELECT count(DISTINCT zone) FROM zones"},
      {"gates", "SELECT 2"},
      {"barriers", "SELECT 1"},
      {"area", "SELECT 2"}};
  for (const auto& [name, sql] : counts) {
    INFO(name);
    const json file = layer(folder, name + "-p0");
    CHECK(std::to_string(file["features"].size()) == query(db, sql)[0]);
    CHECK(file["crs"]["properties"]["name"] == "urn:ogc:def:crs:EPSG::2056");
  }

  const json ends = layer(folder, "ends-p0")["features"];
  const std::vector<std::string> stops = query(
      db, "SELECT printf('%!.15g|%!.15g|%!.15g|%s', stop_x_m, stop_y_m, stop_z_m, stop_reason) FROM rocks");
  REQUIRE(ends.size() == 120);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    double x = 0, y = 0, z = 0;
    REQUIRE(std::sscanf(stops[i].c_str(), "%lf|%lf|%lf", &x, &y, &z) == 3);
    const json& place = ends[i]["geometry"]["coordinates"];
    CHECK(place[0].get<double>() == Approx(x).margin(1e-6));
    CHECK(place[1].get<double>() == Approx(y).margin(1e-6));
    CHECK(place[2].get<double>() == Approx(z).margin(1e-6));
    CHECK(stops[i].ends_with("|" + ends[i]["properties"]["stop_reason"].get<std::string>()));
    CHECK(ends[i]["properties"]["trial"] == i);
  }

  const json first = layer(folder, "paths-p0")["features"][0];
  const json release = layer(folder, "releases-p0")["features"][0];
  CHECK(first["geometry"]["type"] == "LineString");
  const json& begin = first["geometry"]["coordinates"].front();
  CHECK(release["geometry"]["coordinates"][0] == begin[0]);
  CHECK(release["geometry"]["coordinates"][1] == begin[1]);
  CHECK(first["geometry"]["coordinates"].back() == ends[0]["geometry"]["coordinates"]);

  const json gates = layer(folder, "gates-p0")["features"];
  CHECK(gates[0]["properties"]["gate"] == "line");
  CHECK(gates[0]["geometry"]["coordinates"] == json::parse("[[2600070,1200020],[2600075,1200100]]"));
  const json& across = gates[1]["geometry"]["coordinates"];  // over the ground where rocks were
  CHECK(across[0][0] == 2600090);
  CHECK(across[1][0] == 2600090);
  CHECK(across[0][1] < 1200060);
  CHECK(across[1][1] > 1200060);
  const json fence = layer(folder, "barriers-p0")["features"][0];
  CHECK(fence["properties"]["height_m"] == 3);
  CHECK(fence["geometry"]["coordinates"].size() == 3);

  const json zones = layer(folder, "zones-p0")["features"];
  CHECK(zones[0]["properties"]["name"] == "road");
  CHECK(region_area(zones[0]["geometry"]) == Approx(1000));
  CHECK(zones[1]["properties"]["name"] == "wet");
  CHECK(region_area(zones[1]["geometry"]) == Approx(900));  // nine cells of 100 m2
  CHECK(zones[1]["geometry"]["coordinates"].size() == 2);
  CHECK(region_area(zones[2]["geometry"]) == Approx(50 * 25 - 100));

  const json area = layer(folder, "area-p0")["features"];
  CHECK(area[0]["properties"]["limit"] == "area");
  CHECK(area[1]["properties"]["limit"] == "with_factor");
  CHECK(region_area(area[1]["geometry"]) > region_area(area[0]["geometry"]));
  CHECK(region_area(area[0]["geometry"]) > 400);  // more than where the rocks start
}

TEST_CASE("each sweep point has layers of its own, a rock that did not start has no place") {
  const Folder folder;
  std::string text = scenario;
  const std::string above = "above_ground: 2 m";
  text.replace(text.find(above), above.size(), "above_ground: { sweep: [2 m, 3 m] }");
  run_all(folder, text, "--trials 5");
  REQUIRE(call(folder, "export r --to geojson").code == 0);
  for (const char* point : {"-p0", "-p1"}) {
    CHECK(layer(folder, std::string("ends") + point)["features"].size() == 5);
    CHECK(layer(folder, std::string("paths") + point)["features"].size() == 5);
  }
  CHECK(layer(folder, "releases-p0")["features"][0]["geometry"] ==
        layer(folder, "releases-p1")["features"][0]["geometry"]);  // in plan
}

TEST_CASE("without a known system no export names one") {
  const Folder folder;
  run_all(folder, without_crs(), "--trials 5");
  for (const char* format : {"geojson", "asc", "vtk"})
    REQUIRE(call(folder, std::string("export r --to ") + format).code == 0);
  CHECK_FALSE(layer(folder, "ends-p0").contains("crs"));
  CHECK_FALSE(folder.has("r/asc/E_max-p0.vrt"));
  CHECK(read(folder.path() / "r/vtk/ground-p0.vtp").find("FieldData") == std::string::npos);
}

TEST_CASE("grids and VTK name the coordinate system, too") {
  const Folder folder;
  run_all(folder, scenario, "--trials 5");
  for (const char* format : {"asc", "vtk"})
    REQUIRE(call(folder, std::string("export r --to ") + format).code == 0);
  CHECK(read(folder.path() / "r/asc/E_max-p0.vrt").find("<SRS>EPSG:2056</SRS>") != std::string::npos);
  for (const char* file : {"ground-p0.vtp", "trajectories-p0.vtp", "shapes-p0/0000.vtp"})
    CHECK(read(folder.path() / "r/vtk" / file)
              .find("Name=\"crs\" NumberOfTuples=\"1\" format=\"ascii\">\n69 80 83 71 58 50 48 53 54 0\n") !=
          std::string::npos);
}

TEST_CASE("in 2D there is nothing in plan") {
  const Folder folder;
  folder.write("s.yaml", bench);
  REQUIRE(call(folder, "run s.yaml -o r --quiet").code == 0);
  const Output done = call(folder, "export r --to geojson");
  CHECK(done.code == 0);
  CHECK(done.out.empty());
  CHECK(done.err == "nothing written: this result has no places in plan (only runs in 3D do)\n");
}

TEST_CASE("GDAL finds the layers, their counts and the coordinate system of a GeoPackage") {
  const Folder folder;
  run_all(folder, scenario);
  const Output done = call(folder, "export r --to gpkg");
  if (!has_gdal()) {
    CHECK(done.code == 2);
    CHECK(
        done.err ==
        "error: --to gpkg needs GDAL, which this flyrock does not have (Debian: flyrock-gdal); --to geojson "
        "writes the same layers without it\nSee `flyrock export --help`.\n");
    return;
  }
  INFO(done.err);
  REQUIRE(done.code == 0);
  CHECK(done.out == "r/gpkg/results-p0.gpkg\n");
  const std::map<std::string, int> counts = {{"paths", 7},    {"ends", 120}, {"releases", 120}, {"gates", 2},
                                             {"barriers", 1}, {"trees", 2},  {"zones", 3},      {"area", 2}};
  for (const auto& [name, count] : counts) {
    INFO(name);
    const fs::path package = folder.path() / "r/gpkg/results-p0.gpkg";
    CHECK(query(package, "SELECT count(*) FROM " + name).front() == std::to_string(count));
    CHECK(query(package, "SELECT srs_id FROM gpkg_contents WHERE table_name = '" + name + "'").front() ==
          "2056");
  }
  const std::string before = read(folder.path() / "r/gpkg/results-p0.gpkg");
  REQUIRE(call(folder, "export r --to gpkg").code == 0);
  CHECK(read(folder.path() / "r/gpkg/results-p0.gpkg") == before);
  CHECK_FALSE(folder.has("r/gpkg/ends-p0.geojson"));
  REQUIRE(call(folder, "export r --to tif").code == 0);
  CHECK_FALSE(folder.has("r/tif/E_max-p0.vrt"));
  if (!has_ogr()) {
    WARN("SKIPPED: the programs of GDAL are not installed (Debian: gdal-bin)");
    return;
  }
  CHECK(shell(folder, "gdalinfo r/tif/E_max-p0.tif").out.find("ID[\"EPSG\",2056]]\n") != std::string::npos);
  // The grid keeps its cells, and GDAL finds the system beside it.
  REQUIRE(call(folder, "export r --to asc").code == 0);
  CHECK(shell(folder, "gdalinfo r/asc/E_max-p0.vrt").out.find("Size is 30, 24\n") != std::string::npos);
  CHECK(shell(folder, "gdalinfo r/asc/E_max-p0.vrt").out.find("ID[\"EPSG\",2056]]\n") != std::string::npos);
  CHECK(
      shell(folder, "gdalinfo r/asc/E_max-p0.vrt").out.find("Origin = (2600000.000000000000000,1200120.0") !=
      std::string::npos);
}

}  // namespace gis_test
