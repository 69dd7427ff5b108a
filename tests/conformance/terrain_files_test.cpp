// Terrains in 3D from files: what they hold, and what is wrong with them.

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "conformance/plugin_use.h"
#include "geometry/terrain_shape.h"
#include "plugin/models.h"
#include "temporary_file.h"

using namespace flyrock;

namespace terrain_files_test {

namespace {

const LuaSession& plugins() {
  static const LuaSession one(FLYROCK_SHARE_DIR);
  return one;
}

TerrainShape3 build(const std::string& name, const std::map<std::string, Given>& given) {
  const auto made = make<TerrainModel>(plugins(), PluginKind::terrain, name, given, 3);
  RandomStream rng(1, "terrain", {});
  return made.model->build_3d(made.values, rng);
}

Mesh mesh_of(const std::string& path, const std::map<std::string, Given>& more = {}) {
  std::map<std::string, Given> given{{"file", path.c_str()}};
  given.insert(more.begin(), more.end());
  return std::get<Mesh>(build("mesh", given));
}

HeightGrid grid_of(const std::string& path) {
  return std::get<HeightGrid>(build("raster", {{"file", path.c_str()}}));
}

/// The text of the error of a file, without the name of the plugin and the folder.
template <class Build>
std::string error_of(const TemporaryFile& file, Build build_it) {
  try {
    build_it(file.path);
  } catch (const PluginError& error) {
    std::string text = error.what();
    const std::string start = ": " + file.path + ":";
    const std::size_t at = text.find(start);
    return at == text.npos ? text : text.substr(at + start.size());
  }
  return "no error";
}

std::string obj_error(const std::string& content) {
  return error_of(TemporaryFile("bad.obj", content), [](const std::string& path) { mesh_of(path); });
}
std::string stl_error(const std::string& content) {
  return error_of(TemporaryFile("bad.stl", content), [](const std::string& path) { mesh_of(path); });
}
std::string grid_error(const std::string& content) {
  return error_of(TemporaryFile("bad.asc", content), [](const std::string& path) { grid_of(path); });
}

/// Two triangles, (0, 0, 0) to (2, 1, 0.5), as binary STL.
std::string binary_stl() {
  std::string text(80, ' ');
  const std::uint32_t count = 2;
  text.append(reinterpret_cast<const char*>(&count), 4);
  const float facets[2][12] = {{0, 0, 1, 0, 0, 0, 2, 0, 0, 2, 1, 0.5},
                               {0, 0, 1, 0, 0, 0, 2, 1, 0.5, 0, 1, 0.5}};
  for (const auto& facet : facets) text.append(reinterpret_cast<const char*>(facet), 48).append(2, '\0');
  return text;
}

}  // namespace

TEST_CASE("an OBJ file gives vertices, faces in all forms of corners, and groups as parts") {
  const TemporaryFile file(
      "good.obj",
      "# a survey\r\nmtllib none.mtl\r\nv 2600000.125 1200000.5 500.0625\r\nv 2600010 1200000 500 1.0\n"
      "v 2600010 1200010 +500.5e0\nv 2600000 1200010 501\nv 2600020 1200000 490\nv 2600020 1200010 490\n"
      "vn 0 0 1\nvt 0 0\no Hang.001\nf 1//1 2//1 3//1\ng berm face_2\nusemtl rock\nf 1/1/1 3/1/1 \\\n 4/1/1\n"
      "g slope\nf 2 -2 -1 3 # a quadrangle\n");
  const Mesh mesh = mesh_of(file.path);
  CHECK(mesh.vertices.size() == 6);
  CHECK(mesh.parts == std::vector<std::string>{"Hang_001", "berm_face_2", "slope"});
  CHECK(mesh.part == std::vector<int>{0, 1, 2, 2});
  const Vec3 first = mesh.vertices[mesh.triangles[0][0]];
  CHECK((first - Vec3(2600000.125, 1200000.5, 500.0625)).norm() < 1e-9);
  CHECK(mesh.triangles[1][1] == mesh.triangles[0][2]);
}

TEST_CASE("a mesh is turned upright and scaled") {
  const TemporaryFile file("y_up.obj", "v 0 5 0\nv 1000 5 0\nv 0 5 -1000\nf 1 2 3\n");
  const Mesh mesh = mesh_of(file.path, {{"up", "y"}, {"scale", 0.001}});
  CHECK((mesh.vertices[mesh.triangles[0][2]] - Vec3(0, 1, 0.005)).norm() < 1e-12);
}

TEST_CASE("a malformed OBJ file is refused with its line") {
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  CHECK(obj_error(square) == " has no faces, expected lines that begin with `f`");
  CHECK(obj_error("v 0 0\n") == "1: a vertex has 2 numbers, expected x, y and z");
  CHECK(obj_error("\n\nv 0 zero 0\n") == "3: `zero` is not a number");
  CHECK(obj_error("v 0 nan 0\n") == "1: `nan` is not a number");
  CHECK(obj_error(square + "f 1 2\n") == "5: a face has 2 corners, expected at least three");
  CHECK(obj_error(square + "f 1 2 5\n") == "5: the face names the vertex 5, there are 4 above it");
  CHECK(obj_error(square + "f 1 0 2\n") == "5: the face names the vertex 0, there are 4 above it");
  CHECK(obj_error(square + "f 1 2 three\n") == "5: `three` is not a corner, expected the number of a vertex");
  CHECK(obj_error(square + "v 0.8 0.2 0\nf 1 5 3 4\n").find("no error") == 0);
  CHECK(obj_error(square + "v 0.6 0.4 0\nf 1 2 3 5\n") ==
        "6: the face of 4 corners is not convex, expected triangles");
  CHECK(obj_error(square + "f 1 2 3\nf 1 4 3\n")
            .find(" the two triangles at the edge from (0, 0, 0) to (1, 1, 0) (lines 5 "
                  "and 6) face opposite ways") == 0);
  CHECK(obj_error(square + "f 1 2 3\nf 1 4 3\n").find("; turn its normals outwards") != std::string::npos);
  CHECK(obj_error(square + "v 0 0 1\nf 1 2 5\n")
            .find(" the piece of 1 triangles with the triangle (0, 0, 0), (1, 0, 0), (0, 0, 1) in "
                  "line 6 faces down or stands upright") == 0);
}

TEST_CASE("STL is read as text and as binary, with equal corners joined") {
  const TemporaryFile text(
      "text.stl",
      "solid hill of rock\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 2 0 0\n"
      "   vertex 2 1 0.5\n  endloop\n endfacet\n facet normal nan nan nan\n  outer loop\n   vertex 0 0 0\n"
      "   vertex 2 1 0.5\n   vertex 0 1 5e-1\n  endloop\n endfacet\nendsolid hill of rock\n");
  const TemporaryFile binary("binary.stl", binary_stl());
  for (const Mesh& mesh : {mesh_of(text.path), mesh_of(binary.path)}) {
    CHECK(mesh.vertices.size() == 4);
    REQUIRE(mesh.triangles.size() == 2);
    CHECK(mesh.vertices[mesh.triangles[1][2]] == Vec3(0, 1, 0.5));
    CHECK(mesh.parts == std::vector<std::string>{""});
  }
}

TEST_CASE("a malformed STL file is refused with its line or its triangle") {
  CHECK(stl_error("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\n") ==
        "4:12: `x` is not a number, expected a coordinate");
  CHECK(stl_error("solid a\nfacet normal 0 0 1\nouter loop\nvertx 0 0 0\n") ==
        "4:1: expected `vertex`, found `vertx`");
  CHECK(stl_error("solid a\nendsolid a\n") == " has no triangles");
  CHECK(stl_error("solid a\nfacet normal 0 0 1\n").find("3:1: the file ends, expected `outer`") == 0);
  CHECK(stl_error(binary_stl().substr(0, 150)) ==
        " is neither STL as text (its first word is not `solid`) nor binary: 2 triangles need 184 bytes, the "
        "file has 150");
  std::string infinite = binary_stl();
  const float huge = HUGE_VALF;
  std::memcpy(infinite.data() + 84 + 12, &huge, 4);
  CHECK(stl_error(infinite) == " a corner of triangle 1 of 2 is not finite");
}

TEST_CASE("an ESRI ASCII grid has its first row in the north and its place at a corner or a centre") {
  const std::string rows = "-9999 8 9\n4 5 6\n1 2 3.5\n";
  const TemporaryFile corner("corner.asc",
                             "NCOLS 3\nNROWS 3\nXLLCORNER 100\nYLLCORNER 200\nCELLSIZE 10\n" + rows);
  const TemporaryFile centre(
      "centre.asc", "ncols 3\r\nnrows 3\r\nxllcenter 105\r\nyllcenter 205\r\ncellsize 10\r\n" + rows);
  for (const HeightGrid& grid : {grid_of(corner.path), grid_of(centre.path)}) {
    CHECK((grid.columns == 3 && grid.rows == 3 && grid.cell == 10));
    CHECK(grid.corner == Vec2(105, 205));
    CHECK(grid.at(0, 0) == 1);
    CHECK(grid.at(2, 0) == 3.5);
    CHECK(std::isnan(grid.at(0, 2)));
    CHECK(grid.at(2, 2) == 9);
  }
}

TEST_CASE("numbers of a grid are the nearest doubles, in all forms") {
  const TemporaryFile file("numbers.asc",
                           "ncols 4\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\nnodata_value -1e3\n"
                           "0.1 -923.4567 1e3 4567.0123456789012345\n+2.5 -1000 nan 2380.910889\n");
  const HeightGrid grid = [&] {
    try {
      return grid_of(file.path);
    } catch (const PluginError&) {  // no square has four heights, which is another test
      return HeightGrid();
    }
  }();
  CHECK(grid.heights.empty());
  const TemporaryFile more("numbers2.asc",
                           "ncols 4\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\nnodata_value -1e3\n"
                           "0.1 -923.4567 1e3 4567.0123456789012345\n+2.5 -0.3 nan 2380.910889\n");
  const HeightGrid read = grid_of(more.path);
  CHECK(read.at(0, 1) == 0.1);
  CHECK(read.at(1, 1) == -923.4567);
  CHECK(read.at(2, 1) == 1000);
  CHECK(read.at(3, 1) == 4567.0123456789012345);
  CHECK(read.at(0, 0) == 2.5);
  CHECK(std::isnan(read.at(2, 0)));
  CHECK(read.at(3, 0) == 2380.910889);
}

TEST_CASE("a malformed grid is refused with line and column") {
  const std::string head = "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  CHECK(grid_error(head + "1 2 3\n4 5 6 7\n") ==
        "7:7: `7` follows the 2 rows of 3 values that the header announces");
  CHECK(grid_error(head + "1 2 3\n4 5 6\n7 8 9\n") ==
        "8:1: `7` follows the 2 rows of 3 values that the header announces");
  CHECK(grid_error(head + "1 2\n3 4 5\n") ==
        "8:1: the file ends after 1 of 2 rows of 3 values; line 6 is the first that does not hold the 3 "
        "values of a row");
  CHECK(grid_error(head + "1 2 3\n4 five 6\n") == "7:3: `five` is not a number, expected a height");
  CHECK(grid_error("ncols 3\nnrows 2\nxllcorner 0\ncellsize 1\n1 2 3 4 5 6\n")
            .find("the header ends here without `yllcorner` or "
                  "`yllcenter`") != std::string::npos);
  CHECK(grid_error("ncols 3\nncols 3\n").find("2:1: `ncols` stands here a second time") == 0);
  CHECK(grid_error("ncols 2.5\n") == "1:7: `ncols` is 2.5, expected a whole number from 2 to 1000000");
  CHECK(grid_error("cells 3\n").find("1:1: unknown keyword `cells`, expected ncols, nrows") == 0);
  CHECK(grid_error(head + "1 -9999 3\n4 5 6\n") ==
        " a grid has no ground: nowhere have four neighbouring cells a height");
  CHECK(grid_error("").find("the header ends here without `ncols`") != std::string::npos);
}

TEST_CASE("the published release mask is refused with one clear error", "[data]") {
  const std::string path = FLYROCK_SOURCE_DIR "/../shared/data/field/siconos_dem/d1_release_mask.asc";
  if (!std::filesystem::exists(path)) {
    WARN("SKIPPED: no field data");
    return;
  }
  CHECK_THROWS_WITH(grid_of(path),
                    Catch::Contains("d1_release_mask.asc:168:1: `-9999` follows the 161 rows of 224 values "
                                    "that the header announces"));
  const HeightGrid dem = grid_of(FLYROCK_SOURCE_DIR "/../shared/data/field/siconos_dem/dem.asc");
  CHECK(std::count_if(dem.heights.begin(), dem.heights.end(), [](double z) { return !std::isnan(z); }) ==
        14927);
}

}  // namespace terrain_files_test
