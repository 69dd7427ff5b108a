// Cylinders against all shapes and the ground: contacts, gaps and times of impact against certificates.
//
// A certificate of a gap d >= 0 with the normal n: a place of each shape, d apart, bounds the distance from
// above; the supports of both along n, d apart, bound it from below. Both are closed forms that are written
// here once more.

#include <catch2/catch.hpp>

#include "collision/ground/terrain_3d.h"
#include "collision/pairs.h"
#include "collision/smooth/facing_pair.h"
#include "collision/smooth/gjk.h"
#include "collision/smooth/support_feature.h"
#include "geometry/cone.h"
#include "geometry/hull.h"
#include "indexed.h"
#include "nearest_contact.h"
#include "samples.h"
#include "scratch.h"
#include "unit/collision/shots.h"

using namespace flyrock;

namespace cylinder_test {

namespace {

/// The place of a core that is nearest to p, in its frame.
Vec3 nearest_in(const Contactor3& shape, const Vec3& p) {
  if (shape.circles.size() == 1) {  // a cone: in a plane through its axis, a triangle
    const double radius = shape.circles[0].radius, low = shape.circles[0].centre.z();
    const Vec2 place(p.head<2>().norm(), p.z()), rim(radius, low), top(0, shape.points[0].z());
    const auto nearest_on = [&](const Vec2& from, const Vec2& to) -> Vec2 {
      return from +
             std::clamp((place - from).dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0) * (to - from);
    };
    if (place.y() >= low && cross(top - rim, place - rim) >= 0) return p;
    const Vec2 base = nearest_on({0, low}, rim), side = nearest_on(rim, top);
    const Vec2 nearest = (base - place).norm() < (side - place).norm() ? base : side;
    const double scale = place.x() > 0 ? nearest.x() / place.x() : 0;
    return {scale * p.x(), scale * p.y(), nearest.y()};
  }
  if (!shape.circles.empty()) {  // a cylinder about the origin
    const double radius = shape.circles[0].radius, half = std::abs(shape.circles[0].centre.z());
    const double out = p.head<2>().norm(), scale = out > radius ? radius / out : 1;
    return {scale * p.x(), scale * p.y(), std::clamp(p.z(), -half, half)};
  }
  if (shape.faces.empty()) {
    const Vec3 start = shape.points.front(), along = shape.points.back() - start;
    const double square = along.squaredNorm();
    return start + (square > 0 ? std::clamp((p - start).dot(along) / square, 0.0, 1.0) : 0) * along;
  }
  // Only whether p is inside, or how far it is above the planes, is needed.
  Vec3 place = p;
  for (const Contactor3::Face& face : shape.faces) {
    const double above = face.normal.dot(place - shape.points[shape.vertex(face, 0)]);
    if (above > 0) place -= above * face.normal;
  }
  return place;
}

/// How far a place is outside of the shape [m].
double outside(const Placed3& placed, const Vec3& place) {
  const Vec3 local = placed.pose.r.inverse(place - placed.pose.x);
  return (local - nearest_in(placed.shape, local)).norm() - placed.shape.radius;
}

/// How far a shape reaches along a direction [m].
double reach(const Placed3& placed, const Vec3& direction) {
  const Vec3 local = placed.pose.r.inverse(direction);
  double most = -1e300;
  if (placed.shape.circles.size() == 1)
    most = placed.shape.circles[0].radius * local.head<2>().norm() +
           placed.shape.circles[0].centre.z() * local.z();
  else if (!placed.shape.circles.empty())
    most = placed.shape.circles[0].radius * local.head<2>().norm() +
           std::abs(placed.shape.circles[0].centre.z() * local.z());
  for (const Vec3& point : placed.shape.points) most = std::max(most, local.dot(point));
  return direction.dot(placed.pose.x) + most + placed.shape.radius;
}

double separation_along(const Placed3& a, const Placed3& b, const Vec3& normal) {
  return -reach(a, -normal) - reach(b, normal);
}

Contactor3 rock(Dice& dice, int vertices) {
  std::vector<Vec3> points;
  for (int i = 0; i < vertices; ++i) points.push_back(dice(0.3, 0.5) * dice.direction<3>());
  return convex_hull(points);
}

std::vector<Contactor3> others(Dice& dice) {
  return {Contactor3::sphere(0.4),          Contactor3::pill({0, 0, -0.6}, {0, 0, 0.6}, 0.15),
          Contactor3::box({0.8, 0.5, 0.6}), rock(dice, 9),
          Contactor3::cylinder(0.25, 0.9),  cone(0.3, 0.7)};
}

}  // namespace

TEST_CASE("cylinders at 10,000 random placements have a gap, a normal and places that certify each other",
          "[slow]") {
  Dice dice(11);
  for (const Contactor3& cylinder : {Contactor3::cylinder(0.3, 0.7), Contactor3::cylinder(0.5, 0.04)})
    for (const Contactor3& other : others(dice)) {
      int wrong = 0, separate = 0, precise = 0, exact = 0;
      for (int tested = 0; tested < 1000; ++tested) {
        Placed3 a{cylinder, {dice(0.3, 1.4) * dice.direction<3>(), dice.flush_rotation<3>()}};
        const Placed3 b{other, {Vec3::Zero(), dice.flush_rotation<3>()}};
        const bool turned = tested % 2;
        const auto find = [&](Contacts<3>& contacts) {
          if (turned)
            body_contacts(scratch(), b, indexed(a, 1), 10, contacts);
          else
            body_contacts(scratch(), a, indexed(b, 1), 10, contacts);
        };
        Contacts<3> contacts;
        find(contacts);
        REQUIRE_FALSE(contacts.empty());
        REQUIRE(contacts.size() <= 4);
        ContactPoint<3> c = nearest_of(contacts);
        const Vec3 n = turned ? -c.normal : c.normal;  // from b to a
        const double apart = separation_along(a, b, n);
        bool good = std::abs(n.norm() - 1) < 1e-12;
        if (c.gap > 0) {
          ++separate;
          const Vec3 on_a = c.point + 0.5 * c.gap * n, on_b = c.point - 0.5 * c.gap * n;
          const double error = std::max({std::abs(apart - c.gap), outside(a, on_a), outside(b, on_b)});
          // A plane gives its normal to what is flush to 1e-4.
          precise += error < 1e-9;
          const double room = c.gap;
          good = good && error < 1e-4 * other.bound;
          const double known = turned ? feature_gap(scratch(), b, c.feature, a, c.against, c.normal)
                                      : feature_gap(scratch(), a, c.feature, b, c.against, c.normal);
          good = good && std::abs(known - c.gap) < 1e-9;
          // As near, and as deep, as a solver may leave it.
          const double depth = std::pow(10, dice(-11, -4)) * (tested % 4 < 2 ? 1 : -1);
          a.pose.x -= (c.gap + depth) * n;
          contacts.clear();
          find(contacts);
          c = nearest_of(contacts);
          const Vec3 now = turned ? -c.normal : c.normal;
          const Vec3 above = c.point + 0.5 * c.gap * now, below = c.point - 0.5 * c.gap * now;
          // Where corners meet, all normals of their cones serve; none may show more room than there is.
          good = good && c.gap < std::max(-depth, 0.0) + 1e-10 + 1e-6 * room &&
                 c.gap > -depth - 1e-6 - 1e-4 * room &&
                 std::abs(separation_along(a, b, now) - c.gap) < 1e-11 && outside(a, above) < 1e-6 &&
                 outside(b, below) < 1e-6;
          exact += std::abs(c.gap + depth) < 1e-10 && outside(a, above) < 1e-9 && outside(b, below) < 1e-9;
        } else {
          good = good && std::abs(apart - c.gap) < 1e-9 - 1e-3 * c.gap;
        }
        wrong += !good;
      }
      CHECK(wrong == 0);
      CHECK(separate > 200);
      CHECK(precise > 0.98 * separate);
      CHECK(exact > 0.8 * separate);
    }
}

namespace {

/// How deep the lowest of many places of the rims is in the ground, times -1 [m]; 0 above it.
double height_over(const Ground3& ground, const Placed3& placed) {
  constexpr int places = 100;
  double least = 1e300;
  for (const Contactor3::Circle& circle : placed.shape.circles)
    for (int i = 0; i < places; ++i) {
      const Vec3 out = Vec3(std::cos(2 * pi * i / places), std::sin(2 * pi * i / places), 0);
      const Vec3 p = placed.pose * (circle.centre + circle.radius * out);
      least = std::min(least, -ground.depth(p));
    }
  return least;
}

Mesh ridge_with_peak() {
  Mesh mesh;
  mesh.parts = {""};
  mesh.vertices = {{-9, -9, -6}, {9, -9, -6}, {-9, 0, 0}, {0.2, 0.1, 0}, {9, 0, 0}, {-9, 9, -3}, {9, 9, -3}};
  mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {1, 4, 3}, {2, 3, 5}, {3, 6, 5}, {3, 4, 6}};
  mesh.part.assign(mesh.triangles.size(), 0);
  return mesh;
}

}  // namespace

