// Bodies whose surface is a line of segments or a mesh of triangles: others meet them as they meet a terrain
// of the same form, also where the surface is turned and moves.
#include <catch2/catch.hpp>

#include "analytic/lab_ground.h"
#include "collision/outline/outline.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace {

Plane far_below() {
  Plane plane;
  plane.point = {0, 0, -1000};
  return plane;
}

/// A sphere, a box, a polyhedron, a pill, a cylinder, or the vertices of a box.
Body<3> thrown_at_surface(int kind) {
  Body<3> body = kind < 3 ? body_of_kind(kind, 0.4) : [&] {
    if (kind == 3) return make_body({Contactor3::pill({-0.3, 0, 0}, {0.3, 0, 0}, 0.2)}, 2700, 0);
    if (kind == 4) return make_body({Contactor3::cylinder(0.3, 0.5)}, 2700, 0);
    Mesh corners;
    for (int i = 0; i < 8; ++i)
      corners.vertices.emplace_back(i & 1 ? 0.3 : -0.3, i & 2 ? 0.2 : -0.2, i & 4 ? 0.4 : -0.4);
    corners.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                         {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return make_body({Contactor3::cloud(corners)}, 2700, 0);
  }();
  body.x = {-3.1, 1.7, 4.5};
  body.v = {2.5, -1, 1};
  body.w = {1, 2, -1};
  body.attitude = Attitude<3>(Rotation3::from_vector({0.3, 0.5, -0.2}) * body.attitude.rotation);
  return body;
}

/// The impacts of a body with a surface that is turned by `turn` and moves with `velocity`, or with the
/// terrain of the same form, as one who moves and turns with the surface sees them.
std::vector<Impact> impacts(const Body<3>& body, bool on_terrain, const Rotation3& turn, const Vec3& velocity,
                            bool surface_first = true) {
  constexpr double seconds = 2.5;
  Material material(0.5, 0.4);
  const TerrainShape3 ground = on_terrain ? TerrainShape3(hilly_block()) : TerrainShape3(far_below());
  Bench3 bench(ground, material, {}, turn * Vec3(0, 0, -9.81));
  Body<3> moving = body;
  moving.x = turn * body.x;
  moving.v = turn * body.v + velocity;
  moving.w = turn * body.w;
  moving.attitude = Attitude<3>(turn * body.attitude.rotation);
  Body<3> surface = make_body({Contactor3::solid(hilly_block())}, 0, 1);
  surface.kind = velocity.isZero() ? BodyKind::fixed : BodyKind::driven;
  surface.attitude = Attitude<3>(turn * surface.attitude.rotation);
  surface.v = velocity;
  if (!on_terrain && surface_first) bench.add(surface);
  const int i = bench.add(moving);
  if (!on_terrain && !surface_first) bench.add(surface);
  bench.run_settings.stop_speed = 0;
  bench.run(seconds);
  std::vector<Impact> found = bench.histories[static_cast<std::size_t>(i)].impacts;
  for (Impact& impact : found) impact.place = turn.inverse(impact.place - impact.time * velocity);
  return found;
}

}  // namespace

TEST_CASE("in 3D a body meets a surface as it meets the terrain, fixed, turned and moving") {
  const int kind = GENERATE(0, 1, 2, 3, 4, 5);
  CAPTURE(kind);
  const auto expected = impacts(thrown_at_surface(kind), true, {}, Vec3::Zero());
  const double margin = 1e-7;  // tumbling multiplies rounding
  check_equal(expected, impacts(thrown_at_surface(kind), false, {}, Vec3::Zero()), 4, margin);
  check_equal(expected, impacts(thrown_at_surface(kind), false, {}, Vec3::Zero(), false), 4, margin);
  const Rotation3 turn = Rotation3::from_vector({0.4, -1.1, 0.7});
  check_equal(expected, impacts(thrown_at_surface(kind), false, turn, Vec3::Zero()), 4, margin);
  check_equal(expected, impacts(thrown_at_surface(kind), false, turn, {3, -2, 1}), 4, margin);
}

