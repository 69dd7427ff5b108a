// Restitution of the form `velocity`: the coefficients of rockfall practice on round rocks.

#include <catch2/catch.hpp>
#include <random>

#include "analytic/lab_3d.h"
#include "analytic/lab_ground.h"
#include "samples.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace velocity_law_test {

namespace {

struct Kept : RestitutionLaw {
  double normal, tangential;
  Kept(double n, double t) : normal(n), tangential(t) {}
  bool constant() const override { return true; }
  std::string origin() const override { return "kept"; }
  Restitution impact(Values, const ContactState&) const override {
    return {normal, tangential, RestitutionForm::velocity};
  }
};

/// A material whose restitution is Kept.
struct Practice {
  Kept kept;
  lab::Material material;
  Practice(double normal, double tangential) : kept(normal, tangential), material(0, 0.6, 0.02) {
    material.surface.restitution.law = &kept;
  }
};

Profile rough_slope(std::mt19937& rng) {
  std::uniform_real_distribution<double> random(-1, 1);
  Profile profile;
  double x = 0, y = 30;
  for (int i = 0; i <= 120; ++i) {
    profile.points.push_back({x, y});
    x += 0.4 + 0.3 * random(rng);
    y += (i < 70 ? -0.3 : 0) + 0.25 * random(rng);
  }
  profile.part.assign(profile.points.size() - 1, 0);
  profile.parts = {""};
  return profile;
}

}  // namespace

TEST_CASE("in 2D disks on rough slopes keep to a law of form velocity, and none diverges") {
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> random(0, 1);
  for (int i = 0; i < samples(40); ++i) {
    CAPTURE(i);
    Practice practice(0.2 + 0.3 * random(rng), 0.6 + 0.3 * random(rng));
    Bench bench(rough_slope(rng), practice.material);
    bench.run_settings.stop_speed = 0.05;
    const double radius = 0.1 + 0.4 * random(rng);
    bench.add(disk(radius, 500, {1 + 10 * random(rng), 32 + radius}, {3 * random(rng), 0}, 4 * random(rng)));
    const BodyHistory& rock = bench.run(60);
    INFO(rock.fault);
    CHECK(rock.reason != StopReason::diverged);
    CHECK(bench.world.quality().energy_gains == 0);
  }
}

TEST_CASE("in 3D spheres and pills on triangles keep to a law of form velocity, and none diverges") {
  std::mt19937 rng(6);
  std::uniform_real_distribution<double> random(0, 1);
  for (int i = 0; i < samples(20); ++i) {
    CAPTURE(i);
    Practice practice(0.2 + 0.3 * random(rng), 0.6 + 0.3 * random(rng));
    const Height height = [&](double x, double y) {
      return -0.5 * x + 0.3 * std::sin(3 * x) * std::cos(2 * y + i);
    };
    Bench3 bench(mesh_of(height, 10, 20, 0.3, static_cast<unsigned>(i)), practice.material);
    Body<3> rock = i % 2 == 0 ? sphere(0.2 + 0.3 * random(rng), 500, {-6, 0, 5})
                              : make_body({Contactor3::pill({-0.2, 0, 0}, {0.2, 0, 0}, 0.3)}, 0, 500);
    rock.x = {-6, random(rng), 5};
    rock.v = {2, 1, 0};
    bench.add(std::move(rock));
    const BodyHistory& history = bench.run(20);
    INFO(history.fault);
    CHECK(history.reason != StopReason::diverged);
    CHECK(bench.world.quality().energy_gains == 0);
  }
}

TEST_CASE("of a disk that strikes a wall from the floor, the wall gives the law and the floor e = 0") {
  Practice practice(0.5, 0.8);
  Profile corner;
  corner.points = {{-10, 0}, {0, 0}, {0.001, 10}};
  corner.part = {0, 0};
  corner.parts = {""};
  Bench bench(corner, practice.material, {}, {0, -9.81});
  const int i = bench.add(disk(0.5, 10, {-0.5, 0.5}, {2, 0}));
  const Vec2 normal = Vec2(-10, 0.001).normalized();
  bench.world.bodies[i].x = Vec2(-0.5 / std::abs(normal.x()) * (1 + 1e-4), 0.5);
  bench.run(0.05);
  REQUIRE(bench.histories[0].impacts.size() >= 1);
  const Impact& wall = bench.histories[0].impacts[0];
  CHECK(wall.vn_after == Approx(-0.5 * wall.vn_before).epsilon(1e-3));
}

TEST_CASE("a body with corners is refused by a law of form velocity where it touches") {
  Practice practice(0.5, 0.8);
  Bench bench(ground(50), practice.material);
  Body<2> square = box(1, 1, 1, {0, 2});
  square.group = "blocks";
  bench.add(std::move(square));
  CHECK_THROWS_WITH(bench.run(5), Catch::Matchers::Contains("`blocks` has corners"));
}

}  // namespace velocity_law_test