TEST_CASE("no shot cylinder passes through another shape, and it touches at gap 0") {
  Dice dice(11);
  constexpr double end = 0.03;
  TouchSearch search;
  std::uint64_t iterations = 0;
  search.iterations = &iterations;
  for (const double scale : {0.01, 1.0, 5.0})
    for (const Contactor3& other : others(dice)) {
      const Contactor3 cylinder = Contactor3::cylinder(0.3 * scale, scale * dice(0.05, 0.9));
      search.size = cylinder.bound;
      int wrong = 0, touches = 0;
      for (int i = 0; i < 60; ++i) {
        Motion3 motion = shot(dice, {1, 1, 0.7}, &Dice::flush_rotation<3>), others;
        motion.x *= std::max(1.0, scale);
        others.rotation =
            FreeRotation({1, 1.2, 1.5}, dice.flush_rotation<3>(), dice(0, 500) * dice.direction<3>());
        const auto touch =
            i % 3 ? time_of_contact<3>(scratch(), {cylinder, motion}, {other, others}, end, search)
                  : time_of_contact<3>(scratch(), {other, others}, {cylinder, motion}, end, search);
        touches += touch.has_value();
        wrong += !agrees(touch, end, 1e-9, 1e-8, [&](double t) {
          const Placed3 a = at(cylinder, motion, t), b = at(other, others, t);
          return separation_along(a, b, separation(a, b).normal);
        });
      }
      CHECK(wrong == 0);
      CHECK(touches > 0);
    }
  CHECK(iterations < 60 * 900);
}

