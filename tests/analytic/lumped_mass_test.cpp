// The lumped mass against closed forms, against itself in the other dimension, and against small bodies.

#include <catch2/catch.hpp>

#include "flight/point_run.h"
#include "lab.h"
#include "random/stream.h"
#include "solver/point_impact.h"

using namespace flyrock;

namespace lumped_mass_test {

namespace {

constexpr double g = 9.81;

template <int D>
Body<D> point(const Vec<D>& at, const Vec<D>& velocity, double radius = 0.5, double mass = 200) {
  Body<D> body;
  if constexpr (D == 2)
    body = make_body({Contactor2::disk(radius)}, 0, mass, 0);
  else
    body = make_body({Contactor3::sphere(radius)}, 0, mass);
  body.x = at;
  body.v = velocity;
  return body;
}

/// Runs one point on a terrain of one part.
template <int D>
BodyHistory run_on(const typename Geometry<D>::Terrain& terrain, lab::Material& material, const Body<D>& body,
                   double stop_time = 60, double rest_speed = 1e-9, double stop_speed = 0.05) {
  std::vector<PairLaws*> surfaces(parts_of(terrain).size(), &material.surface);
  PointRun<D> run;
  run.forces.gravity[D - 1] = -g;
  run.ends_at_touch = false;
  run.stop_time = stop_time;
  run.rest_speed = rest_speed;
  run.stop_speed = stop_speed;
  run.laws = surfaces;
  return run_point(body, terrain, run);
}

Terrain2 profile_of(const std::vector<Vec2>& points) {
  Profile profile;
  profile.points = points;
  profile.part.assign(points.size() - 1, 0);
  profile.parts = {""};
  return Terrain2(profile);
}

/// A profile drawn out along y.
Terrain3 extruded(const std::vector<Vec2>& points, double half_width) {
  Mesh mesh;
  for (const Vec2& p : points) {
    mesh.vertices.emplace_back(p.x(), -half_width, p.y());
    mesh.vertices.emplace_back(p.x(), half_width, p.y());
  }
  for (int i = 0; i + 1 < static_cast<int>(points.size()); ++i) {
    const int a = 2 * i;
    mesh.triangles.push_back({a, a + 2, a + 1});
    mesh.triangles.push_back({a + 1, a + 2, a + 3});
  }
  mesh.part.assign(mesh.triangles.size(), 0);
  mesh.parts = {""};
  return Terrain3(mesh);
}

std::vector<Vec2> rough_points(std::uint64_t seed, int count, double step, double height) {
  RandomStream rng(seed, "rough", {});
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i)
    points.emplace_back(step * i, -0.5 * step * i + height * rng.uniform(-1, 1));
  return points;
}

bool is_sound(const BodyHistory& h) {
  return h.last.position.allFinite() && h.last.velocity.allFinite() && h.reason != StopReason::diverged;
}

}  // namespace

TEST_CASE("bounces of a point on an incline are those of the closed form") {
  RandomStream rng(1, "inclines", {});
  for (int k = 0; k < 50; ++k) {
    const double slope = rng.uniform(0, 1.2), e = rng.uniform(0.5, 0.95), mu = rng.uniform(0, 0.4);
    const double e_t = rng.uniform(0, 0.5);
    lab::Material material(e, mu, 0, e_t);
    const Terrain2 terrain(lab::ground(2000, slope));
    const Vec2 normal(std::sin(slope), std::cos(slope)), down(std::cos(slope), -std::sin(slope));
    double vn = rng.uniform(1, 8), vt = rng.uniform(-5, 15), along = 0, time = 0;
    const BodyHistory h = run_on<2>(terrain, material, point<2>(Vec2::Zero(), vn * normal + vt * down), 20);
    for (std::size_t i = 0; i < 10 && i < h.impacts.size(); ++i) {
      const double flight = 2 * vn / (g * std::cos(slope)), pull = g * std::sin(slope);
      along += vt * flight + 0.5 * pull * flight * flight;
      vt += pull * flight;
      time += flight;
      const Impact& impact = h.impacts[i];
      CHECK((impact.place.head<2>() - along * down).norm() < 1e-10 * (1 + std::abs(along)));
      CHECK(impact.time == Approx(time).epsilon(1e-10));
      CHECK(impact.vn_before == Approx(-vn).epsilon(1e-10));
      CHECK(impact.vt_before == Approx(vt).epsilon(1e-10).margin(1e-10));
      const double lost = std::min((1 + e_t) * std::abs(vt), mu * (1 + e) * vn);
      vt -= std::copysign(lost, vt);
      vn *= e;
      CHECK(impact.vn_after == Approx(vn).epsilon(1e-10));
      CHECK(impact.vt_after == Approx(vt).epsilon(1e-10).margin(1e-10));
    }
    CHECK(h.impacts.size() >= 3);
  }
}

