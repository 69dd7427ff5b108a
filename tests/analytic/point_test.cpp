// A point without extent in 2D and 3D, against closed forms.

#include <catch2/catch.hpp>

#include "analytic/lab_3d.h"
#include "analytic/lab_ground.h"
#include "dice.h"
#include "flight/ground.h"
#include "samples.h"

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

Profile profile_of(std::vector<Vec2> points) {
  Profile profile;
  profile.part.assign(points.size() - 1, 0);
  profile.parts = {""};
  profile.points = std::move(points);
  return profile;
}

Profile pit(Dice& dice) {
  return profile_of({{-20, dice(0.01, 5)}, {-20, 0}, {20, 0}, {20, dice(0.01, 5)}, {40, 3}});
}

Profile valleys_and_ridges(Dice& dice) {
  std::vector<Vec2> points{{-30, dice(-5, 20)}};
  while (points.back().x() < 30) points.push_back(points.back() + Vec2(dice(0.3, 10), dice(-8, 8)));
  return profile_of(points);
}

Profile steps_and_walls(Dice& dice) {
  std::vector<Vec2> points{{-30, dice(-5, 20)}};
  while (points.back().x() < 30) {
    points.push_back(points.back() + Vec2(dice(0.3, 8), 0));
    points.push_back(points.back() + Vec2(0, dice(-4, 4)));
  }
  points.push_back(points.back() + Vec2(1, 0));
  return profile_of(points);
}

/// A point is let go on the ground or up to 10 m over it. It neither ends with a fault nor in the ground.
template <int D, class BenchType>
void let_go_over(BenchType& bench, Dice& dice) {
  Vec<D> at, velocity;
  for (int k = 0; k < D; ++k) at[k] = dice(-14, 14);
  for (int k = 0; k < D; ++k) velocity[k] = dice(-10, 10);
  at[D - 1] = *ground_height(bench.terrain, at) + (dice(0, 1) < 0.3 ? 0 : dice(0, 10));
  Body<D> body;
  if constexpr (D == 2)
    body = point_2d(dice(1, 100), at, velocity);
  else
    body = point_3d(dice(1, 100), at, velocity);
  if (dice(0, 1) < 0.3) body.air.drag = dice(0, 0.02);
  bench.add(std::move(body));
  const BodyHistory& history = bench.run(20);
  INFO(history.fault);
  CHECK(history.reason != StopReason::diverged);
  CHECK(bench.world.quality().max_penetration < 1e-7);
  const Vec<D>& end = bench.world.bodies[0].x;
  if (history.reason != StopReason::left_domain && depth_below_ground(bench.terrain, end) > 1e-6)
    CHECK(is_near_surface(bench.terrain, end, 1e-6));
}

WorldSettings chosen_steps() {
  WorldSettings settings;
  settings.step_tolerance = 1e-3;
  return settings;
}

}  // namespace

TEST_CASE("a point stays above random valleys, ridges, steps and walls") {
  const double restitutions[] = {0, 0.3, 0.9}, frictions[] = {0, 0.1, 0.3, 0.6, 1.2};
  Profile (*const grounds[])(Dice&) = {pit, valleys_and_ridges, steps_and_walls};
  for (int kind = 0; kind < 3; ++kind)
    for (int i = 0; i < samples(60); ++i) {
      CAPTURE(kind, i);
      Dice dice(static_cast<unsigned>(10 * i + kind));
      Material material(restitutions[i % 3], frictions[i % 5], 0, i % 4 == 0 ? 0.4 : 0);
      Bench bench(grounds[kind](dice), material, chosen_steps());
      let_go_over<2>(bench, dice);
    }
}

TEST_CASE("a point stays above random valleys, ridges, steps and walls in 3D, of triangles and of heights",
          "[slow]") {
  const double restitutions[] = {0, 0.3, 0.9}, frictions[] = {0, 0.1, 0.3};
  Profile (*const grounds[])(Dice&) = {pit, valleys_and_ridges, steps_and_walls};
  for (int kind = 0; kind < 4; ++kind)
    for (int i = 0; i < samples(30); ++i) {
      CAPTURE(kind, i);
      Dice dice(static_cast<unsigned>(10 * i + kind));
      Material material(restitutions[i % 3], frictions[i / 3 % 3]);
      const double high = dice(1, 30);
      const auto step = [&](double x, double) { return x < 0 ? high : x < 10 ? 0 : 5; };
      Bench3 bench(kind < 3 ? TerrainShape3(extruded(grounds[kind](dice), 15, 1 + i % 7))
                            : TerrainShape3(grid_of(step, 20, 4 + i % 9)),
                   material, chosen_steps());
      let_go_over<3>(bench, dice);
    }
}

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