TEST_CASE(
    "a cylinder or cone that spins about its own axis touches when a still one does, after as many steps") {
  Dice dice(11);
  constexpr double end = 0.05;
  const Terrain3 terrain{TerrainShape3(ridge_with_peak())};
  const Motion3 rest;
  for (const Contactor3& shape :
       {Contactor3::cylinder(0.5, 0.3), Contactor3::cylinder(0.005, 1.5), cone(0.3, 0.7)})
    for (const Contactor3& other : others(dice)) {
      std::uint64_t steps[2] = {0, 0};
      int touches = 0;
      for (int i = 0; i < 20; ++i) {
        const Rotation3 attitude = Rotation3::from_vector(dice(0, pi) * dice.direction<3>());
        std::optional<double> touch[2], lands[2];
        for (const bool spins : {false, true}) {
          Motion3 motion = shot(dice, {1, 1, 0.7}, &Dice::flush_rotation<3>);
          motion.x = 2.0 * (attitude * Vec3::UnitX());
          motion.v = -60 * motion.x.normalized() + Vec3(3, 1, 0);
          motion.rotation =
              FreeRotation({1, 1, 0.7}, attitude, (spins ? 500 : 0) * (attitude * Vec3::UnitZ()));
          TouchSearch search;
          search.size = shape.bound;
          search.iterations = &steps[spins];
          touch[spins] = time_of_contact<3>(scratch(), {shape, motion}, {other, rest}, end, search);
          motion.x += Vec3(0, 0, 3);
          lands[spins] = time_of_contact<3>(scratch(), {shape, motion}, terrain, end, search);
        }
        REQUIRE(touch[0].has_value() == touch[1].has_value());
        REQUIRE(lands[0].has_value() == lands[1].has_value());
        if (touch[0]) CHECK(*touch[0] == Approx(*touch[1]).margin(1e-9));
        if (lands[0]) CHECK(*lands[0] == Approx(*lands[1]).margin(1e-9));
        touches += touch[0].has_value() + lands[0].has_value();
      }
      CHECK(touches > 5);
      CHECK(steps[1] <= steps[0] * 1.1);
    }
}