TEST_CASE("a point slides as far and as long as its friction says, and rests") {
  for (const double slope : {-0.2, 0.0, 0.1, 0.4}) {
    const double mu = 0.6, v = 7, rate = g * (mu * std::cos(slope) - std::sin(slope));
    lab::Material material(0.3, mu);
    const Vec2 down(std::cos(slope), -std::sin(slope));
    const BodyHistory h =
        run_on<2>(Terrain2(lab::ground(200, slope, 7)), material, point<2>(Vec2::Zero(), v * down));
    CHECK(h.reason == StopReason::stopped);
    CHECK((h.last.position.head<2>() - v * v / (2 * rate) * down).norm() < 1e-10);
    CHECK(h.last.position.head<2>().norm() == Approx(h.travel.distance[2]).epsilon(1e-4));
    CHECK(h.stop_time == Approx((v - 0.05) / rate).epsilon(1e-10));
    CHECK(h.last.time == Approx(h.stop_time + 0.2).epsilon(1e-10));
    CHECK(h.impact_count == 0);
  }
  lab::Material slippery(0.3, 0.1);  // tan 0.4 > 0.1
  const BodyHistory h =
      run_on<2>(Terrain2(lab::ground(500, 0.4, 50)), slippery, point<2>(Vec2::Zero(), Vec2::Zero()), 5);
  const double rate = g * (std::sin(0.4) - 0.1 * std::cos(0.4));
  CHECK(h.reason == StopReason::timed_out);
  CHECK(h.last.position.head<2>().norm() == Approx(0.5 * rate * 25).epsilon(1e-10));
  lab::Material rolling(0.3, 0.6, 0.05);  // mu_r/R = 0.1
  const BodyHistory rolled =
      run_on<2>(Terrain2(lab::ground(500, 0.4, 50)), rolling, point<2>(Vec2::Zero(), Vec2::Zero()), 5);
  CHECK(rolled.last.position.head<2>().norm() == Approx(0.5 * rate * 25).epsilon(1e-10));
  CHECK(rolled.travel.distance[3] > 0);
}

TEST_CASE("a point leaves a convex edge on its parabola and slides over a concave one") {
  lab::Material material(0.5, 0.2);
  // 2 m of level ground, then 10 m down.
  const Terrain2 cliff = profile_of({{-10, 0}, {2, 0}, {2, -10}, {40, -10}});
  const BodyHistory h = run_on<2>(cliff, material, point<2>({0, 0}, {6, 0}), 60);
  const double v = std::sqrt(36 - 2 * 0.2 * g * 2);
  REQUIRE(h.impact_count > 0);
  CHECK(h.impacts[0].place.x() == Approx(2 + v * std::sqrt(20 / g)).epsilon(1e-10));
  CHECK(h.impacts[0].vt_before == Approx(v).epsilon(1e-10));
  CHECK(h.reason == StopReason::stopped);
  // Down 0.1 rad and up 0.1 rad, without friction and restitution below 3 m/s: v cos(0.2) after the edge.
  lab::Material smooth(0.5, 0);
  const Terrain2 valley = profile_of({{-50, 50 * std::tan(0.1)}, {0, 0}, {50, 50 * std::tan(0.1)}});
  const Vec2 start(-5, 5 * std::tan(0.1));
  const BodyHistory through = run_on<2>(valley, smooth, point<2>(start, {0, 0}), 2000, 3, 0.01);
  CHECK(through.impact_count == 0);
  const double speed = std::sqrt(2 * g * start.y()) * std::cos(0.2);
  CHECK(through.max.position.x() == Approx(speed * speed / (2 * g * std::tan(0.1))).epsilon(1e-9));
  CHECK(through.reason == StopReason::stopped);
  CHECK(std::abs(through.last.position.x()) < 1e-3);
}

