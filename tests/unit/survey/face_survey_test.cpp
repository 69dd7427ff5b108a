#include "survey/face_survey.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "geometry/delaunay.h"
#include "random/stream.h"

using namespace flyrock;

namespace {

/// Points of a face 10 m high and 20 m wide that leans by `slope` m per m, with errors in its direction x.
std::vector<Vec3> leaning_face(double slope, double sd, std::uint64_t seed) {
  RandomStream rng(seed, "face", {});
  std::vector<Vec3> points;
  for (int i = 0; i <= 80; ++i)
    for (int k = 0; k <= 40; ++k) {
      const double y = 0.25 * i - 10 + rng.uniform(-0.05, 0.05), z = -0.25 * k + rng.uniform(-0.05, 0.05);
      double error = 0;  // the sum of twelve uniform numbers is nearly normal
      for (int n = 0; n < 12; ++n) error += rng.uniform(-0.5, 0.5);
      points.emplace_back(-slope * z + sd * error, y, z);
    }
  return points;
}

/// The distance of the charge from x = -b, z = -3 to z = -9 to that face.
double burden_of(double slope, double b) { return (b + 3 * slope) / std::sqrt(1 + slope * slope); }

}  // namespace

TEST_CASE("no circle about a triangle holds another point") {
  RandomStream rng(3, "points", {});
  std::vector<Vec2> points;
  for (int i = 0; i < 60; ++i) points.emplace_back(rng.uniform(), rng.uniform());
  const auto triangles = delaunay(points);
  std::set<std::array<int, 3>> known;
  for (const auto& [a, b, c] : triangles) {
    const Vec2 u = points[b] - points[a], v = points[c] - points[a];
    const double area = cross(u, v);
    REQUIRE(area > 0);
    const Vec2 centre = points[a] + Vec2(v.y() * u.squaredNorm() - u.y() * v.squaredNorm(),
                                         u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) /
                                        (2 * area);
    const double radius = (centre - points[a]).norm();
    for (const Vec2& p : points) CHECK((p - centre).norm() >= radius * (1 - 1e-9));
    known.insert({a, b, c});
  }
  CHECK(known.size() == triangles.size());
  CHECK_THROWS_AS(delaunay({{0, 0}, {1, 1}, {2, 2}}), std::invalid_argument);
  // A square lattice has many circles through four points.
  std::vector<Vec2> lattice;
  for (int i = 0; i < 100; ++i) lattice.emplace_back(i % 10, i / 10);
  CHECK(delaunay(lattice).size() == 2 * 9 * 9);
}

TEST_CASE("the least burden of a plane face") {
  RandomStream rng(5, "faces", {});
  for (int i = 0; i < 30; ++i) {
    const double slope = rng.uniform(0, 0.5), b = rng.uniform(1, 5);
    const std::vector<Vec3> charge{{-b, 0.3, -3}, {-b, 0.3, -6}, {-b, 0.3, -9}};
    const FaceSurvey points(leaning_face(slope, 0, 7));
    CHECK(points.distance_to(charge) == Approx(burden_of(slope, b)).epsilon(1e-9));
    CHECK(points.noise() < 1e-9);
    Mesh mesh;
    mesh.vertices = {{10 * slope, -10, -10}, {10 * slope, 10, -10}, {0, 10, 0}, {0, -10, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    const FaceSurvey plane(mesh);
    CHECK(plane.distance_to(charge) == Approx(burden_of(slope, b)).epsilon(1e-9));
    CHECK(plane.nearest({-b, 0.3, -5}).is_inside);
    CHECK(plane.nearest({-b, 0.3, -5}).distance == Approx((b + 5 * slope) / std::sqrt(1 + slope * slope)));
    CHECK_FALSE(plane.nearest({-b, 30, -5}).is_inside);
    CHECK_FALSE(plane.nearest({-b, 0.3, 4}).is_inside);
  }
}

TEST_CASE("the least burden of a bulge and of a corner of the face") {
  Mesh mesh;  // a bulge: the vertex (0, 0, -5) stands out of a face at x = 1
  mesh.vertices = {{1, -5, -10}, {1, 5, -10}, {1, 5, 0}, {1, -5, 0}, {0, 0, -5}};
  mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  const FaceSurvey bulge(mesh);
  CHECK(bulge.distance_to({{-3, 0, 0}, {-3, 0, -9}}) == Approx(3).epsilon(1e-12));
  CHECK(bulge.distance_to({{-3, 0, -6}, {-3, 0, -9}}) == Approx(3.2 / std::sqrt(1.04)).epsilon(1e-12));
  CHECK(bulge.distance_to({{-3, 2, 0}, {-3, 2, -9}}) ==
        Approx((3 + 2 * 0.2) / std::sqrt(1 + 0.04)).epsilon(1e-9));
  CHECK(bulge.nearest({-3, 0, -5}).is_inside);
  // A hole that goes through the face.
  CHECK(bulge.distance_to({{-3, 1, -4}, {3, 1, -4}}) == 0);
}

TEST_CASE("the least burden of a noisy scan lies within its stated error") {
  int inside = 0;
  constexpr int scans = 20;
  for (int seed = 0; seed < scans; ++seed) {
    const FaceSurvey scan(leaning_face(0.35, 0.03, static_cast<std::uint64_t>(seed)));
    // The noise is normal to the face.
    const double sd = 0.03 / std::sqrt(1 + 0.35 * 0.35);
    CHECK(scan.noise() == Approx(sd).epsilon(0.1));
    CHECK(scan.error_of_least() < 6 * sd);
    const double found = scan.distance_to({{-2.7, 0.1, -3}, {-2.7, 0.1, -9}});
    inside += std::abs(found - burden_of(0.35, 2.7)) <= scan.error_of_least();
  }
  CHECK(inside == scans);
}

TEST_CASE("a survey with a gap does not close it") {
  std::vector<Vec3> points;
  for (const Vec3& p : leaning_face(0.2, 0, 9))
    if (std::abs(p.y()) > 2.5) points.push_back(p);  // 5 m without points
  const FaceSurvey survey(points);
  CHECK_FALSE(survey.nearest({-3, 0, -5}).is_inside);
  CHECK(survey.nearest({-3, 6, -5}).is_inside);
}
