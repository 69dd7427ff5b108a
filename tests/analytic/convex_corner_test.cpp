// Blocks whose corner, or edge, is flush with a convex one of the ground: its top holds them, and its side
// does not.

#include <catch2/catch.hpp>

#include "analytic/lab_3d.h"
#include "collision/pairs.h"
#include "scratch.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace convex_corner_test {

constexpr double height = 1;

/// A step of 1 m at x = 0. The high ground is on the side of `side` (1: right, -1: left).
Profile step_at_origin(double side) {
  Profile profile;
  profile.points = {{-50, 0}, {0, 0}, {0, height}, {50, height}};
  if (side < 0) profile.points = {{-50, height}, {0, height}, {0, 0}, {50, 0}};
  profile.part.assign(3, 0);
  profile.parts = {""};
  return profile;
}

/// The same as two levels and a wall in 3D.
Mesh step_in_3d(double side) {
  Mesh mesh;
  mesh.parts = {""};
  const Profile profile = step_at_origin(side);
  for (const double y : {-50.0, 50.0})
    for (const Vec2& p : profile.points) mesh.vertices.push_back({p.x(), y, p.y()});
  const int n = static_cast<int>(profile.points.size());
  for (int i = 0; i + 1 < n; ++i) {
    mesh.triangles.push_back({i, i + 1, n + i + 1});
    mesh.triangles.push_back({i, n + i + 1, n + i});
  }
  mesh.part.assign(mesh.triangles.size(), 0);
  return mesh;
}

WorldSettings settings_of(ManyBodies many) {
  WorldSettings settings;
  settings.step_tolerance = 1e-3;
  settings.many = many;
  return settings;
}

/// A block of 2 m by 1 m whose edge is that of the step slides away from it without friction, in one second.
template <int D>
void check_slides(BenchOf<D>& bench, Body<D> block, double side, double speed) {
  block.v = side * speed * Vec<D>::UnitX();
  bench.add(block);
  const BodyHistory& history = bench.run(1);
  const Vec<D>& end = bench.world.bodies[0].x;
  CHECK(history.impacts.empty());
  CHECK(end.x() == Approx(side * (1 + speed)).epsilon(1e-9));
  CHECK(end[D - 1] == Approx(height + 0.5).margin(1e-7));
}

}  // namespace convex_corner_test

using namespace convex_corner_test;

TEST_CASE("a block whose corner is flush with a convex corner of the ground slides away from it") {
  const double side = GENERATE(1, -1), speed = GENERATE(0, 1);
  const ManyBodies many = GENERATE(ManyBodies::exact, ManyBodies::dense);
  Material smooth(0.5, 0);
  Bench bench(step_at_origin(side), smooth, settings_of(many));
  const Body<2> block = box(2, 1, 1000, {side, height + 0.5});
  check_slides(bench, block, side, speed);
}

TEST_CASE("a box or cylinder whose edge is flush with a convex edge of the ground slides away from it") {
  const double side = GENERATE(1, -1), speed = GENERATE(0, 1);
  const bool is_round = GENERATE(false, true);
  Material smooth(0.5, 0);
  Bench3 bench(step_in_3d(side), smooth, settings_of(ManyBodies::exact));
  Body<3> block =
      is_round ? make_body({Contactor3::cylinder(1, 1)}, 0, 1000) : box(Vec3(2, 1, 1), 1000, Vec3::Zero());
  block.x = {side, 0, height + 0.5};
  check_slides(bench, block, side, speed);
}

TEST_CASE("a corner of the ground in a block, beside the end of an edge, is pushed out through this edge") {
  // The block leans to the left by `tilt`. The corner lies in it, `beside` from its left side along its base
  // and `deep` above the base: the side is nearer, but nothing can push the block to the right there.
  const Terrain2 ground(step_at_origin(1));
  const double tilt = 0.01, beside = GENERATE(1e-7, 1e-6, 1e-4), deep = GENERATE(0.0, 1e-6, 5e-4);
  const Contactor2 shape = Contactor2::polygon({{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}});
  const Rotation2 turned = Rotation2::from_angle(tilt);
  const Vec2 corner(0, height), centre = corner - turned * Vec2(-1 + beside, -0.5 + deep);
  Contacts<2> contacts;
  terrain_contacts<2>(scratch(), {shape, {centre, turned}}, ground, 1e-5, 0, contacts);
  const Vec2 base(-std::sin(tilt), std::cos(tilt));
  REQUIRE_FALSE(contacts.empty());  // a second one is that of the vertex, where it is over the top
  const ContactPoint<2>& last = contacts.back();
  CHECK(last.gap == Approx(-deep).margin(1e-12));
  CHECK((last.normal - base).norm() < 1e-12);
  for (const auto& c : contacts) CHECK(c.normal.y() > 0.9);
}