TEST_CASE("vertical faces, grazing paths and starts on vertices") {
  lab::Material material(0.5, 0.3);
  const std::vector<Vec2> steps{{-20, 10}, {0, 10}, {0, 0}, {5, 0}, {5, 8}, {9, 8}, {12, 4}, {30, 4}};
  const Terrain2 terrain = profile_of(steps);
  // Into the upright face at x = 5, then back to that at x = 0.
  const BodyHistory h = run_on<2>(terrain, material, point<2>({-1, 10.5}, {8, 0}), 60);
  CHECK(is_sound(h));
  CHECK(h.reason == StopReason::stopped);
  bool wall = false;
  for (const Impact& impact : h.impacts) wall = wall || std::abs(impact.place.x() - 5) < 1e-9;
  CHECK(wall);
  // Falls along the upright face without touching it.
  const BodyHistory edge = run_on<2>(terrain, material, point<2>({0, 10}, {1e-15, 0}), 60);
  CHECK(is_sound(edge));
  // Grazes the corner at (5, 8) by design.
  for (const double above : {-1e-10, 0.0, 1e-10, 1e-7}) {
    const double t = 0.5;
    const BodyHistory grazing =
        run_on<2>(terrain, material, point<2>({5 - 4 * t, 8 + above - 0.5 * g * t * t}, {4, g * t}), 60);
    CHECK(is_sound(grazing));
    CHECK(grazing.reason == StopReason::stopped);
  }
  for (const Vec2& vertex : {steps[1], steps[4], steps[5], steps[6]})
    for (const Vec2& velocity : {Vec2(0, 0), Vec2(3, 0), Vec2(-3, 0), Vec2(2, -4), Vec2(-1, 4)}) {
      INFO(vertex.transpose() << " " << velocity.transpose());
      const BodyHistory at = run_on<2>(terrain, material, point<2>(vertex, velocity), 60);
      CHECK(is_sound(at));
    }
}

TEST_CASE("a point on an extruded profile goes as on the profile") {
  RandomStream rng(3, "extruded", {});
  int compared = 0;
  for (int k = 0; k < 30; ++k) {
    const std::vector<Vec2> points = rough_points(k, 60, 2, k % 3 == 0 ? 0.0 : 0.6);
    lab::Material material(rng.uniform(0.2, 0.7), rng.uniform(0.1, 0.6)),
        same(material.newton.e_n, material.coulomb.mu);
    const Vec2 start(rng.uniform(3, 6), rng.uniform(1, 4)), v(rng.uniform(0, 8), rng.uniform(-4, 4));
    const BodyHistory flat = run_on<2>(profile_of(points), material, point<2>(start, v), 30, 0.02);
    const BodyHistory space = run_on<3>(extruded(points, 50), same,
                                        point<3>({start.x(), 0.123, start.y()}, {v.x(), 0, v.y()}), 30, 0.02);
    INFO(k << " " << name_of(flat.reason) << " " << flat.fault << " " << name_of(space.reason) << " "
           << space.fault);
    REQUIRE(is_sound(flat));
    REQUIRE(is_sound(space));
    CHECK(flat.impact_count == space.impact_count);
    CHECK(flat.reason == space.reason);
    CHECK(std::abs(flat.last.position.x() - space.last.position.x()) < 1e-9);
    CHECK(std::abs(flat.last.position.y() - space.last.position.z()) < 1e-9);
    CHECK(flat.last.time == Approx(space.last.time).epsilon(1e-9));
    CHECK(flat.bounce_height == Approx(space.bounce_height).epsilon(1e-9));
    compared += flat.impact_count;
  }
  CHECK(compared > 100);
}