TEST_CASE("a cap that lies nearly flush on an edge has the gaps of its rim") {
  // The edge is the x axis from -1 to 1. The cap is so tilted that the end of the edge lies below its plane,
  // beyond the rim.
  constexpr double radius = 0.5, gap = 1e-5, tilt = 3e-5;
  const Contactor3 roof =
      convex_hull({{-1, 0, 0}, {1, 0, 0}, {-1, -1, -0.5}, {1, -1, -0.5}, {-1, 1, -0.5}, {1, 1, -0.5}});
  const Contactor3 cylinder = Contactor3::cylinder(radius, 0.4);
  Motion3 motion, rest;
  const Rotation3 turn = Rotation3::from_vector({0, tilt, 0});
  motion.rotation = FreeRotation({1, 1, 0.7}, turn, Vec3::Zero());
  motion.x = Vec3(0, 0, gap) - turn * Vec3(radius, 0, -0.2);
  motion.x.x() = 0;
  motion.v = {0, 0, -1};
  const Placed3 a = at(cylinder, motion, 0), b = at(roof, rest, 0);
  CHECK(separation_along(a, b, facing_pair(a, b).normal) < 0);
  CHECK(facing_pair(a, b).apart.distance == Approx(gap).margin(1e-9));
  Contacts<3> contacts;
  body_contacts(scratch(), a, b, 1e-3, contacts);
  REQUIRE(contacts.size() == 2);
  for (const ContactPoint<3>& c : contacts) {
    CHECK(c.gap == Approx(c.point.x() > 0 ? gap : gap + 2 * radius * tilt).margin(1e-9));
    CHECK(feature_gap<3>(scratch(), a, c.feature, b, c.against, c.normal) == Approx(c.gap).margin(1e-12));
  }
  TouchSearch search;
  search.size = cylinder.bound;
  const auto touch = time_of_contact<3>(scratch(), {cylinder, motion}, {roof, rest}, 1, search);
  REQUIRE(touch);
  CHECK(*touch == Approx(gap).margin(1e-9));
}

TEST_CASE("no shot cylinder passes through the ground, and it touches at gap 0", "[slow]") {
  Dice dice(11);
  constexpr double end = 0.03;
  TouchSearch search;
  Plane level;
  for (const TerrainShape3& shape : {TerrainShape3(level), TerrainShape3(ridge_with_peak())}) {
    const Terrain3 terrain{shape};
    int wrong = 0, touches = 0;
    for (int i = 0; i < 450; ++i) {
      const double scale = std::pow(10, dice(-2, 0));
      const Contactor3 cylinder = Contactor3::cylinder(0.5 * scale, scale * dice(0.05, 0.9));
      search.size = cylinder.bound;
      Motion3 motion = shot(dice, {1, 1, 0.7}, &Dice::flush_rotation<3>);
      if (motion.x.z() < 0) motion.x = -motion.x, motion.v = -motion.v;
      motion.x.z() += 1.8;
      const auto touch = time_of_contact<3>(scratch(), {cylinder, motion}, terrain, end, search);
      if (touch && motion.position(*touch).head<2>().norm() > 4) continue;  // near the border
      touches += touch.has_value();
      bool good = true;
      for (int k = 0; k <= 60; ++k) {
        const double t = touch.value_or(end) * k / 60;
        if (motion.position(t).head<2>().norm() < 4)
          good = good && height_over(terrain.ground(), at(cylinder, motion, t)) > -1e-9;
      }
      if (touch) {
        Contacts<3> contacts;
        terrain_contacts(scratch(), at(cylinder, motion, *touch), terrain, 1e-8, 0, contacts);
        good = good && !contacts.empty() && std::abs(nearest_of(contacts).gap) < 1e-8;
      }
      wrong += !good;
    }
    CHECK(wrong == 0);
    CHECK(touches > 60);
  }
}

