// Layers of a GIS and of CAD in place of points: the same places in every form.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

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

/// The corners of the slope.
constexpr const char* slope_corners[] = {"2600000 1200000 40", "2600080 1200000 0", "2600080 1200060 0",
                                         "2600000 1200060 40"};

/// x, y and z of a corner of the slope as groups of a DXF file: 10, 20 and 30 of the first corner.
std::string dxf_place(int corner, int of_entity) {
  std::istringstream words(slope_corners[corner]);
  std::string text, number;
  for (int code = 10 + of_entity; words >> number; code += 10) text += fmt::format("{}\n{}\n", code, number);
  return text;
}

std::string face_3d(const std::string& layer, const std::array<int, 4>& corners) {
  std::string text = "0\n3DFACE\n8\n" + layer + "\n";
  for (int i = 0; i < 4; ++i) text += dxf_place(corners[static_cast<std::size_t>(i)], i);
  return text;
}

/// A polyface mesh of the slope; a negative corner begins an edge that is not drawn.
std::string polyface(const std::string& layer, const std::vector<std::array<int, 3>>& faces) {
  std::string text = fmt::format("0\nPOLYLINE\n8\n{}\n66\n1\n10\n0\n20\n0\n30\n0\n70\n64\n71\n4\n72\n{}\n",
                                 layer, faces.size());
  for (int corner = 0; corner < 4; ++corner)
    text += fmt::format("0\nVERTEX\n8\n{}\n{}70\n192\n", layer, dxf_place(corner, 0));
  for (const auto& face : faces)
    text += fmt::format("0\nVERTEX\n8\n{}\n10\n0\n20\n0\n30\n0\n70\n128\n71\n{}\n72\n{}\n73\n{}\n", layer,
                        face[0], face[1], face[2]);
  return text + fmt::format("0\nSEQEND\n8\n{}\n", layer);
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

/// What `check` says of a scenario that it refuses.
std::string refusal_of(const Folder& folder, const std::string& text) {
  folder.write("s.yaml", text);
  const Output check = call(folder, "check s.yaml");
  CHECK(check.code == 2);
  return check.err;
}

void has(const std::string& text, const std::string& piece) {
  INFO(text);
  CHECK(text.find(piece) != std::string::npos);
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
  if (has_gdal()) return;
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
  // One fault is one error.
  const std::string of_release =
      refusal_of(folder, scenario(soft_points, road_points, "{ layer: site.gpkg }"));
  CHECK(of_release.find("at least two points") == std::string::npos);
}

TEST_CASE("without the module of GDAL a drawing as terrain is refused with the package and a conversion") {
  if (has_gdal()) return;
  const Folder folder;
  folder.write("pit.dxf", "0\nEOF\n");
  std::string text = scenario(soft_points, road_points, crest_points);
  text.replace(text.find("slope.obj"), 9, "pit.dxf");
  folder.write("s.yaml", text);
  const Output check = call(folder, "check s.yaml");
  INFO(check.err);
  CHECK(check.code == 2);
  CHECK(check.err.find("install its package flyrock-gdal") != std::string::npos);
  CHECK(check.err.find("export its triangulation (3D faces) as OBJ") != std::string::npos);
}

TEST_CASE(
    "zones, releases and gates stop the same rocks at the same places, whatever the form of their layer") {
  if (skips_without_gdal()) return;
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

TEST_CASE("layers by the conventions of 40 formats and options stop the same rocks at the same places",
          "[heavy]") {
  const Folder folder;
  if (skips_without_gdal()) return;
  if (shell(folder, "ogr2ogr --version").code != 0) {
    std::cout << "SKIPPED: ogr2ogr is not installed (Debian: gdal-bin)\n";
    return;
  }
  constexpr double same = 1e-6, through_degrees = 1e-2, rounded = 5e-2;  // m
  const struct {
    std::string driver, ending, options;
    double within;
  } forms[] = {
      {"GPKG", "gpkg", "-dsco VERSION=1.0", same},
      {"GPKG", "gpkg", "-dsco VERSION=1.1", same},
      {"GPKG", "gpkg", "-dsco VERSION=1.2", same},
      {"GPKG", "gpkg", "-dsco VERSION=1.3", same},
      {"GPKG", "gpkg", "-lco SPATIAL_INDEX=NO", same},
      {"GPKG", "gpkg", "-lco GEOMETRY_NAME=the_geom -lco FID=ogc_fid", same},
      {"GPKG", "gpkg", "-nlt PROMOTE_TO_MULTI", same},
      {"GPKG", "gpkg", "-nlt CONVERT_TO_CURVE", same},
      {"GPKG", "gpkg", "-dim XYZ", same},
      {"GPKG", "gpkg", "-dim XYM", same},
      {"GPKG", "gpkg", "-dim XYZM", same},
      {"GPKG", "gpkg", "-t_srs EPSG:4326", through_degrees},
      {"GPKG", "gpkg", "-t_srs EPSG:4258", through_degrees},
      {"GPKG", "gpkg", "-t_srs EPSG:21781", through_degrees},
      {"GPKG", "gpkg", "-t_srs EPSG:32632", through_degrees},
      {"GPKG", "gpkg", "-t_srs EPSG:3857", through_degrees},
      {"SQLite", "sqlite", "", same},
      {"SQLite", "db", "-dsco SPATIALITE=YES", same},
      {"ESRI Shapefile", "shp", "", same},
      {"ESRI Shapefile", "shp", "-lco ENCODING=CP1252", same},
      {"ESRI Shapefile", "shp", "-lco SPATIAL_INDEX=YES", same},
      {"ESRI Shapefile", "shp", "-nlt PROMOTE_TO_MULTI -dim XYZ", same},
      {"ESRI Shapefile", "shp", "-t_srs EPSG:4326", through_degrees},
      {"KML", "kml", "-t_srs EPSG:4326", through_degrees},
      {"LIBKML", "kml", "-t_srs EPSG:4326", through_degrees},
      {"LIBKML", "kmz", "-t_srs EPSG:4326", through_degrees},
      {"GeoJSON", "geojson", "", same},
      {"GeoJSON", "json", "", same},
      {"GeoJSON", "geojson", "-lco COORDINATE_PRECISION=3", same},
      {"GeoJSON", "geojson", "-lco RFC7946=YES -t_srs EPSG:4326", through_degrees},
      {"GeoJSON", "geojson", "-lco WRITE_BBOX=YES", same},
      {"GeoJSONSeq", "geojsonl", "-t_srs EPSG:4326", through_degrees},
      {"GML", "gml", "", same},
      {"GML", "gml", "-t_srs EPSG:4326 -dsco FORMAT=GML3.2", through_degrees},
      {"FlatGeobuf", "fgb", "", same},
      {"FlatGeobuf", "fgb", "-lco SPATIAL_INDEX=NO", same},
      {"MapInfo File", "tab", "", rounded},
      {"MapInfo File", "mif", "", same},
      {"CSV", "csv", "-lco GEOMETRY=AS_WKT", same},
      {"OGR_GMT", "gmt", "", same},
      {"JML", "jml", "", same},
      {"GeoRSS", "xml", "-t_srs EPSG:4326", through_degrees},
  };
  write_slope(folder);
  write_site(folder);
  folder.write("points.yaml", scenario(soft_points, road_points, crest_points));
  REQUIRE(call(folder, "run points.yaml --quiet -o points").code == 0);
  int number = 0;
  for (const auto& form : forms) {
    const std::string name = fmt::format("form{}", ++number);
    INFO(form.driver << " " << form.options);
    for (const std::string kind : {"soft", "road", "crest"}) {
      const Output made =
          shell(folder, fmt::format("ogr2ogr -f '{}' {} {}_{}.{} site.geojson -where \"Layer='{}'\"",
                                    form.driver, form.options, name, kind, form.ending, kind));
      INFO(made.err);
      REQUIRE(made.code == 0);
    }
    const auto layer = [&](const char* kind) {
      return fmt::format("{{ layer: {}_{}.{} }}", name, kind, form.ending);
    };
    folder.write(name + ".yaml", scenario(layer("soft"), layer("road"), layer("crest")));
    CHECK(worst_of(folder, name) < form.within);
  }
}

TEST_CASE("3D faces of a drawing are the ground of the same mesh, in whatever order their corners are") {
  if (skips_without_gdal()) return;
  const Folder folder;
  write_slope(folder);
  const std::string points = scenario(soft_points, road_points, crest_points);
  folder.write("points.yaml", points);
  REQUIRE(call(folder, "run points.yaml --quiet -o points").code == 0);
  const auto run_drawing = [&](const std::string& name, const std::string& entities,
                               const std::string& keys = "") {
    folder.write(name + ".dxf", "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n");
    std::string text = points;
    text.replace(text.find("slope.obj"), 9, name + ".dxf" + keys);
    folder.write(name + ".yaml", text);
    return worst_of(folder, name);
  };
  CHECK(run_drawing("faces", face_3d("PIT", {0, 1, 2, 2}) + face_3d("PIT", {0, 3, 2, 2})) < 1e-9);
  CHECK(run_drawing("quad", face_3d("PIT", {3, 2, 1, 0})) < 1e-9);
  CHECK(run_drawing("polyface", polyface("PIT", {{1, -3, 2}, {-1, 3, 4}})) < 1e-9);
  const std::string below =
      "0\n3DFACE\n8\nOLD\n10\n0\n20\n0\n30\n0\n11\n1\n21\n0\n31\n0\n12\n0\n22\n1\n32\n0\n13\n0\n23\n1\n33\n0"
      "\n";
  CHECK(run_drawing("layers", below + face_3d("PIT", {0, 1, 2, 3}), ", surface: PIT") < 1e-9);
}

TEST_CASE(
    "of a drawing, labels and sheets of paper are no places, and names of layers are UTF-8 since 2007") {
  if (skips_without_gdal()) return;
  const Folder folder;
  write_slope(folder);
  const auto polyline = [](const std::string& layer, const std::string& more = "") {
    std::string text =
        "0\nLWPOLYLINE\n100\nAcDbEntity\n8\n" + layer + "\n" + more + "100\nAcDbPolyline\n90\n4\n70\n1\n";
    for (const char* place : {"2600020 1200000", "2600040 1200000", "2600040 1200060", "2600020 1200060"}) {
      const std::string words = place;
      text += "10\n" + words.substr(0, 7) + "\n20\n" + words.substr(8) + "\n";
    }
    return text;
  };
  const std::string layer = "B\xc3\xb6schung",
                    label = "0\nTEXT\n8\n" + layer + "\n10\n2600030\n20\n1200030\n30\n0\n40\n1\n1\nsoft\n";
  folder.write("site.dxf",
               "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1024\n9\n$DWGCODEPAGE\n3\nANSI_1252\n0\nENDSEC\n"
               "0\nSECTION\n2\nENTITIES\n" +
                   polyline(layer) + label + polyline(layer, "67\n1\n") + "0\nENDSEC\n0\nEOF\n");
  folder.write("points.yaml", scenario(soft_points, road_points, crest_points));
  REQUIRE(call(folder, "run points.yaml --quiet -o points").code == 0);
  folder.write("dxf.yaml", scenario("{ layer: site.dxf, name: " + layer + " }", road_points, crest_points));
  CHECK(worst_of(folder, "dxf") < 1e-9);
  const Output check = call(folder, "check dxf.yaml");
  has(check.out, ": 1 polygon, no system of its own");
}

TEST_CASE("a drawing without 3D faces, or without a layer, says so, and other entities are counted") {
  if (skips_without_gdal()) return;
  const Folder folder;
  const std::string line = "0\nLINE\n8\nROAD\n10\n0\n20\n0\n30\n0\n11\n1\n21\n1\n31\n1\n";
  const struct {
    std::string entities, keys;
    int code;
    std::string expected;
  } cases[] = {
      {line, "", 2, "has no 3D faces, expected entities 3DFACE or a polyface mesh"},
      {face_3d("PIT", {0, 1, 2, 3}), ", surface: PITT", 2, "has no layer `PITT`, it has `PIT`"},
      {line + face_3d("PIT", {0, 1, 2, 3}), "", 0, "1 of its entities are no 3D faces and were left out"},
  };
  for (const auto& one : cases) {
    folder.write("pit.dxf", "0\nSECTION\n2\nENTITIES\n" + one.entities + "0\nENDSEC\n0\nEOF\n");
    std::string text = scenario(soft_points, road_points, crest_points);
    text.replace(text.find("slope.obj"), 9, "pit.dxf" + one.keys);
    folder.write("s.yaml", text);
    const Output check = call(folder, "check s.yaml");
    INFO(check.err);
    CHECK(check.code == one.code);
    CHECK(check.err.find(one.expected) != std::string::npos);
  }
}

TEST_CASE("each value of an attribute is a zone or a gate of its own") {
  if (skips_without_gdal()) return;
  const Folder folder;
  write_slope(folder);
  write_site(folder);
  const std::string near = "[[2600010, 1200000], [2600010, 1200060]]",
                    far = "[[2600016, 1200000], [2600015, 1200060]]";
  folder.write(
      "lines.geojson",
      R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::2056"}},"features":[)" +
          feature("near", "LineString", near) + "," + feature("far", "LineString", far) + "," +
          feature("soft", "Point", "[2600010, 1200000]") + "]}");
  const auto with_gates = [&](const std::string& gates, const std::string& zones) {
    std::string text = scenario(soft_points, road_points, crest_points);
    text.replace(text.find("gates:"), text.find("stop:") - text.find("gates:"), "gates: [" + gates + "]\n");
    const std::size_t from = text.find("[{ name: soft");
    text.replace(from, text.find("],\n", from) + 1 - from, "[" + zones + "]");
    return text;
  };
  const auto zone = [](const std::string& name, const std::string& polygon) {
    return "{ name: " + name + ", polygon: " + polygon + " }";
  };
  const auto gate = [](const std::string& name, const std::string& line) {
    return "{ name: " + name + ", line: " + line + " }";
  };
  std::string written =
      with_gates(gate("at_near", near) + ", " + gate("at_far", far), zone("soft", soft_points));
  folder.write("points.yaml", written);
  REQUIRE(call(folder, "run points.yaml --quiet -o points").code == 0);
  std::string each = with_gates(gate("at", "{ layer: lines.geojson, where: { number: 2 }, each: Layer }"),
                                zone("is", "{ layer: site.geojson, where: { number: 1 }, each: Layer }"));
  each.replace(each.find("{ soft: sand }"), 14, "{ is_soft: sand }");
  folder.write("each.yaml", each + "expect: [{ measure: gate.at_far.passed, above: 0 }]\n");
  const Output run = call(folder, "run each.yaml --quiet -o each");
  INFO(run.err);
  REQUIRE(run.code == 0);
  const auto gates_of = [&](const std::string& out) {
    return Json::parse(read(folder.path() / out / "summary.json"))["points"][0]["gates"];
  };
  CHECK(gates_of("each").size() == 2);
  CHECK(gates_of("each") == gates_of("points"));
  const auto said = [&](const std::string& text) { return refusal_of(folder, text); };
  has(said(with_gates(gate("at", "{ layer: site.geojson, each: layer }"), zone("soft", soft_points))),
      "has no attribute `layer`, did you mean `Layer`?");
  has(said(scenario(soft_points, road_points, "{ layer: site.geojson, each: Layer }")),
      "makes several zones, gates, barriers or exposures of one");
}

TEST_CASE("the attributes of a layer are a table: its joints are those of the same CSV") {
  if (skips_without_gdal()) return;
  const Folder folder;
  std::string csv = "dip_deg,dip_direction_deg,note\n", features;
  for (int i = 0; i < 24; ++i) {
    const double dip = (i % 2 == 0 ? 70 : 30) + i % 5, direction = (i % 2 == 0 ? 180 : 95) - i % 7;
    csv += fmt::format("{},{},set {}\n", dip, direction, i % 2);
    features += fmt::format(
        R"({}{{"type":"Feature","properties":{{"dip_deg":{},"dip_direction_deg":{},"note":"set {}"}},"geometry":{}}})",
        i == 0 ? "" : ",", dip, direction, i % 2,
        i % 3 == 0 ? "null" : R"({"type":"Point","coordinates":[8.5,47.1]})");
  }
  folder.write("survey.csv", csv);
  folder.write("survey.geojson", R"({"type":"FeatureCollection","features":[)" + features + "]}");
  REQUIRE(call(folder, "joints survey.csv -o csv").code == 0);
  const Output joints = call(folder, "joints survey.geojson -o layer");
  INFO(joints.err);
  REQUIRE(joints.code == 0);
  const auto sets_of = [&](const std::string& out) {
    return Json::parse(read(folder.path() / out / "joints.json"))["sets"];
  };
  CHECK(sets_of("csv").size() == 2);
  CHECK(sets_of("layer") == sets_of("csv"));
  folder.write("bad.geojson",
               R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"dip_deg":100,)"
               R"("dip_direction_deg":20},"geometry":null}]})");
  const Output refused = call(folder, "joints bad.geojson -o bad");
  CHECK(refused.code == 2);
  CHECK(refused.err.find("bad.geojson#bad:2") != std::string::npos);
  CHECK(refused.err.find("expected 0 to 90 deg") != std::string::npos);
}

TEST_CASE("a layer that fits not says why, and what to write") {
  if (skips_without_gdal()) return;
  const Folder folder;
  write_slope(folder);
  write_site(folder);
  const auto said = [&](const std::string& soft, const std::string& crs = "crs: EPSG:2056, ") {
    return refusal_of(folder, scenario(soft, road_points, crest_points, crs));
  };
  has(said(where("site.geojson", "sofd")), "has no feature whose `Layer` is `sofd`, did you mean `soft`?");
  has(said("{ layer: site.geojson, where: { layer: soft } }"),
      "has no attribute `layer`, did you mean `Layer`?");
  has(said(where("site.geojson", "road")), "has an open line, expected polygons or closed lines");
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

TEST_CASE("a section is cut along a line of two places, or of a layer, as from its ends") {
  const Folder folder;
  write_slope(folder);
  const auto scenario_of = [](const std::string& line) {
    return "flyrock: 1\ndimension: 2\nmethod: ballistic\ntrials: 3\nterrain: { type: section, of: { type: "
           "mesh, file: "
           "slope.obj }, " +
           line +
           " }\nrocks:\n  - { name: a, density: 2700, shape: { type: disk, radius: 0.1 }, release: { "
           "position: [1, "
           "40] }, launch: { type: fixed, velocity: [5, 0] } }\nstop: { time: 60 s }\n";
  };
  const auto rocks_of = [&](const std::string& name, const std::string& line) {
    folder.write(name + ".yaml", scenario_of(line));
    const Output run = call(folder, "run " + name + ".yaml --quiet -o " + name);
    INFO(run.err);
    REQUIRE(run.code == 0);
    return read(folder.path() / name / "rocks.csv");
  };
  const std::string ends = rocks_of("ends", "from: [2600002, 1200005], to: [2600070, 1200050]");
  CHECK(rocks_of("line", "line: [[2600002, 1200005], [2600070, 1200050]]") == ends);
  const auto said = [&](const std::string& line) { return refusal_of(folder, scenario_of(line)); };
  has(said("from: [2600002, 1200005]"), "has no `to`, expected `from` and `to`, or `line`");
  has(said("from: [2600002, 1200005], line: [[2600002, 1200005], [2600070, 1200050]]"),
      "stands in place of `from` and `to`, expected one of both");
  has(said("line: [[2600002, 1200005], [2600030, 1200005], [2600070, 1200050]]"),
      "has 3 points, expected two: a section is straight");
  if (skips_without_gdal()) return;
  const std::string layer = "[[2600002,1200005],[2600070,1200050]]";
  folder.write(
      "sections.geojson",
      R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::2056"}},"features":[)" +
          feature("A", "LineString", layer) + "," + feature("B", "LineString", road_points) + "]}");
  CHECK(rocks_of("layer", "line: { layer: sections.geojson, where: { Layer: A } }") == ends);
}

TEST_CASE("a profile is cut along a line with heights") {
  if (skips_without_gdal()) return;
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