TEST_CASE("a disk of 1 mm without friction bounces like the point on its path") {
  for (const double slope : {0.0, 0.3, 0.7}) {
    const double radius = 1e-3;
    lab::Material material(0.8, 0), same(0.8, 0);
    const Vec2 normal(std::sin(slope), std::cos(slope));
    const Vec2 start = 0.7 * normal, v(2, 1);
    lab::Bench bench(lab::ground(500, slope), material, {.time_step = 1e-3, .rest_speed = 1e-3});
    bench.add(lab::disk(radius, 1, start + radius * normal, v));
    const BodyHistory body = bench.run(8);
    const BodyHistory flown = run_on<2>(Terrain2(lab::ground(500, slope)), same, point<2>(start, v), 8, 1e-3);
    for (std::size_t i = 0; i < 8; ++i) {
      REQUIRE(i < std::min(body.impacts.size(), flown.impacts.size()));
      CHECK((body.impacts[i].place - flown.impacts[i].place).norm() < 1e-5);
      CHECK(body.impacts[i].vn_after == Approx(flown.impacts[i].vn_after).epsilon(1e-9));
    }
  }
}

TEST_CASE("a point that slides askew in 3D turns towards the fall line as the equation of motion says") {
  const double slope = 0.5, mu = 0.4;
  lab::Material material(0.3, mu);
  Plane plane;
  plane.normal = Vec3(std::sin(slope), 0, std::cos(slope));
  const Vec3 down(std::cos(slope), 0, -std::sin(slope)), side = Vec3::UnitY();
  for (const Vec2& from : {Vec2(0, 5), Vec2(-4, 3), Vec2(-6, 0.5), Vec2(3, -2)}) {
    const double end = 2;
    const BodyHistory h =
        run_on<3>(Terrain3(plane), material, point<3>(Vec3::Zero(), from[0] * down + from[1] * side), end);
    // The classical Runge-Kutta scheme.
    Vec2 x = Vec2::Zero(), v = from;
    const auto rate = [&](const Vec2& u) -> Vec2 {
      return Vec2(g * std::sin(slope), 0) - mu * g * std::cos(slope) * u.normalized();
    };
    const int steps = 20000;
    const double dt = end / steps;
    for (int i = 0; i < steps; ++i) {
      const Vec2 a = rate(v), b = rate(v + dt / 2 * a), c = rate(v + dt / 2 * b), d = rate(v + dt * c);
      x += dt * v + dt * dt / 6 * (a + b + c);
      v += dt / 6 * (a + 2 * b + 2 * c + d);
    }
    INFO(from.transpose());
    CHECK((h.last.position - (x[0] * down + x[1] * side)).norm() < 1e-6);
    CHECK((h.last.velocity - (v[0] * down + v[1] * side)).norm() < 1e-6);
    CHECK(h.reason == StopReason::timed_out);
  }
}

TEST_CASE("points on rough ground end, above the ground and without a number that is none") {
  RandomStream rng(7, "rough ground", {});
  for (int k = 0; k < 100; ++k) {
    lab::Material material(rng.uniform(0, 0.8), rng.uniform(0, 0.9), k % 2 ? 0.1 : 0);
    const std::vector<Vec2> points = rough_points(100 + k, 80, 1, 0.8);
    const BodyHistory h = run_on<2>(profile_of(points), material,
                                    point<2>({rng.uniform(1, 5), 2}, {rng.uniform(-2, 9), 0}), 60, 0.02);
    INFO(k << " " << name_of(h.reason) << " " << h.fault);
    REQUIRE(is_sound(h));
    HeightGrid grid;
    grid.columns = 30;
    grid.rows = 20;
    grid.cell = 1.5;
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column)
        grid.heights.push_back(-0.6 * column + rng.uniform(-0.7, 0.7));
    grid.heights[10 * 30 + 20] = std::nan("");
    const BodyHistory space = run_on<3>(
        Terrain3(grid), material,
        point<3>({rng.uniform(3, 12), rng.uniform(5, 24), 4}, {rng.uniform(-1, 6), rng.uniform(-2, 2), 0}),
        60, 0.02);
    INFO(k << " " << name_of(space.reason) << " " << space.fault);
    REQUIRE(is_sound(space));
    CHECK((space.reason == StopReason::stopped || space.reason == StopReason::left_domain));
  }
}

