// What commands say of the files of a terrain, and how zones of a GeoJSON file act.
#include <catch2/catch.hpp>

#include "program.h"

using namespace flyrock::test;

namespace survey_test {

namespace {

std::string scenario_on(const std::string& terrain) {
  return "flyrock: 1\ndimension: 3\nmethod: nscd\ntrials: 2\nterrain: { type: raster, file: g.asc, material: "
         "rock, " +
         terrain +
         " }\nmaterials:\n  rock: { restitution: { type: newton, en: 0.3 }, friction: { type: coulomb, mu: "
         "0.6 } }\n"
         "rocks:\n  - { name: b, density: 2700, shape: { type: box, size: [0.5, 0.5, 0.5] },\n"
         "      release: { x: 1015, y: 2015, above_ground: 1 m } }\nstop: { time: 5 s }\n";
}

const char* const level_grid =
    "ncols 4\nnrows 3\nxllcorner 1000\nyllcorner 2000\ncellsize 10\n500 500 500 500\n500 501 500 500\n500 "
    "500 500 "
    "500\n";

}  // namespace

TEST_CASE("check says what was read of a terrain, and its system goes into the results") {
  const Folder folder;
  folder.write("g.asc", level_grid);
  folder.write("s.yaml", scenario_on("crs: EPSG:2056"));
  CHECK(call(folder, "check s.yaml").out.find("terrain: 12 cells of 10 m, 500 to 501 m, EPSG:2056\n") == 0);
  REQUIRE(call(folder, "run s.yaml --quiet -o out").code == 0);
  CHECK(read(folder.path() / "out" / "summary.json").find("\"crs\": \"EPSG:2056\"") != std::string::npos);
  folder.write("g.prj", "PROJCS[\"x\",UNIT[\"metre\",1],AUTHORITY[\"EPSG\",\"25832\"]]");
  CHECK(call(folder, "check s.yaml").err.find("terrain.crs: is EPSG:2056, the file says EPSG:25832") !=
        std::string::npos);
  folder.write("s.yaml", scenario_on("crs: LV95"));
  CHECK(call(folder, "check s.yaml").err.find("expected EPSG:n, such as EPSG:2056, found `LV95`") !=
        std::string::npos);
}

TEST_CASE("polygons of a GeoJSON file are zones, and its faults have their place") {
  const Folder folder;
  folder.write("g.asc", level_grid);
  const auto ring = [](const std::string& corners) {
    return "{ \"type\": \"Feature\", \"properties\": { \"soil\": \"gravel\", \"id\": 7 }, \"geometry\": { "
           "\"type\": "
           "\"Polygon\", \"coordinates\": [" +
           corners + "] } }";
  };
  const auto check = [&](const std::string& keys, const std::string& features) {
    folder.write("s.yaml", scenario_on("zones: [{ name: soft, geojson: a.geojson" + keys +
                                       " }], materials: { soft: rock }"));
    folder.write("a.geojson", "{ \"type\": \"FeatureCollection\",\n\"features\": [" + features + "] }");
    return call(folder, "check s.yaml");
  };
  const std::string square = ring("[[1000, 2000], [1020, 2000], [1020, 2020], [1000, 2020], [1000, 2000]]");
  CHECK(check("", square).code == 0);
  CHECK(check(", property: soil, is: gravel", square).code == 0);
  const auto says = [&](const std::string& keys, const std::string& features, const std::string& text) {
    const Output output = check(keys, features);
    INFO(output.err);
    CHECK(output.code == 2);
    CHECK(output.err.find(text) != std::string::npos);
  };
  says(", property: soil, is: gravle", square, "no feature has `gravle` of `soil`, did you mean `gravel`?");
  says(", property: cover, is: gravel", square, "no feature has the property `cover`");
  says(", property: soil", square, "`property` and `is` belong together");
  says("", ring("[[1000, 2000], [1020, 2020], [1020, 2000], [1000, 2020], [1000, 2000]]"),
       "feature 1 is no region: the outline of a polygon crosses itself");
  says("", square + ",", ":2:");
  says("", ring("[[8, 47], [8.1, 47], [8.1, 47.1], [8, 47]]"),
       "is in degrees (from 8 to 8.1 and 47 to 47.1)");
  says("", ring("[[8000, 9000], [8010, 9000], [8010, 9010], [8000, 9000]]"),
       "the zone `soft` covers nothing of the terrain");
}

}  // namespace survey_test
