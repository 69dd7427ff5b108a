// Contactors: areas, centroids and moments against closed forms, and what is no convex polygon.

#include "geometry/contactor.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

using namespace flyrock;

namespace {

std::vector<Vec2> regular(int sides, double circumradius, const Vec2& centre) {
  std::vector<Vec2> vertices;
  for (int k = 0; k < sides; ++k)
    vertices.push_back(centre + circumradius * (Rotation2::from_angle(2 * pi * k / sides) * Vec2::UnitX()));
  return vertices;
}

void check(const AreaProperties& computed, double area, const Vec2& centroid, double polar_moment) {
  CHECK(computed.area == Approx(area).epsilon(1e-12));
  CHECK((computed.centroid - centroid).norm() <= 1e-13 * (1 + centroid.norm()));
  CHECK(computed.polar_moment == Approx(polar_moment).epsilon(1e-12));
  CHECK(computed.second_moments.trace() == Approx(polar_moment).epsilon(1e-9));
}

}  // namespace

TEST_CASE("area properties of a rectangle, far from the origin too") {
  for (const Vec2& corner : {Vec2(0, 0), Vec2(1000, -500)}) {
    const auto box =
        Contactor2::polygon({corner, corner + Vec2(3, 0), corner + Vec2(3, 2), corner + Vec2(0, 2)});
    check(area_properties({box}), 6, corner + Vec2(1.5, 1), 6 * (9 + 4) / 12.0);
  }
}

TEST_CASE("area properties of a triangle") {
  const Vec2 a(0, 0), b(4, 0), c(1, 3);
  // J = A/36 (sum of squared sides) for any triangle
  const double sides = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  check(area_properties({Contactor2::polygon({a, b, c})}), 6, (a + b + c) / 3, 6 * sides / 36);
}

TEST_CASE("area properties of a disk and of regular polygons") {
  const Vec2 centre(2, -1);
  check(area_properties({Contactor2::disk(0.5, centre)}), pi * 0.25, centre, pi * 0.0625 / 2);
  for (int n : {3, 4, 5, 8, 100}) {
    const double r = 0.7, half = pi / n;
    const double area = n / 2.0 * r * r * std::sin(2 * half);
    // J = A r^2/6 (1 + 2 cos^2(pi/n))
    const double polar = area * r * r / 6 * (1 + 2 * std::pow(std::cos(half), 2));
    check(area_properties({Contactor2::polygon(regular(n, r, centre))}), area, centre, polar);
  }
}

TEST_CASE("area properties of a wall with rounded ends") {
  const double length = 2, r = 0.25;
  auto wall = Contactor2::polygon({Vec2(-1, 0), Vec2(1, 0)});
  wall.radius = r;
  const double area = 2 * r * length + pi * r * r;
  const double polar = 2 * r * length * (length * length + 4 * r * r) / 12 + pi * std::pow(r, 4) / 2 +
                       4.0 / 3 * length * std::pow(r, 3) + pi * r * r * length * length / 4;
  const AreaProperties computed = area_properties({wall});
  check(computed, area, Vec2::Zero(), polar);
  // Across its axis: a rectangle, and a disk in two halves.
  const double across = 2 * r * length * 4 * r * r / 12 + pi * std::pow(r, 4) / 4;
  CHECK(computed.second_moments(1, 1) == Approx(across).epsilon(1e-12));
  CHECK(std::abs(computed.second_moments(0, 1)) < 1e-15);
}

TEST_CASE("area properties of several contactors add up about the common centroid") {
  const auto dumb_bell = area_properties({Contactor2::disk(1, {-3, 0}), Contactor2::disk(1, {3, 0})});
  check(dumb_bell, 2 * pi, Vec2::Zero(), 2 * (pi / 2 + 9 * pi));
}

TEST_CASE("a body in 2D has the volume of the sphere of equal cross-section") {
  const double r = 0.3;
  CHECK(default_thickness(pi * r * r) * pi * r * r == Approx(4.0 / 3 * pi * r * r * r).epsilon(1e-14));
}

TEST_CASE("contactors know their extent and move") {
  auto square = Contactor2::polygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  CHECK(square.bound == Approx(std::sqrt(2.0)));
  CHECK((square.normals[0] - Vec2(0, -1)).norm() < 1e-15);
  square.translate({1, 1});
  CHECK(square.bound == Approx(std::sqrt(8.0)));
  CHECK(Contactor2::disk(0.5, {3, 4}).bound == Approx(5.5));
}

TEST_CASE("make_convex turns vertices round and names what is wrong") {
  std::vector<Vec2> clockwise{{0, 0}, {0, 1}, {1, 1}, {1, 0}};
  CHECK(make_convex(clockwise).empty());
  CHECK(clockwise.front() == Vec2(1, 0));
  auto fault = [](std::vector<Vec2> vertices) { return make_convex(vertices); };
  CHECK(fault({{0, 0}, {1, 0}}) == "a polygon has 2 vertices, at least 3 are needed");
  CHECK(fault(regular(32768, 1, Vec2::Zero())).empty());
  CHECK(fault(regular(32769, 1, Vec2::Zero())) == "a polygon has 32769 vertices, at most 32768 are possible");
  CHECK(fault({{0, 0}, {1, 0}, {1, 0}, {0, 1}}) == "a polygon has the vertex (1, 0) twice");
  CHECK(fault({{0, 0}, {1, 0}, {2, 0}, {0, 1}}) ==
        "the polygon's vertex (1, 0) lies on the straight line between its neighbours; leave it out");
  CHECK(fault({{0, 0}, {1, 0}, {3, 0}}) == "the polygon has no area");
  CHECK(fault({{0, 0}, {4, 0}, {1, 1}, {0, 4}}) == "the polygon is not convex at the vertex (1, 1)");
  std::vector<Vec2> star;
  for (int k = 0; k < 5; ++k) star.push_back(Rotation2::from_angle(4 * pi * k / 5) * Vec2::UnitX());
  CHECK(fault(star) == "the polygon is not convex: its edges cross");
}

TEST_CASE("the eight-sided rock of the peer measurements has its mass and inertia", "[data]") {
  std::ifstream file(FLYROCK_SOURCE_DIR "/../shared/data/scenes/rock8.txt");
  if (!file) {
    WARN("SKIPPED: no field data beside the project");
    return;
  }
  double mass = 0, inertia = 0;
  std::vector<Vec2> vertices;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string hash, key;
    if (line.starts_with("#")) {
      words >> hash >> key;
      if (key == "mass") words >> mass;
      if (key == "inertia") words >> inertia;
    } else if (double x, y; words >> x >> y) {
      vertices.emplace_back(x, y);
    }
  }
  REQUIRE(make_convex(vertices).empty());
  const auto rock = area_properties({Contactor2::polygon(vertices)});
  CHECK(2700 * rock.area == Approx(mass).epsilon(1e-8));
  CHECK(2700 * rock.polar_moment == Approx(inertia).epsilon(1e-8));
  CHECK(rock.centroid.norm() < 1e-8);
}