TEST_CASE(
    "a point over a cell without data has left the ground, and one that starts on a vertex or edge goes") {
  HeightGrid grid;
  grid.columns = grid.rows = 6;
  grid.cell = 1;
  grid.heights.assign(36, 0.0);
  grid.heights[2 * 6 + 4] = std::nan("");
  const Terrain3 terrain(grid);
  lab::Material material(0.4, 0.2);
  const BodyHistory over = run_on<3>(terrain, material, point<3>({1, 2, 0.5}, {5, 0, 0}));
  CHECK(over.reason == StopReason::left_domain);
  CHECK(over.fault == "it has no ground below it");
  CHECK(over.last.position.x() == Approx(3).epsilon(1e-6));
  const BodyHistory slid = run_on<3>(terrain, material, point<3>({1, 2, 0}, {5, 0, 0}));
  CHECK(slid.reason == StopReason::left_domain);
  CHECK(slid.last.position.x() == Approx(3).epsilon(1e-6));
  for (const Vec3& velocity : {Vec3(0, 0, 0), Vec3(0.5, 0, 0), Vec3(0.3, 0.3, 0), Vec3(0.3, -0.3, -2)})
    for (const Vec3& at : {Vec3(1, 4, 0), Vec3(1.5, 4, 0), Vec3(1.5, 3.5, 0), Vec3(1.3, 3.6, 0)}) {
      const BodyHistory h = run_on<3>(terrain, material, point<3>(at, velocity));
      INFO(velocity.transpose() << " " << at.transpose() << " " << h.fault);
      CHECK(h.reason == StopReason::stopped);
      CHECK(std::abs(h.last.position.z()) < 1e-9);
    }
}

TEST_CASE("a point touches the underside of an overhang and rebounds downwards") {
  Mesh mesh;  // a floor at z = 0 and a roof that looks down at z = 3 over x > 2, joined at x = 6
  mesh.vertices = {{-6, -5, 0}, {-6, 5, 0}, {6, -5, 0}, {6, 5, 0}, {2, -5, 3}, {2, 5, 3}};
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}};
  mesh.part = {0, 0, 0, 0};
  mesh.parts = {""};
  lab::Material material(0.5, 0.3);
  const BodyHistory h = run_on<3>(Terrain3(mesh), material, point<3>({0, 0, 1}, {6, 0, 6}));
  INFO(h.fault);
  CHECK(is_sound(h));
  REQUIRE(h.impact_count > 1);
  CHECK(h.impacts[0].place.z() > 1);
  CHECK(h.impacts[0].vn_after == Approx(-0.5 * h.impacts[0].vn_before).epsilon(1e-12));
  CHECK(h.reason == StopReason::stopped);
}

TEST_CASE("the impact of a point is that of the solver for one contact with W = 1/m") {
  RandomStream rng(11, "impacts", {});
  for (int k = 0; k < 200; ++k)
    for (const RestitutionForm form :
         {RestitutionForm::newton, RestitutionForm::newton_mean, RestitutionForm::poisson,
          RestitutionForm::energy, RestitutionForm::velocity}) {
      const bool has_e_t = form == RestitutionForm::newton || form == RestitutionForm::velocity;
      const Restitution law{rng.uniform(), has_e_t ? rng.uniform(-1, 1) : 0, form};
      const double mu = rng.uniform(0, 1), mass = rng.uniform(1, 100);
      const Vec3 v(-rng.uniform(0.1, 5), rng.uniform(-5, 5), rng.uniform(-5, 5));
      ContactProblem<3> problem;
      auto& contact = problem.contacts.emplace_back();
      contact.w.setZero();
      contact.w.topLeftCorner<3, 3>() = Eigen::Matrix3d::Identity() / mass;
      contact.q.setZero();
      contact.q.head<3>() = v;
      contact.mu = mu;
      contact.speed_scale = 5;
      problem.first = {0, 0};
      std::vector<Rebound<3>> rebounds(1);
      static_cast<Restitution&>(rebounds[0]) = law;
      rebounds[0].before.head<3>() = v;
      std::vector<ContactProblem<3>::Row> impulse(1, ContactProblem<3>::Row::Zero());
      SolveSettings settings;
      settings.tolerance = 1e-13;
      settings.to_rounding = true;
      ImpactSolver<3>().solve(problem, rebounds, settings, impulse);
      const Vec3 expected = v + impulse[0].head<3>() / mass, found = rebound_of_point<3>(v, law, mu);
      INFO(name_of(form));
      CHECK((found - expected).norm() < 1e-9);
    }
}

