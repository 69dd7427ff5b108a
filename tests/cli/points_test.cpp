// Point clouds as terrains and as the face of a blast.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <functional>

#include "../las_file.h"
#include "cli/program.h"

namespace flyrock::points_test {

namespace {

using namespace flyrock::test;
using namespace las_files;

constexpr int columns = 31, rows = 21;
constexpr double spacing = 2;

double height(double x, double y) { return 30 - 0.4 * x + 0.5 * std::sin(0.2 * y); }

/// The points of a regular survey, without those that `is_void` names.
std::vector<LasPoint> survey(const std::function<bool(int, int)>& is_void = [](int, int) { return false; }) {
  std::vector<LasPoint> points;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double x = spacing * column, y = spacing * row;
      if (!is_void(column, row))
        points.push_back({{2600000 + x, 1200000 + y, std::round(1000 * height(x, y)) / 1000}});
      if (column % 3 == 0) points.push_back({{2600000 + x, 1200000 + y, height(x, y) + 8}, 5});  // trees
    }
  return points;
}

std::string raster_of(const std::vector<LasPoint>& points) {
  std::string text = fmt::format("ncols {}\nnrows {}\nxllcenter 2600000\nyllcenter 1200000\ncellsize {}\n",
                                 columns, rows, spacing);
  for (int row = rows - 1; row >= 0; --row)
    for (int column = 0; column < columns; ++column)
      for (const LasPoint& point : points)
        if (point.group == 2 && std::lround((point.place.x() - 2600000) / spacing) == column &&
            std::lround((point.place.y() - 1200000) / spacing) == row)
          text += fmt::format("{:.3f}{}", point.place.z(), column + 1 == columns ? "\n" : " ");
  return text;
}

std::string xyz_of(const std::vector<LasPoint>& points) {
  std::string text;
  for (const LasPoint& point : points)
    if (point.group == 2)
      text += fmt::format("{:.3f} {:.3f} {:.3f}\n", point.place.x(), point.place.y(), point.place.z());
  return text;
}

std::string scenario(const std::string& terrain) {
  return "flyrock: 1\ndimension: 3\nmethod: lumped_mass\ntrials: 10\nterrain: { " + terrain +
         ", material: rock }\nmaterials:\n  rock: { restitution: { type: newton, en: 0.4 }, friction: { "
         "type: coulomb, mu: 0.6 } }\n"
         "rocks:\n  - name: loose\n    density: 2700 kg/m3\n    shape: { type: sphere, radius: 0.3 m }\n"
         "    release: { inside: [[2600004, 1200010], [2600008, 1200010], [2600008, 1200030], [2600004, "
         "1200030]], above_ground: 1 m }\n"
         "    launch: { type: fixed, velocity: [6 m/s, 0 m/s, 0 m/s] }\nstop: { time: 60 s }\n";
}

}  // namespace

TEST_CASE("the same survey as a grid, as XYZ and as LAS stops the same rocks at the same places") {
  const Folder folder;
  const auto points = survey();
  folder.write("dem.asc", raster_of(points));
  folder.write("dem.xyz", xyz_of(points));
  folder.write("dem.las", las_of(points));
  folder.write("new.las", las_of(points, {4, 6, 30, 2056, 9001}));
  folder.write("grid.yaml", scenario("type: raster, file: dem.asc"));
  folder.write("xyz.yaml", scenario("type: points, file: dem.xyz, cell: 2 m"));
  folder.write("las.yaml", scenario("type: points, file: dem.las, class: 2, cell: 2 m"));
  folder.write("new.yaml", scenario("type: points, file: new.las, class: 2, cell: 2 m"));
  for (const std::string name : {"grid", "xyz", "las", "new"}) {
    const Output run = call(folder, "run " + name + ".yaml --quiet -o " + name);
    INFO(name << run.err);
    REQUIRE(run.code == 0);
    if (name == "xyz") CHECK(read(folder.path() / "xyz/rocks.csv") == read(folder.path() / "grid/rocks.csv"));
    CHECK(read(folder.path() / name / "rocks.csv").size() > 1000);
  }
  CHECK(read(folder.path() / "las/rocks.csv") == read(folder.path() / "new/rocks.csv"));
  const Output check = call(folder, "check new.yaml");
  CHECK(check.out.find("651 of 882 points, 651 cells of 2 m") != std::string::npos);
  CHECK(read(folder.path() / "new/summary.json").find("\"EPSG:2056\"") != std::string::npos);
}

