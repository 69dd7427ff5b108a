#include "survey/point_cloud.h"

#include <catch2/catch.hpp>

#include "../../las_file.h"
#include "../../temporary_file.h"
#include "plugin/params.h"

using namespace flyrock;
using namespace las_files;

namespace point_cloud_test {

const std::vector<LasPoint> three_points = {
    {{2600001.5, 1200002.25, 410.125}, 2}, {{2600003, 1200004, 430}, 5}, {{2600005, 1200006, 411}, 2, true}};

PointCloud cloud_of(const std::string& name, const std::string& bytes, std::optional<int> of_class = {}) {
  const TemporaryFile file(name, bytes);
  return read_point_cloud("plugin points", file.path, of_class);
}

std::string cloud_fault(const std::string& name, const std::string& bytes, std::optional<int> of_class = {}) {
  const TemporaryFile file(name, bytes);
  try {
    read_point_cloud("plugin points", file.path, of_class);
  } catch (const PluginError& error) {
    const std::string text = error.what();
    return text.substr(text.find(file.path) + file.path.size());
  }
  return {};
}

}  // namespace point_cloud_test
using namespace point_cloud_test;

TEST_CASE(
    "LAS 1.2 to 1.4 in old and new point formats have their places and classes, without withheld points") {
  for (const LasKind& kind :
       {LasKind{2, 0, 20}, LasKind{2, 3, 34}, LasKind{3, 5, 63}, LasKind{4, 6, 30}, LasKind{4, 8, 40}}) {
    const PointCloud ground = cloud_of("a.las", las_of(three_points, kind), 2);
    REQUIRE(ground.points.size() == 1);
    CHECK(ground.all == 3);
    CHECK((ground.points[0] - three_points[0].place).norm() < 1e-9);
    const PointCloud all = cloud_of("a.las", las_of(three_points, kind));
    CHECK(all.points.size() == 2);
    REQUIRE(all.notes.size() == 1);
    CHECK(all.notes[0].find("of the classes 2 (1 points), 5 (1 points): `class: 2`") != std::string::npos);
  }
}

TEST_CASE("a LAS file says its system and its unit") {
  const PointCloud cloud = cloud_of("a.las", las_of(three_points, {2, 0, 20, 2056, 9001}), 2);
  CHECK(cloud.crs == "EPSG:2056");
  CHECK(cloud.plan_unit == "m");
  CHECK(cloud_of("a.las", las_of(three_points, {2, 0, 20, 2234, 9003}), 2).plan_unit == "us_ft");
}

TEST_CASE("a cloud that is cut, compressed or of another kind is refused in one line") {
  const std::string sound = las_of(three_points);
  CHECK(cloud_fault("a.las", sound.substr(0, 100)).find("is cut: its head is missing") != std::string::npos);
  CHECK(cloud_fault("a.las", sound.substr(0, sound.size() - 1))
            .find("announces 3 points of 20 bytes from byte 227 on, it ends at 286") != std::string::npos);
  CHECK(cloud_fault("a.las", "PLY").find("is no LAS file") != std::string::npos);
  CHECK(cloud_fault("a.las", sound, 6).find("has no point of class 6, it has 2 (1 points), 5 (1 points)") !=
        std::string::npos);
  const std::string compressed = cloud_fault("a.laz", las_of(three_points, {2, 0x80, 20}));
  CHECK(compressed.find("is compressed (LAZ): `pdal translate ") != std::string::npos);
  CHECK(compressed.find("points.las` or `laszip -i ") != std::string::npos);
  std::string version = sound;
  version[25] = 5;
  CHECK(cloud_fault("a.las", version).find("is LAS 1.5, expected 1.2 to 1.4") != std::string::npos);
  std::string scale = sound;
  put(scale, 131, 0.0);
  CHECK(cloud_fault("a.las", scale).find("has a scale or an offset") != std::string::npos);
}

TEST_CASE("XYZ has heads, comments, further values and any separator") {
  for (const char* text :
       {"x y z r g b\n1 2 3 255 0 0\n4 5 6 0 0 0\n", "# scan\n1,2,3\n4,5,6\n",
        "\xef\xbb\xbf"
        "1;2;3\r\n4;5;6\r\n",
        "//X Y Z\n\n1\t2\t3\n4\t5\t6", "2\n1 2 3\n4 5 6\n", "//X;Y;Z\n2\n1;2;3\n4;5;6\n",
        "1,0;2,0;3,0\n4,0;5,0;6,0\n", "1,0 2,0 3,0 7\n4,0 5,0 6,0 7\n", "1.0, 2.0, 3.0\n4.0, 5.0, 6.0\n",
        "# id x y in the system of the plan\n1 2 3\n4 5 6\n",
        "id,Northing (m),Easting (m),RL (m)\nP1,2,1,3\nP2,5,4,6\n", "fid;z;y;x;\n1;3,0;2;1;\n2;6,0;5;4;\n"}) {
    INFO(text);
    const PointCloud cloud = cloud_of("a.xyz", text);
    REQUIRE(cloud.points.size() == 2);
    CHECK(cloud.points[1] == Vec3(4, 5, 6));
  }
  CHECK(cloud_of("a.xyz", "x_ft y_ft z_ft\n1 2 3\n").plan_unit == "ft");
  CHECK(cloud_fault("a.xyz", "1 2 3\n4 5\n")
            .find(":2: expected x, y and z, apart by blanks or commas, the line ends before") !=
        std::string::npos);
  CHECK(cloud_fault("a.xyz", "1 2 3\n4 x 6\n").find(":2: expected x, y and z") != std::string::npos);
  CHECK(cloud_fault("a.xyz", "1 2 3\n", 2).find("has no classes, leave `class` out") != std::string::npos);
  CHECK(cloud_fault("a.xyz", "x y z\n").find("has no point") != std::string::npos);
}

TEST_CASE("XYZ whose columns are not sure, or of which points are missing, is refused with the cure") {
  const std::pair<const char*, const char*> cases[] = {
      {"ncols 20\n1 2 3\n", ":1: `ncols 20` is no point, and no heads with x, y and z"},
      {"1 11 12 13\n2 14 15 16\n3 17 18 19\n", "its first column counts the points: write heads"},
      {"3\n1 2 3\n4 5 6\n", "announces 3 points and has 2: it was cut"},
      {"id,x,y,z\n1,2,3\n", ":2: the line has 3 values, the heads are 4"},
      {"x_mm y_mm z_mm\n1 2 3\n", ":1: the heads are in `mm`, expected m or ft"},
      {"2.60001e+06 1.2e+06 410\n2.60002e+06 1.2e+06 411\n", "they are 10 apart"},
  };
  for (const auto& [text, expected] : cases) {
    INFO(text);
    const std::string fault = cloud_fault("a.xyz", text);
    INFO(fault);
    CHECK(fault.find(expected) != std::string::npos);
  }
}