TEST_CASE("fences and gates act on a point in flight and on one that slides") {
  lab::Material material(0.3, 0.5);
  const Terrain2 terrain(lab::ground(100));
  PairLaws* const surfaces[] = {&material.surface};
  PointRun<2> run;
  run.forces.gravity = {0, -g};
  run.ends_at_touch = false;
  run.laws = surfaces;
  const Body<2> body = point<2>({0, 0}, {10, 0}, 0.5, 200);
  const std::vector<Gate> gates{{3}, {50}};
  run.gates = gates;
  const BodyHistory free = run_point(body, terrain, run);
  REQUIRE(free.passages.size() == 1);
  const double speed = std::sqrt(100 - 2 * 0.5 * g * 3), energy = 100 * speed * speed;
  CHECK(free.passages[0].speed == Approx(speed).epsilon(1e-12));
  CHECK(free.passages[0].kinetic_energy == Approx(energy).epsilon(1e-12));
  const auto fenced = [&](double capacity, const Body<2>& rock) {
    const std::vector<Barrier> fence{{3, 2, capacity}};
    run.barriers = fence;
    return run_point(rock, terrain, run);
  };
  const BodyHistory caught = fenced(1.01 * energy, body);
  CHECK(caught.reason == StopReason::caught);
  CHECK(caught.last.position.x() == Approx(3).epsilon(1e-12));
  const BodyHistory through = fenced(0.36 * energy, body);
  CHECK(through.barriers.at(0).outcome == BarrierOutcome::over_energy);
  CHECK(through.reason == StopReason::stopped);
  CHECK(through.last.position.x() == Approx(3 + 0.64 * speed * speed / g).epsilon(1e-10));
  const BodyHistory flown = fenced(1e9, point<2>({0, 1}, {10, 0}));
  CHECK(flown.reason == StopReason::caught);
  CHECK(flown.barriers.at(0).height == Approx(1 - 0.5 * g * 0.09).epsilon(1e-10));
}

TEST_CASE("points in air and wind on rough ground end, and air takes what it takes of a ballistic flight") {
  RandomStream rng(13, "air", {});
  for (int k = 0; k < 30; ++k) {
    lab::Material material(rng.uniform(0, 0.8), rng.uniform(0, 0.9));
    const Terrain2 terrain = profile_of(rough_points(500 + k, 80, 1, 0.8));
    PairLaws* const surfaces[] = {&material.surface};
    const Body<2> body = point<2>({rng.uniform(1, 5), 4}, {rng.uniform(-2, 9), rng.uniform(0, 5)});
    PointRun<2> run;
    run.forces = {{0, -g}, {rng.uniform(0.001, 0.2), {rng.uniform(-5, 5), 0}}};
    const BodyHistory flight = run_point(body, terrain, run);
    run.ends_at_touch = false;
    run.laws = surfaces;
    const BodyHistory h = run_point(body, terrain, run);
    INFO(k << " " << name_of(h.reason) << " " << h.fault);
    REQUIRE(is_sound(h));
    CHECK(h.reason != StopReason::timed_out);
    if (!h.impacts.empty()) CHECK((h.impacts[0].place - flight.last.position).norm() < 1e-9);
  }
}

}  // namespace lumped_mass_test
