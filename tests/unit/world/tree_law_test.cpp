// What a tree takes of a rock, and where a point in flight meets it, against closed forms.
#include "world/tree_law.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "collision/ground/terrain_3d.h"
#include "flight/point_run.h"

using namespace flyrock;

namespace tree_law_test {

namespace {

const Stem stem{.place = {30, 0}, .radius = 0.15, .height = 20, .strength = 1.5};

Body<3> ball(const Vec3& at, const Vec3& v) {
  Body<3> body = make_body({Contactor3::sphere(0.5)}, 0, 1000);
  body.x = at;
  body.v = v;
  return body;
}

BodyHistory fly(const RunForest& trees, const Air<3>& air = {}) {
  PointRun<3> run;
  run.forces = {Vec3(0, 0, -9.81), air};
  run.forest = trees;
  Plane ground;
  ground.normal = Vec3::UnitZ();
  return run_point(ball({0, 0.2, 10}, {20, 0, 3}), Terrain3(ground), run);
}

}  // namespace

TEST_CASE("a tree takes energy by its diameter, its species and the eccentricity of the hit") {
  const TreeLaw law{.factor = 2};
  const double whole = 2 * 1.5 * 38.7 * std::pow(30.0, 2.31);
  for (const double x : {0.0, 0.3, 0.58}) {
    const double share = -0.046 + 1.026 / (1 + std::pow(10.0, -8.007 * (0.58 - x)));
    CHECK(law.energy_of(stem, x) == Approx(whole * share).epsilon(1e-13));
  }
  CHECK(law.energy_of(stem, 0.58) == Approx(whole * 0.467).epsilon(1e-12));
  CHECK(law.energy_of(stem, 1) == 0);
  CHECK(TreeLaw{.fixed = true, .energy = 4e3, .factor = 2}.energy_of(stem, 1) == 12e3);
}

TEST_CASE("a rock turns away from the axis of the stem") {
  const TreeLaw law{.fixed = true, .energy = 0, .turn = 0.1};
  CHECK(effect_of(law, stem, 0, 1e4, {29.5, 0.2}, {10, 0}, {}).turn == 0.1);    // the axis is on its right
  CHECK(effect_of(law, stem, 0, 1e4, {29.5, -0.2}, {10, 0}, {}).turn == -0.1);  // on its left
  CHECK(effect_of(law, stem, 0, 1e4, {29.5, 0}, {10, 0}, {}).left == 1);
}

TEST_CASE("a point in flight hits a tree at its time on the parabola, and goes on slower and turned") {
  const Forest forest({stem});
  const RunForest trees{&forest, {.fixed = true, .energy = 1e5, .turn = 0.2}};
  const BodyHistory history = fly(trees);
  REQUIRE(history.trees.size() == 1);
  const TreeHit& hit = history.trees[0];
  const double reach = 0.5 + stem.radius;
  const double time = (30 - std::sqrt(reach * reach - 0.04)) / 20, fall = 3 - 9.81 * time;
  CHECK(hit.time == Approx(time).epsilon(1e-13));
  CHECK(hit.height == Approx(10 + 3 * time - 0.5 * 9.81 * time * time).epsilon(1e-12));
  CHECK(hit.energy_before == Approx(500 * (400 + fall * fall)).epsilon(1e-12));
  CHECK(hit.energy_before - hit.energy_after == Approx(1.5e5).epsilon(1e-12));
  const double left = std::sqrt(hit.energy_after / hit.energy_before);
  CHECK(history.last.velocity.x() == Approx(20 * left * std::cos(0.2)).epsilon(1e-12));
  CHECK(history.last.velocity.y() == Approx(20 * left * std::sin(0.2)).epsilon(1e-12));
  CHECK(history.reason == StopReason::stopped);
}

TEST_CASE("a tree that takes more than a rock has catches it there") {
  const Forest forest({stem});
  const BodyHistory history = fly({&forest, {.fixed = true, .energy = 1e7}});
  REQUIRE(history.trees.size() == 1);
  CHECK(history.trees[0].energy_after == 0);
  CHECK(history.reason == StopReason::caught);
  CHECK(history.last.velocity.norm() == 0);
}

TEST_CASE("in air a point hits a tree where the distance from its axis is the sum of the radii") {
  const Forest forest({stem});
  Air<3> air;
  air.drag = 0.003;
  air.wind = {0, 1, 0};
  const BodyHistory history = fly({&forest, {.fixed = true, .energy = 1e7}}, air);
  REQUIRE(history.trees.size() == 1);
  const Vec2 at = history.last.position.head<2>();
  CHECK((at - stem.place).norm() == Approx(0.5 + stem.radius).epsilon(1e-12));
}

}  // namespace tree_law_test
