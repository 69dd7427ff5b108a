#include <catch2/catch.hpp>
#include <cstdio>
#include <fstream>

#include "conformance/plugin_use.h"
#include "geometry/volume_properties.h"
#include "plugin/models.h"
#include "temporary_file.h"

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
  std::ofstream(obj)
      << "# solid\nv 0 0 0\nv 1 0 0\nvn 0 0 1\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  CHECK(build("polyhedron", {{"file", text.c_str()}}).points == given.points);
  CHECK(build("polyhedron", {{"file", obj.c_str()}}).points == given.points);
  std::ofstream(text) << "0 0 0\n1 0\n";
  CHECK_THROWS_WITH(build("polyhedron", {{"file", text.c_str()}}),
                    "plugin polyhedron: " + text + ":2:1: expected three numbers, x, y and z, found 2");
  std::remove(text.c_str());
  std::remove(obj.c_str());
  CHECK_THROWS_WITH(build("polyhedron", {}), "plugin polyhedron: expected either `points` or a `file`");
  CHECK_THROWS_WITH(
      build("polyhedron", {{"points", std::vector<std::vector<double>>(points.begin(), points.begin() + 3)}}),
      "plugin polyhedron: a polyhedron has 3 points, at least 4 are needed");
}

TEST_CASE("a polyhedron of a file is a closed convex surface, and the reason is given where it is not") {
  const std::string corners = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\n";
  const std::string bottom = "f 4 3 2 1\n", sides = "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  const std::string top = "f 5 6 7 8\n", dented = "v 1 1 1.5\nf 5 6 9\nf 6 7 9\nf 7 8 9\nf 8 5 9\n";
  const auto cube = [&](const std::string& text, const char* name = "cube.obj") {
    const TemporaryFile file(name, text);
    return build("polyhedron", {{"file", file.path.c_str()}});
  };
  const auto refused = [&](const std::string& text) -> std::string {
    try {
      cube(text);
    } catch (const PluginError& error) {
      const std::string found = error.what();
      CHECK(found.find("; expected a closed convex surface, a `compound` of convex parts, or a file") !=
            found.npos);
      const std::size_t begin = found.find(".obj: ") + 6;
      return found.substr(begin, found.find(';') - begin);
    }
    return "";
  };
  CHECK(volume_properties({cube(corners + bottom + sides + top)}).volume == Approx(8).epsilon(1e-14));
  CHECK(volume_properties({cube(corners)}).volume == Approx(8).epsilon(1e-14));  // the hull of its vertices
  CHECK(refused(corners + bottom + sides + dented) ==
        "it is not convex: its vertex (1, 1, 1.5) lies 0.5 m inside the hull of the others");
  CHECK(refused(corners + "v 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\n" + bottom + sides + top +
                "f 9 11 10\nf 9 10 12\nf 10 11 12\nf 11 9 12\n")
            .starts_with("it is not convex: "));
  CHECK(refused(corners + bottom + sides) ==
        "the edge from (0, 0, 2) to (2, 0, 2) has 1 triangle, expected two: a surface that closes");
  CHECK(refused(corners + "f 1 2 3 4\n" + sides + top) ==
        "the edge from (0, 0, 0) to (2, 0, 0) has triangles that face opposite ways, expected all to face "
        "outwards");
  CHECK(refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n") ==
        "its faces look inwards, expected their corners counter-clockwise, seen from outside");
  CHECK(refused(corners + bottom + sides + top + "f 5 6 6\n") ==
        "the triangle (0, 0, 2), (2, 0, 2), (2, 0, 2) in line 15 has no area");
  const std::string facets =
      "solid t\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n"
      "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\n"
      "facet normal 0 0 0\nouter loop\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\n"
      "facet normal 0 0 0\nouter loop\nvertex 0 1 0\nvertex 0 0 0\nvertex 0 0 1\nendloop\nendfacet\nendsolid "
      "t\n";
  CHECK(volume_properties({cube(facets, "tetrahedron.stl")}).volume == Approx(1.0 / 6).epsilon(1e-14));
}
