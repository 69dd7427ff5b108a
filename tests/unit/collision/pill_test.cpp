// Pills against all shapes and the ground: contacts, gaps and times of impact against a search over the axis.

#include <catch2/catch.hpp>

#include "collision/ground/terrain_3d.h"
#include "collision/pairs.h"
#include "geometry/ground.h"
#include "geometry/hull.h"
#include "indexed.h"
#include "nearest_contact.h"
#include "samples.h"
#include "scratch.h"
#include "unit/collision/shots.h"

using namespace flyrock;

namespace pill_test {

namespace {

/// The place of a triangle that is nearest to p (Ericson, Real-Time Collision Detection, 5.1.5).
Vec3 nearest_of_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp),
               d6 = ac.dot(cp);
  if (d1 <= 0 && d2 <= 0) return a;
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  return a + vb / (va + vb + vc) * ab + vc / (va + vb + vc) * ac;
}

using Triangles = std::vector<std::array<Vec3, 3>>;

Triangles triangles_of(const Contactor3& shape) {
  Triangles triangles;
  for (const Contactor3::Face& face : shape.faces)
    for (int i = 1; i + 1 < face.count; ++i)
      triangles.push_back({shape.points[shape.vertex(face, 0)], shape.points[shape.vertex(face, i)],
                           shape.points[shape.vertex(face, i + 1)]});
  return triangles;
}

double distance_to(const Vec3& p, const Triangles& triangles) {
  double least = 1e300;
  for (const auto& [a, b, c] : triangles)
    least = std::min(least, (p - nearest_of_triangle(p, a, b, c)).squaredNorm());
  return std::sqrt(least);
}

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double s =
      along.squaredNorm() > 0 ? std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0;
  return (p - a - s * along).norm();
}

/// The least value over [0, 1] of a convex function.
template <class Function>
double least_of(const Function& f) {
  constexpr double golden = 0.3819660112501051;
  double low = 0, high = 1, s = golden, t = 1 - golden, at_s = f(s), at_t = f(t);
  while (high - low > 1e-6)
    if (at_s < at_t) {
      high = t;
      t = s;
      at_t = at_s;
      at_s = f(s = low + golden * (high - low));
    } else {
      low = s;
      s = t;
      at_s = at_t;
      at_t = f(t = high - golden * (high - low));
    }
  return std::min({at_s, at_t, f(0.0), f(1.0)});
}

/// A shape for the search: triangles in its own frame, or the axis of a core.
struct Searched {
  Contactor3 shape;
  Triangles triangles;
  explicit Searched(Contactor3 s) : shape(std::move(s)), triangles(triangles_of(shape)) {}

  /// The distance of a place from the surface of the core.
  double distance(const Placed3& placed, const Vec3& place) const {
    if (triangles.empty())
      return distance_to_segment(place, placed.point(0), placed.point(placed.count() - 1));
    return distance_to(placed.pose.r.inverse(place - placed.pose.x), triangles);
  }
};

/// The gap by a search along the axis of the pill.
double searched_gap(const Placed3& pill, const Searched& other, const Placed3& placed) {
  const Vec3 start = pill.point(0), along = pill.point(1) - start;
  return least_of([&](double s) { return other.distance(placed, start + s * along); }) - pill.shape.radius -
         placed.shape.radius;
}

/// Whether the axis of a pill comes within about a millimetre of the inside of a shape.
bool cores_meet(const Placed3& pill, const Placed3& other) {
  for (int i = 0; i <= 500; ++i) {
    const Vec3 place = pill.point(0) + i / 500.0 * (pill.point(1) - pill.point(0));
    double above = -1e300;
    for (int f = 0; f < other.faces(); ++f) above = std::max(above, other.outside(f, place));
    if (!other.shape.faces.empty() && above < 1e-3) return true;
  }
  return false;
}

Contactor3 pill_of(double length, double radius) {
  return Contactor3::pill({0, 0, -length / 2}, {0, 0, length / 2}, radius);
}

Contactor3 rock(Dice& dice, int vertices) {
  std::vector<Vec3> points;
  for (int i = 0; i < vertices; ++i) points.push_back(dice(0.3, 0.5) * dice.direction<3>());
  return convex_hull(points);
}

