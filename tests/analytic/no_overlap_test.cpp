// No rock enters the ground, judged apart from the engine's own detection: every stored state of random rocks
// on random rough ground is checked against the poly-line.
#include <catch2/catch.hpp>
#include <random>

#include "analytic/lab.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace {

/// How deep a vertex lies below the poly-line, measured to its nearest segment; 0 where it is above.
double depth_below(const Profile& profile, const Vec2& p) {
  if (p.y() >= profile.height(p.x())) return 0;
  double nearest = 1e300;
  for (int i = 0; i < profile.segments(); ++i) {
    const Vec2 a = profile.points[i], along = profile.points[i + 1] - a;
    const double s = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (p - a - s * along).norm());
  }
  return nearest;
}

/// How deep a point of the poly-line lies inside the contactor; 0 where it is outside.
double depth_inside(const Contactor2& shape, const Vec2& local) {
  if (shape.points.size() == 1) return std::max(0.0, shape.radius - local.norm());
  double outside = -1e300;
  for (std::size_t e = 0; e < shape.points.size(); ++e)
    outside = std::max(outside, shape.normals[e].dot(local - shape.points[e]));
  return std::max(0.0, -outside);
}

}  // namespace

TEST_CASE("random rocks on random ground never enter it") {
  std::mt19937 rng(GENERATE(1, 2, 3, 4, 5, 6, 7, 8));
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(rng); };
  Profile profile;
  profile.parts = {""};
  for (double x = -40, y = 30; x < 80; x += uniform(0.02, 1.5)) {
    profile.points.emplace_back(x, y + uniform(-0.4, 0.4));
    y -= uniform(-0.1, 0.7);
    if (uniform(0, 1) < 0.1 && profile.points.size() > 2) {  // a vertical step
      profile.points.emplace_back(x, profile.points.back().y() - uniform(0.3, 3));
      y = profile.points.back().y();
    }
  }
  profile.part.assign(profile.points.size() - 1, 0);
  REQUIRE(profile.fault().empty());

  for (int rock = 0; rock < 12; ++rock) {
    Material material(uniform(0, 0.9), uniform(0, 1), rock % 3 ? 0.02 : 0);
    Bench bench(profile, material);
    Body<2> body;
    if (rock % 4 == 0) {
      body = disk(uniform(0.05, 1), 100, Vec2::Zero());
    } else {
      std::vector<Vec2> vertices;
      const int n = 3 + rock % 6;
      for (int k = 0; k < n; ++k) {
        const double a = 2 * pi * (k + uniform(-0.3, 0.3)) / n;
        vertices.push_back(0.4 * Vec2(1.5 * std::cos(a), std::sin(a)));
      }
      if (!make_convex(vertices).empty()) continue;
      body = make_body({Contactor2::polygon(vertices)}, 0, 100, 0);
    }
    body.move_to({uniform(-20, 0), 40}, uniform(0, 6));
    body.v = {uniform(-5, 25), uniform(-5, 10)};
    body.w = uniform(-30, 30);
    bench.add(body);
    bench.run_settings.trajectory_every = 1e-3;
    const BodyHistory& history = bench.run(20);
    REQUIRE(history.reason != StopReason::diverged);
    const Contactor2& shape = bench.world.bodies[0].contactors[0];
    // A contact drifts by r (w h)^2 / 2 in a step; where its features change meanwhile, that is projected out
    // a step later.
    const double allowed = 2e-5;
    for (const TrajectoryPoint& point : history.trajectory) {
      const Vec2 x = point.state.position.head<2>();
      if (x.x() < profile.x_min() + 2 || x.x() > profile.x_max() - 2) continue;
      const Rotation2 r = Rotation2::from_angle(point.state.angle);
      double depth = 0;
      if (shape.points.size() > 1)
        for (const Vec2& v : shape.points) depth = std::max(depth, depth_below(profile, x + r * v));
      for (const Vec2& p : profile.points)
        if ((p - x).norm() < body.size) depth = std::max(depth, depth_inside(shape, r.inverse(p - x)));
      INFO("rock " << rock << " at t = " << point.state.time << ", x = " << x.transpose() << ", angle "
                   << point.state.angle);
      REQUIRE(depth <= allowed);
    }
  }
}
