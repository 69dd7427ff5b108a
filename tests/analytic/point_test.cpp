// A point without extent in 2D and 3D, against closed forms.

#include <catch2/catch.hpp>

#include "analytic/lab_3d.h"
#include "analytic/lab_ground.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace point_test {

namespace {

constexpr double gravity = 9.81;

Body<2> point_2d(double mass, const Vec2& at, const Vec2& velocity = Vec2::Zero()) {
  return disk(0, mass, at, velocity);
}
Body<3> point_3d(double mass, const Vec3& at, const Vec3& velocity = Vec3::Zero()) {
  return sphere(0, mass, at, velocity);
}

WorldSettings steps() {
  WorldSettings settings;
  settings.time_step = 1e-3;
  return settings;
}

}  // namespace

TEST_CASE("a point slides down a slope without turning, on a profile, a plane and many triangles") {
  const double slope = 0.5, mu = 0.3, a = gravity * (std::sin(slope) - mu * std::cos(slope));
  Material material(0, mu);
  Bench bench(ground(50, slope, 400), material);
  bench.add(point_2d(2, {0, 0}));
  const BodyHistory& flat = bench.run(1);
  CHECK((flat.last.position.head<2>() - 0.5 * a * Vec2(std::cos(slope), -std::sin(slope))).norm() < 1e-6);
  CHECK(std::abs(bench.world.bodies[0].w) < 1e-9);
  CHECK(bench.world.quality().max_penetration < 1e-9);
  const double azimuth = 0.4;
  const Plane tilted = plane(slope, azimuth);
  for (const TerrainShape3& shape :
       {TerrainShape3(tilted), TerrainShape3(mesh_of(height_of(tilted), 8, 23, 0.3))}) {
    Bench3 in_space(shape, material);
    in_space.add(point_3d(2, Vec3::Zero()));
    const BodyHistory& history = in_space.run(1);
    CHECK((history.last.position - 0.5 * a * down(slope, azimuth)).norm() < 1e-6);
    CHECK(in_space.world.bodies[0].w.norm() < 1e-9);
    CHECK(in_space.world.quality().max_penetration < 1e-9);
  }
}

TEST_CASE("a point that falls 1 m bounces with its restitution, and stops in a valley without sinking") {
  Material material(0.5, 0.5);
  Profile valley;
  valley.points = {{-5, 2}, {0, 0}, {5, 2}};
  valley.part = {0, 0};
  valley.parts = {""};
  Bench bench(valley, material);
  bench.add(point_2d(1, {-1.3, 3}, {2, 0}));
  const BodyHistory& history = bench.run(20);
  CHECK(history.reason == StopReason::stopped);
  CHECK(history.last.position.y() >= -1e-9);
  CHECK(history.last.position.head<2>().norm() < 1.5);
  CHECK(bench.world.quality().max_penetration < 1e-8);
  Bench3 in_space(plane(), material);
  const int i = in_space.add(point_3d(1, {0, 0, 1}));
  in_space.run(std::sqrt(2 / gravity) + 0.1);
  const double up = 0.5 * std::sqrt(2 * gravity);
  CHECK(in_space.world.bodies[i].v.z() == Approx(up - 0.1 * gravity).epsilon(1e-9));
}

TEST_CASE("a point in a smooth drum is a pendulum, and a shot one stays in it") {
  const double radius = 0.7, start = 0.02, time = 1.3;
  Material material(0, 0);
  Profile floor = ground(50);
  for (Vec2& at : floor.points) at.y() = -20;
  Bench bench(floor, material, steps());
  Body<2> drum = make_body({Contactor2::hollow_disk(radius, 0.8)}, 1000, 0, 0);
  drum.kind = BodyKind::fixed;
  bench.add(drum);
  const int i = bench.add(point_2d(3, radius * Vec2(std::sin(start), -std::cos(start))));
  bench.run_settings.stop_speed = 0;
  bench.run(time);
  const double expected = radius * std::sin(start * std::cos(time * std::sqrt(gravity / radius)));
  CHECK(bench.world.bodies[i].x.x() == Approx(expected).margin(1e-3 * radius * start));
  Material bouncy(0.9, 0.3);
  Bench3 in_space(Plane{.point = {0, 0, -20}}, bouncy, steps());
  Body<3> tube = make_body({Contactor3::hollow_cylinder(radius, 0.8, 900)}, 1000, 0);
  tube.attitude = Rotation3::from_vector({0.5 * pi, 0, 0}) * tube.attitude.rotation;
  tube.kind = BodyKind::fixed;
  in_space.add(tube);
  const int shot = in_space.add(point_3d(1, {0.1, 0, 0.2}, {250, 3, 100}));
  in_space.run(0.3);
  CHECK(std::hypot(in_space.world.bodies[shot].x.x(), in_space.world.bodies[shot].x.z()) < radius);
  CHECK(in_space.world.quality().max_penetration < 1e-8);
}

TEST_CASE("a point lands on each shape, and two points pass each other") {
  Material material(0, 0.5);
  const std::vector<Contactor3> shapes{Contactor3::box({1, 1, 0.4}), Contactor3::sphere(0.2),
                                       Contactor3::pill({-0.4, 0, 0}, {0.4, 0, 0}, 0.2),
                                       Contactor3::cylinder(0.5, 0.4)};
  for (const Contactor3& shape : shapes) {
    Bench3 bench(Plane{.point = {0, 0, -20}}, material);
    Body<3> fixed = make_body({shape}, 1000, 0);
    fixed.kind = BodyKind::fixed;
    bench.add(fixed);
    const int i = bench.add(point_3d(1, {0, 0, 1}, {0, 0, -200}));
    bench.run(0.5);
    CHECK(bench.world.bodies[i].x.z() == Approx(0.2).margin(1e-8));
  }
  const std::vector<Contactor2> flat{
      Contactor2::polygon({Vec2(-0.5, -0.2), Vec2(0.5, -0.2), Vec2(0.5, 0.2), Vec2(-0.5, 0.2)}),
      Contactor2::disk(0.2), Contactor2::wall({-0.4, 0}, {0.4, 0}, 0.2)};
  Profile floor = ground(50);
  for (Vec2& at : floor.points) at.y() = -20;
  for (const Contactor2& shape : flat) {
    Bench bench(floor, material);
    Body<2> fixed = make_body({shape}, 1000, 0, 0);
    fixed.kind = BodyKind::fixed;
    bench.add(fixed);
    const int i = bench.add(point_2d(1, {0, 1}, {0, -200}));
    bench.run(0.5);
    CHECK(bench.world.bodies[i].x.y() == Approx(0.2).margin(1e-8));
  }
  Bench bench(floor, material);
  bench.add(point_2d(1, {0, 0}));
  const int above = bench.add(point_2d(1, {0, 1}, {0, -10}));
  bench.run(0.5);
  CHECK(bench.world.bodies[above].x.y() == Approx(1 - 5 - 0.125 * gravity));
}

}  // namespace point_test
