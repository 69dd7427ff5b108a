// No body passes the ground, however fast or small, and none sinks into it or gains energy on its way to
// rest.
#include <catch2/catch.hpp>

#include "analytic/lab_ground.h"
#include "collision/pairs.h"
#include "geometry/ground.h"
#include "scratch.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace {

Vec3 random_direction(std::mt19937& rng) {
  std::normal_distribution<double> random;
  return Vec3(random(rng), random(rng), random(rng)).normalized();
}

/// How deep the lowest place of a body lies below the ground [m]; not positive if it is free.
double deepest(const Ground3& ground, const Body<3>& body) {
  double depth = -1e300;
  for (const Contactor3& contactor : body.contactors)
    for (const Vec3& point : contactor.points) {
      const Vec3 place = body.pose() * point;
      if (contactor.form == Form::ball) {
        const auto nearest = ground.nearest(place, contactor.radius);
        depth = std::max({depth, ground.depth(place), nearest ? contactor.radius - nearest->distance : 0.0});
      } else if (const double below = ground.depth(place); below > 0) {
        const auto nearest = ground.nearest(place, below);
        depth = std::max(depth, nearest ? nearest->distance : below);
      }
    }
  return depth;
}

/// What a scenario without a `solver` section gets (SolverPlan): steps chosen by their error.
WorldSettings by_default() { return {.step_tolerance = 1e-3}; }

/// A random attitude, and a spin [rad/s] about a random axis.
void tumble(Body<3>& body, double spin, std::mt19937& rng) {
  body.w = spin * random_direction(rng);
  body.attitude = Attitude<3>(Rotation3::from_vector(3 * random_direction(rng)));
}

BodyHistory run_alone(World<3>& world, const Body<3>& body, Material& material, double stop_time) {
  world.add(body);
  world.set_terrain_laws(0, 0, &material.surface);
  std::vector<BodyHistory> histories;
  RunSettings settings;
  settings.stop_time = stop_time;
  run(world, settings, histories);
  return histories[0];
}

/// Shots at 300 m/s from 2 m above the ground, followed over their first impacts.
void shoot(const TerrainShape3& shape, int shots, unsigned seed) {
  const Terrain3 terrain(shape);
  const Ground3& ground = terrain.ground();
  std::mt19937 rng(seed);
  std::uniform_real_distribution<double> random(-1, 1);
  Material material(0.3, 0.5);
  int below = 0, landed = 0;
  for (int i = 0; i < shots; ++i) {
    Body<3> body = body_of_kind(i % 3, 0.005, seed + static_cast<unsigned>(i % 7));
    const double x = 6 * random(rng), y = 6 * random(rng);
    body.x = {x, y, ground.height(x, y).value() + 2};
    Vec3 way = random_direction(rng);
    way.z() = -std::abs(way.z());
    body.v = 300 * way;
    tumble(body, 100, rng);
    World<3> world(terrain, {0, 0, -9.81}, by_default());
    const BodyHistory history = run_alone(world, body, material, 0.1);
    landed += history.landed;
    const bool left = history.reason == StopReason::left_domain;
    below +=
        history.reason == StopReason::diverged || (!left && deepest(ground, world.bodies[0]) > 1e-3 * 0.005);
  }
  CHECK(below == 0);
  CHECK(landed > shots / 3);
}

/// Bodies from `first` to before `end` of the sequence that the seed draws.
void to_rest(const TerrainShape3& shape, int first, int end, unsigned seed) {
  const Terrain3 terrain(shape);
  const Ground3& ground = terrain.ground();
  std::mt19937 rng(seed);
  std::uniform_real_distribution<double> random(-1, 1);
  for (int i = 0; i < end; ++i) {
    CAPTURE(seed, i);
    Material material(0.3 + 0.2 * random(rng), 0.5, i % 3 == 0 ? 0.02 : 0);
    Body<3> body = body_of_kind(i % 3, 0.35 + 0.2 * random(rng), seed + static_cast<unsigned>(i));
    const double x = -15 + 4 * random(rng), y = 8 * random(rng);
    body.x = {x, y, ground.height(x, y).value() + 2};
    body.v = 4 * random_direction(rng);
    tumble(body, 4, rng);
    if (i < first) continue;
    World<3> world(terrain, {0, 0, -9.81}, by_default());
    const BodyHistory history = run_alone(world, body, material, 60);
    CHECK(history.reason != StopReason::diverged);
    CHECK(world.quality().energy_gained <= 1e-4 * body.mass * 9.81 * body.size);
    if (history.reason != StopReason::left_domain) CHECK(deepest(ground, world.bodies[0]) < 1e-4 * body.size);
  }
}

/// The ground under the bodies that come to rest; another one for each number.
TerrainShape3 rough_mesh(unsigned number) { return mesh_of(rough(100 + number, 0.5), 25, 100, 0.2); }
TerrainShape3 rough_grid(unsigned number) { return grid_of(rough(200 + number, 0.5), 25, 100); }

/// The greatest penetration of spheres that roll over shallow hills at 10 m/s, as a share of their radius.
double deepest_rolling(int spheres) {
  const Height hills = rough(4, 0.12);
  const Terrain3 terrain(grid_of(hills, 25, 50));
  Material material(0, 0.6, 0.05);
  double deepest = 0;
  for (int i = 0; i < spheres; ++i) {
    Body<3> sphere = body_of_kind(0, 0.25, 1);
    const double x = -20 + 0.031 * i, y = -20 + 0.27 * i;
    sphere.x = {x, y, hills(x, y) + 0.5};
    sphere.v = {10, 0.5, -2};
    World<3> world(terrain, {0, 0, -9.81}, by_default());
    run_alone(world, sphere, material, 3);
    deepest = std::max(deepest, world.quality().max_penetration / sphere.size);
  }
  return deepest;
}

}  // namespace