namespace {

std::vector<Vec2> steps_down() {
  return {{-30, 6}, {-4, 2.5},   {-1, 1.4}, {0.5, 1.6}, {2, 0},
          {2, -1},  {3.1, -0.8}, {6, -2},   {9, -2.3},  {40, -4}};
}

Body<2> thrown_2d(int kind) {
  Body<2> body = kind == 0   ? disk(0.4, 100, Vec2::Zero())
                 : kind == 1 ? box(0.8, 0.5, 100, Vec2::Zero())
                             : make_body({Contactor2::wall({-0.4, 0}, {0.4, 0}, 0.1)}, 0, 100, 0);
  body.x = {-3, 4.5};
  body.v = {3, 0.5};
  body.w = -2;
  return body;
}

/// As above; the terrain is open and the outline of the surface is closed far below.
std::vector<Impact> impacts_2d(const Body<2>& body, bool on_terrain, double turn, const Vec2& velocity) {
  constexpr double seconds = 3, far = 1000;
  Material material(0.5, 0.4);
  Profile profile;
  profile.points = on_terrain ? steps_down() : std::vector<Vec2>{{-far, -far}, {far, -far}};
  profile.part.assign(profile.points.size() - 1, 0);
  profile.parts = {""};
  const Rotation2 r = Rotation2::from_angle(turn);
  Bench bench(profile, material, {}, r * Vec2(0, -9.81));
  Body<2> moving = body;
  moving.move_to(r * body.x, turn);
  moving.v = r * body.v + velocity;
  std::vector<Vec2> outline = steps_down();
  outline.emplace_back(40, -20);
  outline.emplace_back(-30, -20);
  Body<2> surface = make_body({Contactor2::outline(outline)}, 0, 1, 0);
  surface.kind = velocity.isZero() ? BodyKind::fixed : BodyKind::driven;
  surface.move_to(Vec2::Zero(), turn);
  surface.v = velocity;
  if (!on_terrain) bench.add(surface);
  const int i = bench.add(moving);
  bench.run_settings.stop_speed = 0;
  bench.run(seconds);
  std::vector<Impact> found = bench.histories[static_cast<std::size_t>(i)].impacts;
  for (Impact& impact : found)
    impact.place.head<2>() = r.inverse(Vec2(impact.place.head<2>() - impact.time * velocity));
  return found;
}

}  // namespace

TEST_CASE("in 2D a body meets a surface as it meets the terrain, fixed, turned and moving") {
  const int kind = GENERATE(0, 1, 2);
  CAPTURE(kind);
  const Body<2> body = thrown_2d(kind);
  const auto expected = impacts_2d(body, true, 0, Vec2::Zero());
  check_equal(expected, impacts_2d(body, false, 0, Vec2::Zero()), 4, 1e-9);
  check_equal(expected, impacts_2d(body, false, 0.8, Vec2::Zero()), 4, 1e-9);
  check_equal(expected, impacts_2d(body, false, 0.8, {3, -2}), 4, 1e-9);
}

TEST_CASE("fast bodies do not pass through surfaces") {
  std::mt19937 rng(GENERATE(1, 2, 3, 4));
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(rng); };
  const Mesh mesh = hilly_block();
  for (int shot = 0; shot < 60; ++shot) {
    Material material(uniform(0, 0.9), uniform(0, 1));
    Bench3 bench(far_below(), material, {}, Vec3::Zero());
    Body<3> surface = make_body({Contactor3::solid(mesh)}, 0, 1);
    surface.kind = BodyKind::driven;
    surface.v = {uniform(-50, 50), uniform(-50, 50), uniform(-50, 50)};
    bench.add(surface);
    Body<3> body = thrown_at_surface(shot % 6);
    const Vec3 from = 14 * Vec3(uniform(-1, 1), uniform(-1, 1), uniform(0.2, 1)).normalized();
    const Vec3 to(uniform(-4, 4), uniform(-4, 4), -4);
    body.x = from;
    body.v = surface.v + uniform(10, 300) * (to - from).normalized();
    body.w = 300 * Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    const int i = bench.add(body);
    bench.run_settings.stop_speed = 0;
    bench.run(2);
    CAPTURE(shot);
    const Body<3>& rock = bench.world.bodies[static_cast<std::size_t>(i)];
    const Body<3>& block = bench.world.bodies[0];
    CHECK(!bench.histories[static_cast<std::size_t>(i)].impacts.empty());
    CHECK(depth_in_outline({block.contactors[0], block.pose()}, rock.x) == 0);
    CHECK(bench.world.quality().max_penetration < 1e-4);
    // It has not come out at the other side: below the block it would go on in the direction of the shot.
    CHECK((rock.v - block.v).norm() < 1.2 * (body.v - surface.v).norm() + 300 * body.size);
  }
}
