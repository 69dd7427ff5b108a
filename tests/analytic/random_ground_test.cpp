// Disks, polygons and rounded polygons on random ground, at the default settings: none ends below the ground,
// none gets energy from nowhere.
#include <catch2/catch.hpp>
#include <random>

#include "analytic/lab.h"
#include "samples.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace {

struct Draw {
  std::mt19937 rng;
  double operator()(double a, double b) { return std::uniform_real_distribution<double>(a, b)(rng); }
};

enum class Relief { gentle, rough, concave };

/// 120 m of ground that falls towards +x: gentle (bends of a few milliradians), rough (steps of decimetres),
/// or concave.
Profile relief(Relief kind, Draw& uniform) {
  Profile profile;
  profile.parts = {""};
  double slope = -uniform(0.1, 0.6);
  for (double x = -20, y = 40; x < 100;) {
    profile.points.emplace_back(x, y + (kind == Relief::rough ? uniform(-0.3, 0.3) : 0));
    const double dx = kind == Relief::rough ? uniform(0.05, 1.5) : uniform(0.5, 8);
    x += dx;
    y += slope * dx;
    if (kind == Relief::gentle) slope = std::clamp(slope + uniform(-0.004, 0.004), -0.6, 0.0);
    if (kind == Relief::concave) slope = std::min(0.0, slope + uniform(0, 0.01));
  }
  profile.part.assign(profile.points.size() - 1, 0);
  return profile;
}

Body<2> rock(bool round, Draw& uniform) {
  if (round) return disk(uniform(0.05, 1), 100, Vec2::Zero());
  for (;;) {
    std::vector<Vec2> vertices;
    const double size = uniform(0.05, 0.7);
    const int n = 3 + static_cast<int>(uniform(0, 7));
    for (int k = 0; k < n; ++k) {
      const double angle = 2 * pi * (k + uniform(-0.3, 0.3)) / n;
      vertices.push_back(size * Vec2(1.5 * std::cos(angle), std::sin(angle)));
    }
    const double rounding = uniform(0, 1) < 0.5 ? 0 : uniform(0.01, 0.5) * size;
    if (make_convex(vertices).empty()) return make_body({Contactor2::hull(vertices, rounding)}, 0, 100, 0);
  }
}

/// Of `rocks` rocks a profile.
void roll_down(int profiles, int rocks) {
  int without_solution = 0;
  for (int k = 0; k < profiles; ++k) {
    Draw uniform{std::mt19937(k)};
    const Profile profile = relief(static_cast<Relief>(k % 3), uniform);
    REQUIRE(profile.fault().empty());
    for (int i = 0; i < rocks; ++i) {
      INFO("profile " << k << ", rock " << i);
      Material material(uniform(0, 0.9), uniform(0, 1), i % 3 ? 0.05 : 0);
      Bench bench(profile, material);
      Body<2> body = rock(i % 2 == 0, uniform);
      const double x = uniform(-15, 60);
      body.move_to({x, profile.height(x) + (i % 5 ? uniform(1, 3) : 1.001) * body.size + 0.4}, uniform(0, 6));
      body.v = {uniform(-2, 14), uniform(-4, 4)};
      body.w = uniform(-90, 30);
      bench.add(body);
      while (bench.world.deepest_overlap().depth > 0) bench.world.bodies[0].x.y() += 0.1;
      const BodyHistory& history = bench.run(8);
      INFO(history.fault);
      REQUIRE(history.reason != StopReason::diverged);
      const Vec2 end = history.last.position.head<2>();
      if (end.x() > profile.x_min() && end.x() < profile.x_max()) REQUIRE(end.y() > profile.height(end.x()));
      // A contact of a rock that turns drifts by R (w h)^2 / 2 in a step; where its features change
      // meanwhile, a step later.
      REQUIRE(bench.world.quality().max_penetration < 1e-3 * body.size);
      without_solution += bench.world.quality().not_converged > 0;
    }
  }
  // Newton's law may have no solution for a disk that is wedged between two segments: both stick, and one
  // shall rebound.
  CHECK(without_solution <= profiles * rocks / 10'000);
}

}  // namespace

TEST_CASE("disks, polygons and rounded polygons stay above random ground") { roll_down(50, samples(6)); }

TEST_CASE("two hundred thousand disks, polygons and rounded polygons stay above fifty random profiles",
          "[heavy]") {
  roll_down(50, 4000);
}
