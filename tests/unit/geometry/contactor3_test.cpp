#include "geometry/contactor3.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "dice.h"

using namespace flyrock;

TEST_CASE("the faces of a box close, point outwards and share its twelve edges") {
  const Contactor3 box = Contactor3::box({1, 2, 3});
  CHECK(box.points.size() == 8);
  CHECK(box.faces.size() == 6);
  REQUIRE(box.edges.size() == 12);
  CHECK(box.bound == Approx(std::sqrt(14.0) / 2));
  for (const Contactor3::Face& face : box.faces) {
    CHECK(face.normal.dot(box.points[box.vertex(face, 0)]) > 0);
    CHECK(face.normal.cwiseAbs().sum() == 1);
  }
  for (const Contactor3::Edge& edge : box.edges) {
    const Vec3 along = (box.points[edge.end] - box.points[edge.start]).normalized();
    // Outside, the left face is on the left: its normal, then the right one, turn about the edge.
    CHECK((box.faces[edge.left].normal.cross(box.faces[edge.right].normal) - along).norm() < 1e-15);
  }
}

TEST_CASE("a polyhedron that is none is refused") {
  const std::vector<Vec3> points{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  CHECK_THROWS_WITH(Contactor3::polyhedron(points, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}}),
                    "the faces of a polyhedron do not close");
  CHECK_THROWS_WITH(Contactor3::polyhedron(points, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 2, 3}}),
                    "two faces of a polyhedron run through an edge in one direction");
  CHECK_THROWS_WITH(Contactor3::polyhedron(points, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}),
                    "a polyhedron is not convex");  // inside out
  CHECK_THROWS_WITH(Contactor3::polyhedron({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}),
                    "a face of a polyhedron has no area");
}

TEST_CASE("a polyhedron with more edges than feature ids count is refused") {
  // A bipyramid over a polygon of n sides has 3 n edges.
  const auto bipyramid = [](int n) {
    std::vector<Vec3> points{{0, 0, 1}, {0, 0, -1}};
    std::vector<std::vector<int>> faces;
    for (int k = 0; k < n; ++k) {
      points.emplace_back(std::cos(2 * pi * k / n), std::sin(2 * pi * k / n), 0);
      const int a = 2 + k, b = 2 + (k + 1) % n;
      faces.push_back({a, b, 0});
      faces.push_back({b, a, 1});
    }
    return Contactor3::polyhedron(points, faces);
  };
  CHECK(bipyramid(100).edges.size() == 300);
  CHECK_THROWS_WITH(bipyramid(5462), "a polyhedron has 16386 edges, at most 16384 are possible");
}

TEST_CASE("the support of a circle is right to rounding, however level its cap") {
  Dice dice(7);
  for (int i = 0; i < 2000; ++i) {
    Contactor3::Circle circle;
    circle.centre = dice.direction<3>();
    circle.axis = dice.direction<3>();
    circle.radius = 0.2;
    Contactor3 disc;
    disc.circles.push_back(circle);
    const double sine = i % 3 == 0 ? 0 : std::pow(10, dice(-17, 0));
    const Vec3 side = circle.axis.unitOrthogonal();
    const Vec3 direction = std::sqrt(1 - sine * sine) * circle.axis + sine * side;
    const double expected = direction.dot(circle.centre) + circle.radius * sine;
    CHECK(std::abs(direction.dot(disc.support(direction)) - expected) < 1e-15);
    CHECK(std::abs((disc.support(direction) - circle.centre).dot(circle.axis)) < 5e-16);
  }
}
