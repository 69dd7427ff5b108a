#include <catch2/catch.hpp>
#include <cstdio>
#include <fstream>

#include "conformance/plugin_use.h"
#include "geometry/volume_properties.h"
#include "plugin/models.h"

using namespace flyrock;

namespace {

Contactor3 build(const std::string& name, const std::map<std::string, Given>& given, std::uint64_t seed = 1) {
  static const LuaSession session(FLYROCK_SHARE_DIR);
  const auto made = make<ShapeModel>(session, PluginKind::shape, name, given, 3);
  RandomStream rng(seed, "shape", {});
  return made.model->build_3d(made.values, rng).at(0);
}

}  // namespace

TEST_CASE("the norm blocks of 1 m3 have the published inertia") {
  const VolumeProperties cube = volume_properties({build("eota111", {{"length", std::cbrt(24.0 / 17)}})});
  CHECK(cube.volume == Approx(1).epsilon(1e-12));
  CHECK((cube.inertia - 0.155458 * Eigen::Matrix3d::Identity()).norm() < 2e-6);
  const VolumeProperties flat = volume_properties({build("eota221", {{"length", std::cbrt(48.0 / 17)}})});
  CHECK(flat.volume == Approx(1).epsilon(1e-12));
  CHECK((flat.inertia - Eigen::Matrix3d(Vec3(0.154233, 0.154233, 0.246774).asDiagonal())).norm() < 2e-6);
}

TEST_CASE("a drawn polyhedron has the volume of its sphere and the vertices asked for") {
  for (const double count : {6.0, 12.0, 40.0})
    for (std::uint64_t seed = 1; seed < 20; ++seed) {
      const Contactor3 rock =
          build("random_polyhedron", {{"vertices", count}, {"diameter", 0.5}, {"irregularity", 0.8}}, seed);
      CHECK(rock.points.size() == static_cast<std::size_t>(count));  // all lie on a sphere: none inside
      CHECK(volume_properties({rock}).volume == Approx(pi / 6 * 0.125).epsilon(1e-12));
    }
  const Contactor3 plate =
      build("random_polyhedron", {{"diameter", 1.0}, {"elongation", 0.9}, {"flatness", 0.2}});
  const Vec3 moments = volume_properties({plate}).inertia.diagonal();
  CHECK(moments.z() > 1.5 * moments.x());
}

TEST_CASE("a polyhedron by its points, from a text and an OBJ file") {
  const std::vector<std::vector<double>> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1, 0.1, 0.1}};
  const Contactor3 given = build("polyhedron", {{"points", points}});
  CHECK(given.points.size() == 4);
  CHECK(volume_properties({given}).volume == Approx(1.0 / 6));
  const std::string text = "tetrahedron_of_test.txt", obj = "tetrahedron_of_test.obj";
  std::ofstream(text) << "# x y z\n0 0 0\n1, 0, 0\n\n0 1 0\n0 0 1\n";
  std::ofstream(obj) << "# solid\nv 0 0 0\nv 1 0 0\nvn 0 0 1\nv 0 1 0\nv 0 0 1\nf 1 2 3\n";
  CHECK(build("polyhedron", {{"file", text.c_str()}}).points == given.points);
  CHECK(build("polyhedron", {{"file", obj.c_str()}}).points == given.points);
  std::ofstream(text) << "0 0 0\n1 0\n";
  CHECK_THROWS_WITH(build("polyhedron", {{"file", text.c_str()}}),
                    "plugin polyhedron: " + text + ":2: expected three numbers, x, y and z, found 2");
  std::remove(text.c_str());
  std::remove(obj.c_str());
  CHECK_THROWS_WITH(build("polyhedron", {}), "plugin polyhedron: expected either `points` or a `file`");
  CHECK_THROWS_WITH(
      build("polyhedron", {{"points", std::vector<std::vector<double>>(points.begin(), points.begin() + 3)}}),
      "plugin polyhedron: a polyhedron has 3 points, at least 4 are needed");
}
