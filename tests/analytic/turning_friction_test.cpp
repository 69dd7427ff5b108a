// Friction and rolling resistance whose direction or coefficient changes along the way, against Runge and
// Kutta's scheme.
#include <catch2/catch.hpp>

#include "analytic/lab_3d.h"
#include "dice.h"
#include "samples.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace turning_friction_test {

namespace {

constexpr double g = 9.81, lasts = 3, step_tolerance = 1e-3;

WorldSettings defaults() {
  WorldSettings settings;
  settings.step_tolerance = step_tolerance;
  return settings;
}

/// Where a place with the acceleration a(v) is after 3 s.
template <class Acceleration>
Vec2 place_after(Vec2 v, const Acceleration& a) {
  constexpr int parts = 3000;
  constexpr double dt = lasts / parts;
  Vec2 x = Vec2::Zero();
  for (int i = 0; i < parts; ++i) {
    const Vec2 k1 = a(v), k2 = a(v + 0.5 * dt * k1), k3 = a(v + 0.5 * dt * k2), k4 = a(v + dt * k3);
    x += dt * v + dt * dt / 6 * (k1 + k2 + k3);
    v += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return x;
}

/// Friction that falls with the speed of slip (Stribeck).
struct Stribeck : FrictionLaw {
  double still, fast, speed;
  Stribeck(double s, double f, double v) : still(s), fast(f), speed(v) {}
  double at(double slip) const { return fast + (still - fast) * std::exp(-slip / speed); }
  bool constant() const override { return false; }
  std::string origin() const override { return "stribeck"; }
  Friction friction(Values, const ContactState& contact) const override {
    const double mu = at(contact.slip.norm());
    return {mu, mu};
  }
};

}  // namespace

TEST_CASE("a ball with rolling resistance that rolls across a slope turns to its fall line") {
  Dice dice(21);
  for (int n = 0; n < samples(8); ++n) {
    const double slope = dice(0.14, 0.43), radius = dice(0.2, 0.8), speed = dice(1.5, 4),
                 share = dice(0.3, 0.9) * std::tan(slope);
    CAPTURE(slope, radius, speed, share);
    Material material(0, 0.9, share * radius);
    Bench3 bench(plane(slope), material, defaults());
    bench.run_settings.stop_speed = 0;
    const Vec3 up = plane(slope).normal;
    bench.add(sphere(radius, 100, radius * up, {0, speed, 0}, up.cross(Vec3(0, speed, 0)) / radius));
    bench.run(lasts);
    // v' = 5/7 (g sin - mu_r / R g cos v / |v|)
    const Vec2 end = place_after({0, speed}, [&](const Vec2& v) -> Vec2 {
      return 5 * g / 7 * (Vec2(std::sin(slope), 0) - share * std::cos(slope) * v.normalized());
    });
    const Vec3 expected = radius * up + end.x() * down(slope) + Vec3(0, end.y(), 0);
    CHECK((bench.world.bodies[0].x - expected).norm() < 2 * step_tolerance * 2 * radius);
  }
}

TEST_CASE("a box slides with a friction that falls with its speed") {
  Dice dice(22);
  for (int n = 0; n < samples(6); ++n) {
    const double slope = dice(0.05, 0.2), width = dice(0.3, 1), speed = dice(3, 6),
                 fast = dice(0.7, 0.95) * std::tan(slope);
    const Stribeck law(fast + dice(0.1, 0.4), fast, dice(0.3, 2));
    CAPTURE(slope, width, speed, fast, law.still, law.speed);
    Material material(0, 0);
    material.surface.friction.law = &law;
    Bench bench(ground(100, slope), material, defaults());
    bench.run_settings.stop_speed = 0;
    const Vec2 along(std::cos(slope), -std::sin(slope)), up(std::sin(slope), std::cos(slope));
    const int i = bench.add(box(width, 0.2 * width, 100, 0.1 * width * up, -slope));
    bench.world.bodies[i].v = speed * along;
    const double diameter = 2 * bench.world.bodies[i].radius;
    bench.run(lasts);
    const Vec2 end = place_after({speed, 0}, [&](const Vec2& v) -> Vec2 {
      return {g * (std::sin(slope) - law.at(std::abs(v.x())) * std::cos(slope) * (v.x() > 0 ? 1 : -1)), 0};
    });
    CHECK(std::abs((bench.world.bodies[i].x - 0.1 * width * up).dot(along) - end.x()) <
          2 * step_tolerance * diameter);
  }
}

}  // namespace turning_friction_test