TEST_CASE("voids of a cloud are filled up to max_gap, and named beyond it") {
  const Folder folder;
  folder.write("dem.xyz", xyz_of(survey([](int column, int row) {
                 return column >= 20 && column < 23 && row >= 8 && row < 12;
               })));
  folder.write("s.yaml", scenario("type: points, file: dem.xyz, cell: 2 m, max_gap: 4 m"));
  const Output wide = call(folder, "check s.yaml");
  INFO(wide.err);
  CHECK(wide.code == 0);
  CHECK(wide.err.find("1 void inside of the points has no ground, the widest of 8 m about (2600042, "
                      "1200019): `max_gap: 8 m` fills it") != std::string::npos);
  folder.write("s.yaml", scenario("type: points, file: dem.xyz, cell: 2 m, max_gap: 8 m"));
  CHECK(call(folder, "check s.yaml").err.find("filled 1 void of 12 cells in all") != std::string::npos);
  folder.write("s.yaml", scenario("type: points, file: dem.xyz, triangulate: true, max_gap: 4 m"));
  const Output hole = call(folder, "check s.yaml");
  CHECK(hole.code == 2);
  CHECK(hole.err.find("write a greater `max_gap`") != std::string::npos);
  folder.write("s.yaml", scenario("type: points, file: dem.xyz, triangulate: true, max_gap: 12 m"));
  const Output whole = call(folder, "check s.yaml");
  INFO(whole.err);
  CHECK(whole.code == 0);
  CHECK(whole.out.find(" triangles, ") != std::string::npos);
}

TEST_CASE("a cloud that is no ground says what to write") {
  const Folder folder;
  folder.write("dem.laz", las_of(survey(), {2, 0x80, 20}));
  folder.write("feet.las", las_of(survey(), {2, 0, 20, 2234, 9003}));
  folder.write("dem.xyz", xyz_of(survey()));
  const auto said = [&](const std::string& terrain) {
    folder.write("s.yaml", scenario("type: points, " + terrain));
    const Output check = call(folder, "check s.yaml");
    CHECK(check.code == 2);
    return check.err;
  };
  CHECK(said("file: dem.laz, class: 2, cell: 2 m").find("`pdal translate dem.laz points.las`") !=
        std::string::npos);
  CHECK(said("file: feet.las, class: 2, cell: 2 m").find("are in feet: write `scale: 0.3048006096`") !=
        std::string::npos);
  CHECK(said("file: dem.xyz, class: 2, cell: 2 m").find("has no classes") != std::string::npos);
  CHECK(said("file: dem.xyz").find("expected either `cell` or `triangulate: true`") != std::string::npos);
  CHECK(said("file: dem.xyz, cell: 0.001 m").find("take larger cells") != std::string::npos);
}

TEST_CASE("a scan of the face gives the burdens that the same table gives") {
  const Folder folder;
  std::string table = "x,y,z\n";
  std::vector<LasPoint> scan;
  for (int row = 0; row <= 12; ++row)
    for (int column = -10; column <= 10; ++column) {
      const flyrock::Vec3 place(2600000 + 3.0 - 0.1 * row, 1200000 + column, row);
      table += fmt::format("{:.3f},{:.3f},{:.3f}\n", place.x(), place.y(), place.z());
      scan.push_back({place, 1});
    }
  folder.write("face.csv", table);
  folder.write("face.las", las_of(scan));
  folder.write("holes.csv", "hole,x,y,z\n1,2600000,1200000,12\n2,2600000,1200003,12\n");
  const auto blast = [](const std::string& points) {
    return "flyrock: 1\ndimension: 3\nmethod: ballistic\ntrials: 3\n"
           "terrain: { type: plane, point: [2600000, 1200000, 0], origin: [2600000, 1200000, 0] }\nblast:\n  "
           "explosive: ANFO\n"
           "  hole: { diameter: 102 mm, length: 12 m, stemming: 2.6 m }\n  burden: 3 m\n  spacing: 3 m\n"
           "  rock_density: 2700 kg/m3\n  breakout_angle: 90 deg\n  holes: { file: holes.csv }\n  face: { "
           "points: " +
           points +
           " }\nrocks:\n  - name: face\n    per_hole: 2\n    density: 2700 kg/m3\n"
           "    shape: { type: sphere, radius: 0.1 m }\n    release: { position: [2600000, 1200000, 12.5] }\n"
           "    launch: { type: gurney, elevation: 30 deg }\nstop: { time: 60 s }\n";
  };
  for (const std::string kind : {"csv", "las"}) {
    folder.write(kind + ".yaml", blast("face." + kind));
    const Output run = call(folder, "run " + kind + ".yaml --quiet -o " + kind);
    INFO(kind << run.err);
    REQUIRE(run.code == 0);
  }
  CHECK(read(folder.path() / "las/rocks.csv") == read(folder.path() / "csv/rocks.csv"));
}

}  // namespace flyrock::points_test
