// Benches in 3D, and their ditch, bund and roughness in 2D and 3D.

#include <catch2/catch.hpp>
#include <cmath>

#include "conformance/plugin_use.h"
#include "geometry/profile.h"
#include "geometry/terrain_fault.h"
#include "plugin/models.h"

using namespace flyrock;

namespace benches_test {

namespace {

using Numbers = std::map<std::string, Given>;

const LuaSession& of_benches() {
  static const LuaSession one(FLYROCK_SHARE_DIR);
  return one;
}

constexpr double deg = pi / 180;

Numbers numbers(Numbers more = {}) {
  more.insert({{"count", 3.0}, {"height", 12.0}, {"face_angle", 70 * deg}, {"berm", 8.0}, {"floor", 100.0}});
  return more;
}

Mesh surface(const Numbers& given, std::uint64_t trial = 0) {
  const auto made = make<TerrainModel>(of_benches(), PluginKind::terrain, "benches", given, 3);
  DrawKey key;
  key.trial = trial;
  RandomStream rng(1, "terrain", key);
  Mesh mesh = std::get<Mesh>(made.model->build_3d(made.values, rng));
  CHECK(fault(mesh) == "");
  return mesh;
}

Profile section(const Numbers& given, std::uint64_t trial = 0) {
  const auto made = make<TerrainModel>(of_benches(), PluginKind::terrain, "benches", given);
  DrawKey key;
  key.trial = trial;
  RandomStream rng(1, "terrain", key);
  Profile profile = made.model->build(made.values, rng);
  CHECK(profile.fault() == "");
  return profile;
}

/// The height of a mesh at a place in plan, from the triangle there.
double height_at(const Mesh& mesh, double x, double y) {
  for (const auto& triangle : mesh.triangles) {
    const Vec3 &a = mesh.vertices[triangle[0]], &b = mesh.vertices[triangle[1]],
               &c = mesh.vertices[triangle[2]];
    const Vec3 normal = (b - a).cross(c - a);
    if (normal.z() < 1e-9) continue;
    bool inside = true;
    for (int k = 0; k < 3; ++k) {
      const Vec3 &from = mesh.vertices[triangle[k]], &to = mesh.vertices[triangle[(k + 1) % 3]];
      inside = inside && cross(Vec2((to - from).head<2>()), Vec2(x - from.x(), y - from.y())) >= -1e-9;
    }
    if (inside) return a.z() - (normal.x() * (x - a.x()) + normal.y() * (y - a.y())) / normal.z();
  }
  return std::nan("");
}

}  // namespace

TEST_CASE("benches in 3D are the section of 2D along y") {
  const Profile plan = section(numbers());
  const Mesh mesh = surface(numbers());
  for (const double x : {-40.0, -1.0, 2.0, 6.0, 14.0, 20.0, 30.0, 60.0})
    for (const double y : {-49.0, 0.5, 49.0})
      CHECK(height_at(mesh, x, y) == Approx(plan.height(x)).margin(1e-9));
  CHECK(std::isnan(height_at(mesh, 0, 51)));
  CHECK(mesh.parts == plan.parts);
  REQUIRE(mesh.faces.size() == 3);
  CHECK(mesh.faces[1].name == "bench_2");
  CHECK(mesh.faces[0].crest.front() == Vec3(0, -50, 36));
  CHECK(mesh.faces[0].crest.back() == Vec3(0, 50, 36));
  CHECK((mesh.faces[2].toe.back() - Vec3(plan.faces[2].toe.x(), 50, 0)).norm() < 1e-12);
}

TEST_CASE("an azimuth turns benches about z, a length bounds them") {
  const Profile plan = section(numbers());
  const Mesh mesh = surface(numbers({{"azimuth", 90 * deg}, {"length", 20.0}}));
  for (const double x : {-40.0, 6.0, 30.0})
    CHECK(height_at(mesh, -9, x) == Approx(plan.height(x)).margin(1e-9));  // faces look to +y
  CHECK(std::isnan(height_at(mesh, 11, 0)));
}

TEST_CASE("a line has faces to its right and lower edges at equal distances, with mitred corners") {
  const Profile plan = section(numbers());
  // To the east, then to the north: the faces look to the south, then to the east.
  const Mesh mesh =
      surface(numbers({{"line", std::vector<std::vector<double>>{{0, 0}, {100, 0}, {100, 80}}}}));
  for (const double x : {1.0, 10.0, 22.0, 35.0}) {
    CHECK(height_at(mesh, 50, -x) == Approx(plan.height(x)).margin(1e-9));
    CHECK(height_at(mesh, 100 + x, 40) == Approx(plan.height(x)).margin(1e-9));
    CHECK(height_at(mesh, 100 + x, -x) == Approx(plan.height(x)).margin(1e-9));  // on the mitre
  }
  REQUIRE(mesh.faces[0].toe.size() == 3);
  CHECK(mesh.faces[0].toe[1].x() - 100 == Approx(plan.faces[0].toe.x()));
  // A turn to the right shortens the lower edges.
  const Mesh inner = surface(
      numbers({{"line", std::vector<std::vector<double>>{{0, 0}, {200, 0}, {200, -200}}}, {"floor", 50.0}}));
  CHECK(height_at(inner, 200 - 10, -10) == Approx(plan.height(10)).margin(1e-9));
}

TEST_CASE("a corner that swallows a berm is an error naming it") {
  const auto error = [](std::vector<std::vector<double>> line, double floor) -> std::string {
    try {
      surface(numbers({{"line", std::move(line)}, {"floor", floor}}));
    } catch (const PluginError& fault) {
      return fault.what();
    }
    return "no error";
  };
  // Two turns to the right 40 m apart leave nothing of an edge beyond 20 m.
  CHECK(error({{0, 0}, {200, 0}, {200, -40}, {0, -40}}, 50) ==
        "plugin benches: the corner of line at (200, -40) swallows the berm below bench 2: 24.7353 m from "
        "the uppermost "
        "crest its edge would be -9.47057 m long");
  CHECK(error({{0, 0}, {200, 0}, {200, -80}, {0, -80}}, 50).find("swallows the floor") != std::string::npos);
  CHECK(error({{0, 0}, {100, 0}, {0, 1}}, 50).find("line turns by more than 168 deg at (100, 0)") !=
        std::string::npos);
  CHECK(error({{0, 0}, {0, 0}, {0, 1}}, 50).find("stands twice in a row") != std::string::npos);
  // The plateau of 50 m lies on the other side.
  CHECK(error({{0, 0}, {200, 0}, {200, 60}, {0, 60}}, 50)
            .find("swallows the berm behind the uppermost crest") != std::string::npos);
}

TEST_CASE("a ditch lies at the lowest toe, a bund behind it") {
  const double run = 12 / std::tan(70 * deg), toe = 3 * run + 16;
  const Profile profile = section(numbers({{"ditch.width", 3.0},
                                           {"ditch.depth", 2.0},
                                           {"bund.height", 1.5},
                                           {"bund.slope", 45 * deg},
                                           {"bund.distance", 4.0}}));
  CHECK(profile.parts == std::vector<std::string>{"face", "berm", "floor", "ditch", "bund"});
  const double bottom = toe + 2 / std::tan(70 * deg);
  const std::vector<Vec2> expected{
      {toe, 0},        {bottom, -2},         {bottom + 3, -2},     {bottom + 5, 0},
      {bottom + 9, 0}, {bottom + 10.5, 1.5}, {bottom + 11.5, 1.5}, {bottom + 13, 0},
      {toe + 100, 0}};
  REQUIRE(profile.points.size() == 6 + expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    CHECK((profile.points[6 + i] - expected[i]).norm() < 1e-9);
  CHECK(std::vector<int>(profile.part.begin() + 6, profile.part.end()) ==
        std::vector<int>{3, 3, 3, 2, 4, 4, 4, 2});
  CHECK(profile.faces[2].toe.y() == 0);
  const Mesh mesh = surface(numbers({{"ditch.width", 3.0}, {"ditch.depth", 2.0}}));
  CHECK(height_at(mesh, bottom + 1, 10) == Approx(-2));
}

TEST_CASE("a bund on berms stands at their outer edges") {
  const Profile profile = section(
      numbers({{"bund.height", 1.0}, {"bund.top", 0.5}, {"bund.slope", 45 * deg}, {"bund.on", "berm"}}));
  const double edge = 12 / std::tan(70 * deg) + 8;
  CHECK(profile.height(edge) == Approx(24));
  CHECK(profile.height(edge - 1.25) == Approx(25));
  CHECK(profile.height(edge - 2.5 - 1e-9) == Approx(24));
  CHECK(profile.height(-1) == 36);
  CHECK_THROWS_WITH(section(numbers({{"bund.height", 4.0}, {"bund.on", "berm"}})),
                    Catch::Contains("bund is 11.6164 m wide at its base, the berm 8 m"));
  CHECK_THROWS_WITH(section(numbers({{"bund.height", 4.0}, {"bund.on", "berm"}, {"bund.distance", 1.0}})),
                    Catch::Contains("`distance` is only for a bund on the floor"));
  CHECK_THROWS_WITH(section(numbers({{"ditch.width", 99.0}, {"ditch.depth", 2.0}})),
                    Catch::Contains("floor is 100 m, the ditch and the bund on it take 101.728 m"));
}

TEST_CASE("roughness moves faces and berms by its standard deviation, and nothing else") {
  const Numbers rough =
      numbers({{"roughness.sd", 0.1}, {"roughness.length", 2.0}, {"count", 2.0}, {"length", 40.0}});
  const Mesh smooth = surface(numbers({{"count", 2.0}, {"length", 40.0}}));
  double squares = 0;
  int count = 0;
  for (std::uint64_t trial = 0; trial < 5; ++trial) {
    const Mesh mesh = surface(rough, trial);
    CHECK(mesh.triangles.size() > 10000);
    for (const Vec3& vertex : mesh.vertices) {
      if (vertex.x() < -49 || vertex.x() > -1) continue;
      const double height = vertex.z() - 24;
      squares += height * height;
      ++count;
    }
    CHECK(height_at(mesh, 60, 3) == 0);
    CHECK(mesh.faces[0].crest == smooth.faces[0].crest);
  }
  CHECK(std::sqrt(squares / count) == Approx(0.1).epsilon(0.15));
  CHECK(surface(rough, 1).vertices == surface(rough, 1).vertices);
  CHECK(surface(rough, 1).vertices != surface(rough, 2).vertices);

  const Profile profile = section(numbers({{"roughness.sd", 0.2}, {"roughness.length", 2.0}}), 3);
  CHECK(profile.points.size() > 150);
  CHECK(profile.height(60) == 0);
  double greatest = 0;
  for (const Vec2& point : profile.points)
    if (point.x() < -1) greatest = std::max(greatest, std::abs(point.y() - 36));
  CHECK((greatest > 0.2 && greatest < 1));
}

TEST_CASE("a rough face that would hang over stands upright in 2D") {
  for (std::uint64_t trial = 0; trial < 20; ++trial)
    section(numbers({{"face_angle", 90 * deg}, {"roughness.sd", 0.5}, {"roughness.length", 1.0}}), trial);
}

TEST_CASE("keys of 3D are refused in 2D") {
  CHECK_THROWS_WITH(section(numbers({{"azimuth", 0.1}})), Catch::Contains("`azimuth` needs dimension 3"));
  CHECK_THROWS_WITH(
      surface(numbers({{"azimuth", 0.1}, {"line", std::vector<std::vector<double>>{{0, 0}, {1, 0}}}})),
      Catch::Contains("`line` says where the crest runs, expected it without `azimuth`"));
}

}  // namespace benches_test