TEST_CASE("cylinders at random places over a ridge with a peak have the gap of its nearest triangle") {
  Dice dice(11);
  const Mesh mesh = ridge_with_peak();
  const Terrain3 terrain{TerrainShape3(mesh)};
  std::vector<Contactor3> triangles;
  for (const auto& t : mesh.triangles)
    triangles.push_back(Contactor3::polyhedron(
        {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]}, {{0, 1, 2}, {0, 2, 1}}));
  const Contactor3 cylinder = Contactor3::cylinder(0.3, 0.7);
  int wrong = 0;
  for (int tested = 0; tested < samples(3000);) {
    const Placed3 placed{cylinder,
                         {{dice(-1.5, 1.5), dice(-1.5, 1.5), dice(-0.5, 1.2)}, dice.flush_rotation<3>()}};
    if (height_over(terrain.ground(), placed) < 0) continue;
    double gap = 1e300;
    for (const Contactor3& triangle : triangles)
      gap = std::min(gap, facing_pair(placed, {triangle, {}}).apart.distance);
    if (gap > 0.4 || gap < 1e-3) continue;
    ++tested;
    Contacts<3> contacts;
    terrain_contacts(scratch(), placed, terrain, 0.5, 0, contacts);
    bool good = !contacts.empty();
    if (good) {
      const ContactPoint<3>& c = nearest_of(contacts);
      const double error = std::abs(c.gap - gap);
      good = error < 1e-9 + 1e-4 * gap &&
             std::abs(feature_gap(scratch(), placed, c.feature, terrain, c.against, c.normal) - c.gap) < 1e-9;
    }
    wrong += !good;
  }
  CHECK(wrong == 0);
}

TEST_CASE("the place of a rim that lies nearly flat walks on a plane, and not on the line of a side") {
  const Contactor3 disc = Contactor3::cylinder(0.2, 0.05), log = Contactor3::cylinder(1.5, 4);
  const Placed3 lying{log, {Vec3::Zero(), Rotation3::from_vector(0.5 * pi * Vec3::UnitY())}};
  const FeatureId side = lying.id({FeatureKind::face, side_face}),
                  rim = feature_id(0, FeatureKind::edge, rim_index(0, 0));
  const Vec3 up = Vec3::UnitZ(), spin(3, 2, 1);
  const std::optional<Vec3> line = touching_line(lying, side, up);
  REQUIRE(line);
  CHECK(line->cross(Vec3::UnitX()).norm() < 1e-12 * line->norm());
  for (const double tilt : {1e-2, 3e-3, 1e-3}) {
    // The lowest place is on the line. Where the disc turns about the line, the log falls away on both sides.
    const Placed3 over_line{disc, {1.6 * up, Rotation3::from_vector(tilt * Vec3::UnitY())}};
    const Vec3 lever = rim_place(over_line, rim_index(0, 0), -up) - over_line.pose.x;
    const auto rate = [&](const std::optional<Vec3>& other) {
      return lever_rate(over_line, rim, -up, spin, lever, other);
    };
    CHECK((rate(line) - spin.cross(lever)).norm() == 0);
    // On a plane the place turns with the azimuth of the axis.
    CHECK(rate(std::nullopt).norm() == Approx(0.2 * spin.x() / tilt).epsilon(0.02));
  }
}

}  // namespace cylinder_test
