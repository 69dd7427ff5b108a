// One ground in every form that needs no GDAL: the same rocks stop at the same places.

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <sstream>

#include "../las_file.h"
#include "cli/program.h"
#include "rows.h"

namespace flyrock::same_ground_test {

namespace {

using namespace flyrock::test;

struct Ground {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
};

/// Two benches on a lattice of nearly equilateral triangles, of which Delaunay has no choice. Multiples of
/// 1/8 m, so that all forms have them exactly.
Ground pit() {
  constexpr int columns = 16, rows = 10;
  Ground ground;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const double x = 8 * i + (j % 2) * 4, bench = x < 24   ? 40
                                                    : x < 36 ? 26
                                                    : x < 60 ? 25
                                                    : x < 72 ? 11
                                                             : 10;
      ground.points.emplace_back(2600000 + x, 1200000 + 7. * j, bench + ((3 * i + 5 * j) % 8) / 8.);
    }
  for (int j = 0; j + 1 < rows; ++j)
    for (int i = 0; i + 1 < columns; ++i) {
      const int a = j * columns + i, b = a + 1, c = a + columns, d = c + 1;
      if (j % 2 == 0)
        ground.triangles.insert(ground.triangles.end(), {{a, b, c}, {b, d, c}});
      else
        ground.triangles.insert(ground.triangles.end(), {{a, d, c}, {a, b, d}});
    }
  return ground;
}

std::string obj_of(const Ground& ground) {
  std::string text;
  for (const Vec3& p : ground.points) text += fmt::format("v {:.3f} {:.3f} {:.3f}\n", p.x(), p.y(), p.z());
  for (const auto& t : ground.triangles) text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return text;
}

template <class Number>
void put(std::string& bytes, Number number, bool is_big) {
  char raw[sizeof number];
  std::memcpy(raw, &number, sizeof number);
  if (is_big) std::reverse(raw, raw + sizeof number);
  bytes.append(raw, sizeof number);
}

/// As MeshLab writes it, with colours and flags; `format`: ascii, binary_little_endian or binary_big_endian.
std::string ply_of(const Ground& ground, const std::string& format) {
  std::string bytes = fmt::format(
      "ply\nformat {} 1.0\ncomment VCGLIB generated\nelement vertex {}\nproperty double x\nproperty double "
      "y\n"
      "property double z\nproperty uchar red\nelement face {}\nproperty list uchar int vertex_indices\n"
      "property int flags\nend_header\n",
      format, ground.points.size(), ground.triangles.size());
  const bool is_text = format == "ascii", is_big = format == "binary_big_endian";
  for (const Vec3& p : ground.points) {
    if (is_text) bytes += fmt::format("{} {} {} 200\n", p.x(), p.y(), p.z());
    if (is_text) continue;
    for (const double coordinate : p) put(bytes, coordinate, is_big);
    bytes += '\x7f';
  }
  for (const auto& t : ground.triangles) {
    if (is_text) bytes += fmt::format("3 {} {} {} 0\n", t[0], t[1], t[2]);
    if (is_text) continue;
    bytes += '\3';
    for (const std::int32_t corner : t) put(bytes, corner, is_big);
    put(bytes, std::int32_t{0}, is_big);
  }
  return bytes;
}

std::string stl_of(const Ground& ground) {
  std::string text = "solid vcg\n";
  for (const auto& t : ground.triangles) {
    text += "facet normal 0 0 1\nouter loop\n";
    for (const int k : t)
      text += fmt::format("vertex {:.10e} {:.10e} {:.10e}\n", ground.points[k].x(), ground.points[k].y(),
                          ground.points[k].z());
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid vcg\n";
}

std::string landxml_of(const Ground& ground, const std::string& units, double per_metre) {
  std::string text = "<LandXML><Units>" + units +
                     "</Units><Surfaces><Surface name=\"Pit\"><Definition surfType=\"TIN\"><Pnts>";
  for (std::size_t i = 0; i < ground.points.size(); ++i) {
    const Vec3 p = per_metre * ground.points[i];
    text += fmt::format("<P id=\"{}\">{} {} {}</P>", i + 1, p.y(), p.x(), p.z());
  }
  text += "</Pnts><Faces>";
  for (const auto& t : ground.triangles) text += fmt::format("<F>{} {} {}</F>", t[0] + 1, t[1] + 1, t[2] + 1);
  return text + "</Faces></Definition></Surface></Surfaces></LandXML>";
}

/// Lines of text in an order of the values, `{0}` x, `{1}` y, `{2}` z.
std::string xyz_of(const Ground& ground, const std::string& head, const std::string& line) {
  std::string text = head;
  int number = 0;
  for (const Vec3& p : ground.points)
    text += fmt::format(fmt::runtime(line), p.x(), p.y(), p.z(), ++number) + "\n";
  return text;
}

std::string scenario(const std::string& terrain) {
  return "flyrock: 1\ndimension: 3\nmethod: lumped_mass\ntrials: 30\nterrain: { " + terrain +
         ", material: rock, materials: { soft: sand },\n  zones: [{ name: soft, polygon: [[2600061, "
         "1200001], "
         "[2600119, 1200001], [2600119, 1200060], [2600061, 1200060]] }] }\n"
         "materials:\n  rock: { restitution: { type: newton, en: 0.5 }, friction: { type: coulomb, mu: 0.5 } "
         "}\n"
         "  sand: { restitution: { type: newton, en: 0.2 }, friction: { type: coulomb, mu: 0.8 } }\n"
         "rocks:\n  - name: loose\n    density: 2700 kg/m3\n"
         "    shape: { type: sphere, radius: { uniform: [0.2 m, 0.4 m] } }\n"
         "    release: { along: [[2600010, 1200010], [2600010, 1200050]], above_ground: 2 m }\n"
         "    launch: { type: fixed, velocity: [9 m/s, 0 m/s, 0 m/s] }\nstop: { time: 60 s }\n";
}

struct Stopped {
  std::string csv;  ///< of all rocks
  std::vector<std::string> places;
};

Stopped rocks_of(const Folder& folder, const std::string& terrain) {
  folder.write("s.yaml", scenario(terrain));
  const Output run = call(folder, "run s.yaml --quiet --force -o out");
  INFO(terrain << ": " << run.err);
  REQUIRE(run.code == 0);
  return {read(folder.path() / "out/rocks.csv"),
          query(folder.path() / "out/results.db",
                "SELECT stop_x_m - 2600000, stop_y_m - 1200000, stop_z_m FROM rocks ORDER BY trial")};
}

/// The greatest difference of the coordinates where rocks stop [m].
double apart(const Stopped& one, const Stopped& other) {
  REQUIRE(one.places.size() == other.places.size());
  double worst = 0;
  for (std::size_t rock = 0; rock < one.places.size(); ++rock) {
    std::istringstream a(one.places[rock]), b(other.places[rock]);
    for (std::string of_one, of_other; std::getline(a, of_one, '|') && std::getline(b, of_other, '|');)
      worst = std::max(worst, std::abs(std::stod(of_one) - std::stod(of_other)));
  }
  return worst;
}

}  // namespace

TEST_CASE("one pit as OBJ, PLY, STL and LandXML gives the same bytes, as points the same places") {
  const Folder folder;
  const Ground ground = pit();
  folder.write("pit.obj", obj_of(ground));
  for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"})
    folder.write(format + ".ply", ply_of(ground, format));
  folder.write("pit.stl", stl_of(ground));
  folder.write("m.xml", landxml_of(ground, "<Metric linearUnit=\"meter\"/>", 1));
  folder.write("ft.xml", landxml_of(ground, "<Imperial linearUnit=\"foot\"/>", 1 / 0.3048));
  const Stopped expected = rocks_of(folder, "type: mesh, file: pit.obj");
  for (const char* file :
       {"ascii.ply", "binary_little_endian.ply", "binary_big_endian.ply", "pit.stl", "m.xml"}) {
    INFO(file);
    CHECK(rocks_of(folder, fmt::format("type: mesh, file: {}", file)).csv == expected.csv);
  }
  constexpr double rounded_feet = 1e-7;
  CHECK(apart(rocks_of(folder, "type: mesh, file: ft.xml"), expected) < rounded_feet);
  folder.write("cloudcompare.xyz", xyz_of(ground, fmt::format("//X Y Z R\n{}\n", ground.points.size()),
                                          "{0:.6f} {1:.6f} {2:.6f} 7"));
  folder.write("survey.csv", xyz_of(ground, "id;northing;easting;elevation\n", "P{3};{1};{0};{2}"));
  std::vector<las_files::LasPoint> points;
  for (const Vec3& place : ground.points) points.push_back({place, 2});
  folder.write("old.las", las_files::las_of(points, {2, 0, 20, 2056, 9001}));
  folder.write("new.las", las_files::las_of(points, {4, 6, 30, 2056, 9001}));
  for (const char* file : {"cloudcompare.xyz", "survey.csv", "old.las", "new.las"}) {
    INFO(file);
    CHECK(
        apart(rocks_of(folder, fmt::format("type: points, file: {}, triangulate: true, max_gap: 9 m", file)),
              expected) < 1e-9);
  }
}

}  // namespace flyrock::same_ground_test
