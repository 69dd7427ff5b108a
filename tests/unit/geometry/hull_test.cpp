#include "geometry/hull.h"

#include <catch2/catch.hpp>
#include <random>
#include <stdexcept>

#include "geometry/volume_properties.h"

using namespace flyrock;

TEST_CASE("the hull of a cube's corners, edge middles and centre is the cube, far from the origin too") {
  for (const Vec3& at : {Vec3(0, 0, 0), Vec3(5e5, -2e6, 300)}) {
    std::vector<Vec3> points;
    for (int i = 0; i < 27; ++i) points.push_back(at + Vec3(i % 3, i / 3 % 3, i / 9));
    const Contactor3 hull = convex_hull(points);
    CHECK(hull.points.size() == 8);
    CHECK(hull.faces.size() == 6);
    CHECK(hull.edges.size() == 12);
    CHECK(volume_properties({hull}).volume == Approx(8).epsilon(1e-12));
  }
}

TEST_CASE("the EOTA block: 24 vertices, 26 faces, 17/24 of the cube") {
  const Contactor3 block = norm_block({1, 1, 1});
  CHECK(block.points.size() == 24);
  CHECK(block.faces.size() == 26);
  CHECK(block.edges.size() == 48);
  CHECK(volume_properties({block}).volume == Approx(17.0 / 24).epsilon(1e-14));
}

TEST_CASE("the hull of random points closes, and holds them all") {
  std::mt19937 generator(5);
  std::normal_distribution<double> draw;
  for (int round = 0; round < 50; ++round) {
    std::vector<Vec3> points;
    for (int i = 0; i < 4 + round; ++i)
      points.push_back({draw(generator), draw(generator), 0.1 * draw(generator)});
    const Contactor3 hull = convex_hull(points);
    CHECK(hull.points.size() + hull.faces.size() == hull.edges.size() + 2);  // Euler
    for (const Contactor3::Face& face : hull.faces)
      for (const Vec3& p : points) CHECK(face.normal.dot(p - hull.points[hull.vertex(face, 0)]) < 1e-12);
  }
}

TEST_CASE("points without a hull are refused") {
  CHECK_THROWS_WITH(convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}),
                    "a polyhedron has 3 points, at least 4 are needed");
  CHECK_THROWS_WITH(convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}),
                    "the points of a polyhedron lie in one plane");
  CHECK_THROWS_WITH(convex_hull({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}),
                    "the points of a polyhedron lie in one plane");
}
