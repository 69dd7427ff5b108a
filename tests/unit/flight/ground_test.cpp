// The ground below a path in 3D: heights, the end of the terrain, and what lies below the surface.
#include "flight/ground.h"

#include <catch2/catch.hpp>
#include <limits>

#include "analytic/lab_ground.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace {

/// The greatest height of a path above the ground, sampled.
double sampled_height(const Terrain3& terrain, const Path<3>& path, double dt) {
  double most = -infinite;
  for (int i = 0; i <= 20'000; ++i) {
    const Vec3 p = path.position(dt * i / 20'000);
    if (const auto z = ground_height(terrain, p)) most = std::max(most, p.z() - *z);
  }
  return most;
}

double visited_height(const Terrain3& terrain, const Path<3>& path, double dt) {
  double most = -infinite;
  visit_heights(terrain, path, dt,
                [&](double t0, double t1, const auto& highest) { most = std::max(most, highest(t0, t1)); });
  return most;
}

}  // namespace

TEST_CASE("the greatest height above a mesh, a grid and a plane is exact along a parabola") {
  const Height surface = rough(2, 0.7);
  const Terrain3 mesh(mesh_of(surface, 20, 50, 0.3)), grid(grid_of(surface, 20, 50)), slope(plane(0.2, 1));
  const Path<3> path{{-12, 3, 9}, {7, -2, 6}, {0, 0, -9.81}};
  for (const Terrain3* terrain : {&mesh, &grid, &slope}) {
    const double most = visited_height(*terrain, path, 2);
    CHECK(most >= sampled_height(*terrain, path, 2) - 1e-12);
    CHECK(most <= sampled_height(*terrain, path, 2) + 1e-4);
  }
  const Path<3> still{{1.234, 5.678, 20}, {0, 0, 3}, {0, 0, -9.81}};
  CHECK(visited_height(mesh, still, 1) == Approx(sampled_height(mesh, still, 1)).epsilon(1e-6));
}

TEST_CASE("the parts of a path over the facets of a mesh cover it without gaps") {
  const Terrain3 mesh(mesh_of(rough(3, 0.7), 20, 50, 0.3));
  const Path<3> path{{-12, 3, 9}, {7, -2, 6}, {0, 0, -9.81}};
  double covered = 0;
  visit_heights(mesh, path, 2, [&](double t0, double t1, const auto&) { covered += t1 - t0; });
  CHECK(covered == Approx(2).epsilon(1e-9));
}

TEST_CASE("a path comes to where the ground ends: a turned terrain, and missing data") {
  const Terrain3 turned(turned_about_z(mesh_of([](double, double) { return 0.0; }, 10, 4), pi / 4));
  const Path<3> path{{0, 0, 5}, {5, 5, 0}, {0, 0, -9.81}};
  CHECK(!turned.ground().whole());
  CHECK(time_over_ground(turned, path, 3) == Approx(10 / std::hypot(5, 5)).epsilon(1e-9));
  CHECK(time_over_ground(turned, path, 1) == infinite);

  HeightGrid holed = grid_of([](double, double) { return 0.0; }, 10, 20);
  holed.heights[10 * 21 + 15] = std::numeric_limits<double>::quiet_NaN();  // at (5, 0)
  const Terrain3 grid(holed);
  const Path<3> across{{0, 0.5, 5}, {2, 0, 0}, {0, 0, -9.81}};
  CHECK(time_over_ground(grid, across, 3) == Approx(2).epsilon(1e-9));
  CHECK(!ground_height(grid, {5.5, 0.5, 1}));
  CHECK(domain_of(grid).contains({5.5, 0.5, 1}));
  CHECK(!domain_of(grid).contains({5.5, 10.1, 1}));
}

TEST_CASE("a rock leaves the terrain where its centre has no ground below, along x, y and in the middle") {
  HeightGrid holed = grid_of([](double, double) { return 0.0; }, 10, 20);
  holed.heights[10 * 21 + 15] = std::numeric_limits<double>::quiet_NaN();
  const auto ends_at = [&](const Vec3& velocity, const std::string& text) {
    Material material(0.5, 0.1);
    Bench3 bench(holed, material);
    bench.add(sphere(0.3, 100, {0, 0.4, 2}, velocity));
    const BodyHistory& history = bench.run(20);
    CHECK(history.reason == StopReason::left_domain);
    CHECK(history.fault == text);
    return history.last.position;
  };
  CHECK(ends_at({-8, 0, 3}, "it passed the end of the terrain towards -x").x() == Approx(-10).margin(1e-3));
  CHECK(ends_at({0, 8, 3}, "it passed the end of the terrain towards +y").y() == Approx(10).margin(1e-3));
  CHECK(ends_at({0, -8, 3}, "it passed the end of the terrain towards -y").y() == Approx(-10).margin(1e-3));
  CHECK(ends_at({8, 0, 9}, "it has no ground below it").x() == Approx(4).margin(1e-3));
}

TEST_CASE("a rock at the very end of the terrain stays on it until it moves outwards") {
  const auto flat = [](double, double) { return 0.0; };
  for (const TerrainShape3& shape :
       {TerrainShape3(grid_of(flat, 10, 20)), TerrainShape3(mesh_of(flat, 10, 20))}) {
    const auto history = [&](const Vec3& from, const Vec3& velocity) {
      Material material(0.5, 0.4, 0.02);
      Bench3 bench(shape, material);
      bench.add(sphere(0.3, 100, from, velocity));
      return bench.run(20);
    };
    CHECK(history({-9, -10, 2}, {3, 0, 0}).reason == StopReason::stopped);
    CHECK(history({-10, 10, 2}, {0, 0, 0}).reason == StopReason::stopped);
    CHECK(history({-10, 0, 2}, {1, 0, 0}).reason == StopReason::stopped);
    CHECK(history({-10, 0, 2}, {-1, 0, 0}).reason == StopReason::left_domain);
  }
}

TEST_CASE("fixed steps push a body out of a mesh as out of a plane") {
  const auto rests_at = [](const TerrainShape3& shape, int kind) {
    Material material(0, 0.5, 0.02);
    Bench3 bench(shape, material);
    Body<3> body = body_of_kind(kind, 0.3);
    body.x = {0.1, 0.2, 3};
    body.v = {0, 0, -30};
    bench.add(body);
    bench.run_settings.exact_flight = false;
    const BodyHistory& history = bench.run(20);
    CHECK(history.fault.empty());
    return bench.world.bodies[0].x.z();
  };
  const auto level = [](double, double) { return 0.0; };
  for (const int kind : {0, 1}) {
    CHECK(rests_at(mesh_of(level, 5, 20, 0.3), kind) == Approx(rests_at(Plane{}, kind)).margin(0.05));
    CHECK(rests_at(grid_of(level, 5, 20), kind) == Approx(rests_at(Plane{}, kind)).margin(0.05));
  }
}