TEST_CASE("a sphere that rolls fast over shallow hills sinks by less than the tolerance of a step") {
  CHECK(deepest_rolling(60) < 1e-3);
}

TEST_CASE("an edge that opens takes no impulse from the step before") {
  // On its way the third body opens an edge contact at an impact of none.
  to_rest(rough_grid(28), 0, 3, 28);
}

TEST_CASE("a contact that opens at an impact may touch again in the step that follows") {
  to_rest(rough_mesh(96), 482, 483, 96);
  to_rest(rough_grid(6), 10, 11, 6);
  to_rest(rough_grid(6), 98, 99, 6);
}

TEST_CASE("an edge that rests on an edge of the ground is not drawn to the edges beside it") {
  to_rest(rough_mesh(2), 227, 228, 2);
}

TEST_CASE("an edge that lies on an edge of the ground does not hold the ends of the edges beside it") {
  to_rest(rough_mesh(94), 209, 210, 94);
}

TEST_CASE("a sphere past a convex rim has the gap to the facet that it is over") {
  constexpr double radius = 0.5, fall = 0.1;
  const auto height = [](double x, double) { return x > 0 ? -x * std::tan(fall) : 0.0; };
  const Terrain3 terrain(mesh_of(height, 2, 4));
  const Contactor3 sphere = Contactor3::sphere(radius);
  std::vector<Facet> facets;
  terrain.ground().facets({{-0.1, 0.4, -1}, {0.1, 0.6, 1}}, facets);
  int rims = 0;
  for (const Facet& f : facets)
    for (int i = 0; i < 3; ++i) {
      if (f.rim[i] != Rim::convex || !f.names_edge(i)) continue;
      const double y = 0.5 * (f.corner[i] + f.corner[Facet::next(i)]).y();
      const auto gap = [&](double x, double z) {
        return feature_gap(scratch(), Placed3{sphere, {{x, y, z}, {}}}, feature_id(0, FeatureKind::vertex, 0),
                           terrain, f.edge_feature(i));
      };
      const double over = radius + 0.01, along = 0.2;  // the facet that falls
      const Vec2 beyond(along * std::cos(fall) + over * std::sin(fall),
                        over * std::cos(fall) - along * std::sin(fall));
      CHECK(gap(-0.2, radius + 0.01) == Approx(0.01).epsilon(1e-12));
      CHECK(gap(beyond.x(), beyond.y()) == Approx(0.01).epsilon(1e-12));
      CHECK(gap(0, radius + 0.01) == Approx(0.01).epsilon(1e-12));
      ++rims;
    }
  CHECK(rims > 0);
}

TEST_CASE("shots of 1 cm at 300 m/s do not pass a mesh, a grid or a plane") {
  shoot(mesh_of(rough(5, 0.8), 20, 80, 0.2), 300, 1);
  shoot(grid_of(rough(6, 0.8), 20, 80), 300, 2);
  shoot(plane(0.3, 0.2), 300, 3);
}

TEST_CASE("10,000 shots of 1 cm at 300 m/s do not pass a mesh, a grid, a plane or a profile", "[slow]") {
  Profile steps;
  for (int i = 0; i < 20; ++i) {
    steps.points.emplace_back(-20 + 2 * i, -i);
    steps.points.emplace_back(-19 + 2 * i, -i);
  }
  steps.part.assign(steps.points.size() - 1, 0);
  steps.parts = {""};
  shoot(mesh_of(rough(7, 0.8), 20, 80, 0.2), 3000, 4);
  shoot(grid_of(rough(8, 0.8), 20, 80), 3000, 5);
  shoot(plane(0.3, 0.2), 1000, 6);
  shoot(extruded(steps, 20, 1), 3000, 7);
}

TEST_CASE("spheres and polyhedra come to rest on rough ground without sinking or gaining energy") {
  to_rest(mesh_of(rough(9, 0.5), 25, 100, 0.2), 0, 12, 1);
  to_rest(grid_of(rough(10, 0.5), 25, 100), 0, 12, 2);
}

TEST_CASE("hundreds of bodies come to rest on rough ground without sinking or gaining energy", "[slow]") {
  to_rest(mesh_of(rough(11, 0.5), 25, 100, 0.2), 0, 150, 3);
  to_rest(grid_of(rough(12, 0.5), 25, 100), 0, 150, 4);
}

// Four parts, so that machines with several processors run them at the same time.
void many_to_rest(unsigned part) {
  for (unsigned ground = part; ground < 100; ground += 4) {
    to_rest(rough_mesh(ground), 0, 500, ground);
    to_rest(rough_grid(ground), 0, 500, ground);
  }
}
TEST_CASE("100,000 bodies come to rest on rough ground: the first 25,000", "[heavy]") { many_to_rest(0); }
TEST_CASE("100,000 bodies come to rest on rough ground: the second 25,000", "[heavy]") { many_to_rest(1); }
TEST_CASE("100,000 bodies come to rest on rough ground: the third 25,000", "[heavy]") { many_to_rest(2); }
TEST_CASE("100,000 bodies come to rest on rough ground: the last 25,000", "[heavy]") { many_to_rest(3); }