std::vector<Searched> others(Dice& dice) {
  std::vector<Searched> shapes;
  shapes.emplace_back(Contactor3::sphere(0.4));
  shapes.emplace_back(pill_of(1.2, 0.15));
  shapes.emplace_back(Contactor3::box({0.8, 0.5, 0.6}));
  shapes.emplace_back(rock(dice, 9));
  return shapes;
}

}  // namespace

TEST_CASE("pills and other shapes at 10,000 random placements have the gap, normal and places of a search") {
  Dice dice(7);
  const Contactor3 pill = pill_of(0.9, 0.2);
  const Searched searched_pill(pill);
  for (const Searched& other : others(dice)) {
    int wrong = 0, tested = 0;
    while (tested < samples(10'000)) {
      const Placed3 a{pill, {dice(0.2, 1.4) * dice.direction<3>(), dice.rotation<3>()}};
      const Placed3 b{other.shape, {Vec3::Zero(), dice.rotation<3>()}};
      const double gap = searched_gap(a, other, b), radii = pill.radius + other.shape.radius;
      if (gap < 0.1 - radii && cores_meet(a, b)) continue;
      ++tested;
      const bool turned = tested % 2;
      Contacts<3> contacts;
      if (turned)
        body_contacts(scratch(), b, indexed(a, 1), 10, contacts);
      else
        body_contacts(scratch(), a, indexed(b, 1), 10, contacts);
      REQUIRE_FALSE(contacts.empty());
      const ContactPoint<3>& c = nearest_of(contacts);
      const Vec3 on_a = c.point + (turned ? -0.5 : 0.5) * c.gap * c.normal, on_b = 2 * c.point - on_a;
      const double known = turned ? feature_gap(scratch(), b, c.feature, a, c.against)
                                  : feature_gap(scratch(), a, c.feature, b, c.against);
      wrong += std::abs(c.gap - gap) > 1e-9 || std::abs(known - gap) > 1e-9 ||
               std::abs(searched_pill.distance(a, on_a) - pill.radius) > 1e-9 ||
               std::abs(other.distance(b, on_b) - other.shape.radius) > 1e-9 ||
               std::abs(c.normal.norm() - 1) > 1e-12;
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("crossed pills have one contact, parallel pills two at the ends of what is common") {
  const Contactor3 pill = Contactor3::pill({-0.5, 0, 0}, {0.5, 0, 0}, 0.2);
  Contacts<3> contacts;
  body_contacts<3>(scratch(), {pill, {{0, 0, 0.4}, Rotation3::from_vector({0, 0, 0.3})}}, {pill, {}, 1}, 1e-6,
                   contacts);
  REQUIRE(contacts.size() == 1);
  CHECK(contacts[0].feature == feature_id(0, FeatureKind::edge, 0));
  CHECK(contacts[0].against == feature_id(1, FeatureKind::edge, 0));
  CHECK((contacts[0].point - Vec3(0, 0, 0.2)).norm() < 1e-15);

  contacts.clear();
  body_contacts<3>(scratch(), {pill, {{0.3, 0, 0.4}, {}}}, {pill, {}, 1}, 1e-6, contacts);
  REQUIRE(contacts.size() == 2);
  CHECK((contacts[0].point - Vec3(-0.2, 0, 0.2)).norm() < 1e-15);
  CHECK(contacts[0].feature == feature_id(0, FeatureKind::vertex, 0));
  CHECK((contacts[1].point - Vec3(0.5, 0, 0.2)).norm() < 1e-15);
  CHECK(contacts[1].against == feature_id(1, FeatureKind::vertex, 1));
  for (const auto& c : contacts) CHECK((c.normal - Vec3::UnitZ()).norm() < 1e-15);
}

TEST_CASE("a pill that lies on a box, and beyond its side, has two contacts with the face") {
  const Contactor3 pill = Contactor3::pill({-0.5, 0, 0}, {0.5, 0, 0}, 0.2);
  const Contactor3 box = Contactor3::box({1, 1, 1});
  for (const double x : {0.0, 0.3}) {
    Contacts<3> contacts;
    const Placed3 lying{pill, {{x, 0.1, 0.7}, {}}}, below{box, {}};
    body_contacts(scratch(), lying, indexed(below, 1), 1e-6, contacts);
    REQUIRE(contacts.size() == 2);
    CHECK((contacts[0].point - Vec3(x - 0.5, 0.1, 0.5)).norm() < 1e-12);
    CHECK((contacts[1].point - Vec3(0.5, 0.1, 0.5)).norm() < 1e-12);
    for (const auto& c : contacts) {
      CHECK((c.normal - Vec3::UnitZ()).norm() < 1e-15);
      CHECK(feature_gap(scratch(), lying, c.feature, below, c.against) == Approx(c.gap).margin(1e-12));
    }
    CHECK(kind_of(contacts[1].feature) == (x > 0 ? FeatureKind::edge : FeatureKind::vertex));
  }
}

namespace {

/// A ridge with a kink, a peak and a bench over level ground, and level ground in many triangles.
std::vector<Mesh> grounds() {
  const auto mesh = [](std::vector<Vec3> vertices, std::vector<std::array<int, 3>> triangles) {
    Mesh one;
    one.parts = {""};
    one.vertices = std::move(vertices);
    for (const auto& t : triangles) one.triangles.push_back({t[0], t[1], t[2]});
    one.part.assign(one.triangles.size(), 0);
    return one;
  };
  std::vector<Mesh> all;
  all.push_back(
      mesh({{-9, -9, -6}, {9, -9, -6}, {-9, 0, 0}, {0.2, 0.1, 0}, {9, 0, 0}, {-9, 9, -3}, {9, 9, -3}},
           {{0, 1, 3}, {0, 3, 2}, {1, 4, 3}, {2, 3, 5}, {3, 6, 5}, {3, 4, 6}}));
  all.push_back(mesh({{-9, -9, 0},
                      {9, -9, 0},
                      {9, 9, 0},
                      {-9, 9, 0},
                      {-1, -1, 0},
                      {1, -1, 0},
                      {1, 1, 0},
                      {-1, 1, 0},
                      {0.1, 0, 0.6}},
                     {{0, 1, 5},
                      {0, 5, 4},
                      {1, 2, 6},
                      {1, 6, 5},
                      {2, 3, 7},
                      {2, 7, 6},
                      {3, 0, 4},
                      {3, 4, 7},
                      {4, 5, 8},
                      {5, 6, 8},
                      {6, 7, 8},
                      {7, 4, 8}}));
  all.push_back(
      mesh({{-9, -9, 1}, {0, -9, 1}, {0.1, -9, 0}, {9, -9, 0}, {-9, 9, 1}, {0, 9, 1}, {0.1, 9, 0}, {9, 9, 0}},
           {{0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}}));
  Mesh level;
  level.parts = {""};
  for (int r = 0; r <= 6; ++r)
    for (int c = 0; c <= 6; ++c) level.vertices.push_back({2 * c - 6.0, 2 * r - 6.0, 0});
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c) {
      const int sw = 7 * r + c;
      level.triangles.push_back({sw, sw + 1, sw + 8});
      level.triangles.push_back({sw, sw + 8, sw + 7});
    }
  level.part.assign(level.triangles.size(), 0);
  all.push_back(level);
  return all;
}

/// The gap to the ground by a search along the axis, triangle by triangle.
double searched_gap(const Placed3& pill, const Triangles& ground) {
  const Vec3 start = pill.point(0), along = pill.point(1) - start;
  double least = 1e300;
  for (const auto& [a, b, c] : ground) {
    const double middle = (pill.pose.x - nearest_of_triangle(pill.pose.x, a, b, c)).norm();
    if (middle - pill.shape.bound > least) continue;
    least = std::min(least, least_of([&](double s) {
                              const Vec3 p = start + s * along;
                              return (p - nearest_of_triangle(p, a, b, c)).norm();
                            }) - pill.shape.radius);
  }
  return least;
}

Triangles triangles_of(const Mesh& mesh) {
  Triangles triangles;
  for (const auto& t : mesh.triangles)
    triangles.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
  return triangles;
}

bool is_below(const Placed3& pill, const Ground3& ground) {
  for (int i = 0; i <= 10; ++i)
    if (ground.depth(pill.point(0) + i / 10.0 * (pill.point(1) - pill.point(0))) > 0) return true;
  return false;
}

}  // namespace

TEST_CASE("pills at 10,000 random places over each ground have the gap of a search") {
  Dice dice(7);
  const Contactor3 pill = pill_of(0.9, 0.2);
  for (const Mesh& mesh : grounds()) {
    const Terrain3 terrain{TerrainShape3(mesh)};
    const Triangles triangles = triangles_of(mesh);
    int wrong = 0;
    for (int tested = 0; tested < samples(10'000);) {
      const Placed3 placed{pill, {{dice(-1.5, 1.5), dice(-1.5, 1.5), dice(-0.3, 1.6)}, dice.rotation<3>()}};
      if (is_below(placed, terrain.ground())) continue;
      const double gap = searched_gap(placed, triangles);
      if (gap > 0.5 || gap < 1e-3 - pill.radius) continue;
      ++tested;
      Contacts<3> contacts;
      terrain_contacts(scratch(), placed, terrain, 0.5, 0, contacts);
      if (contacts.empty()) {
        ++wrong;
        continue;
      }
      const ContactPoint<3>& c = nearest_of(contacts);
      const Vec3 on_ground = c.point - 0.5 * c.gap * c.normal, on_pill = c.point + 0.5 * c.gap * c.normal;
      wrong += std::abs(c.gap - gap) > 1e-9 || distance_to(on_ground, triangles) > 1e-9 ||
               std::abs(feature_gap(scratch(), placed, c.feature, terrain, c.against) - c.gap) > 1e-9 ||
               std::abs(distance_to_segment(on_pill, placed.point(0), placed.point(1)) - pill.radius) > 1e-9;
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("no shot pill passes through another shape, and it touches at gap 0") {
  Dice dice(7);
  const Contactor3 pill = pill_of(0.9, 0.2);
  constexpr double end = 0.03;
  TouchSearch search;
  search.size = pill.bound;
  std::uint64_t iterations = 0;
  search.iterations = &iterations;
  for (const Searched& other : others(dice)) {
    int wrong = 0, touches = 0;
    for (int i = 0; i < 100; ++i) {
      const Motion3 motion = shot(dice, {1, 1, 0.2});
      Motion3 others;
      others.rotation = FreeRotation({1, 1.2, 1.5}, dice.rotation<3>(), dice(0, 500) * dice.direction<3>());
      if (i % 2) others.v = dice(0, 100) * dice.direction<3>();
      const auto touch =
          i % 3 ? time_of_contact<3>(scratch(), {pill, motion}, {other.shape, others}, end, search)
                : time_of_contact<3>(scratch(), {other.shape, others}, {pill, motion}, end, search);
      touches += touch.has_value();
      wrong += !agrees(touch, end, 1e-9, 1e-8, [&](double t) {
        return searched_gap(at(pill, motion, t), other, at(other.shape, others, t));
      });
    }
    CHECK(wrong == 0);
    CHECK(touches > 20);
  }
  CHECK(iterations < 40 * 400);
}

TEST_CASE("no shot pill passes through the ground, and it touches at gap 0") {
  Dice dice(7);
  const Contactor3 pill = pill_of(0.9, 0.2);
  constexpr double end = 0.03;
  TouchSearch search;
  search.size = pill.bound;
  for (const Mesh& mesh : grounds()) {
    const Terrain3 terrain{TerrainShape3(mesh)};
    const Triangles triangles = triangles_of(mesh);
    int wrong = 0, touches = 0;
    for (int i = 0; i < 100; ++i) {
      Motion3 motion = shot(dice, {1, 1, 0.2});
      if (motion.x.z() < 0) motion.x = -motion.x, motion.v = -motion.v;
      motion.x.z() += 1.8;
      const auto touch = time_of_contact<3>(scratch(), {pill, motion}, terrain, end, search);
      if (touch && motion.position(*touch).head<2>().norm() > 4) continue;  // near the border
      touches += touch.has_value();
      wrong += !agrees(touch, end, 1e-9, 1e-8, [&](double t) {
        return motion.position(t).head<2>().norm() > 4 ? 0 : searched_gap(at(pill, motion, t), triangles);
      });
    }
    CHECK(wrong == 0);
    CHECK(touches > 15);
  }
}

}  // namespace pill_test
