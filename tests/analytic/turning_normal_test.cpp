// Contacts whose normal, or whose other surface, turns: swings in drums and tubes, on pegs and cylinders, the
// turntable, and rocks that roll over a crest, against closed forms.
#include <catch2/catch.hpp>

#include "analytic/lab_3d.h"
#include "dice.h"
#include "geometry/mesh.h"
#include "math/elliptic.h"
#include "samples.h"
#include "world/step_control.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace turning_normal_test {

namespace {

constexpr double g = 9.81, floor_depth = 40, grip = 1000, step_tolerance = 1e-3;

/// The settings of a scenario without a solver section.
WorldSettings defaults() {
  WorldSettings settings;
  settings.step_tolerance = step_tolerance;
  return settings;
}

WorldSettings fixed_steps(double h) {
  WorldSettings settings;
  settings.time_step = h;
  settings.tolerance = 1e-12;
  return settings;
}

Profile floor_far_below() {
  Profile floor = ground(50);
  for (Vec2& point : floor.points) point.y() = -floor_depth;
  return floor;
}

Plane plane_far_below() {
  Plane floor;
  floor.point = {0, 0, -floor_depth};
  return floor;
}

template <int D>
Body<D> fixed(Body<D> body) {
  body.kind = BodyKind::fixed;
  return body;
}

Body<2> ring(double inner, double mass) {
  return make_body({Contactor2::hollow_disk(inner, 1.1 * inner)}, 0, mass, 0);
}

/// A tube along y.
Body<3> tube(double inner) {
  Body<3> body = make_body({Contactor3::hollow_cylinder(inner, 1.1 * inner, 200)}, 1000, 0);
  body.attitude = Rotation3::from_vector({0.5 * pi, 0, 0}) * body.attitude.rotation;
  return fixed(body);
}

/// The angle of a pendulum with theta'' = -w^2 sin(theta), released at rest from `start`.
double pendulum(double start, double w, double time) {
  const double k = std::sin(0.5 * start);
  const auto [sn, cn, dn, third] = EllipticFunctions({k * k, 1 - k * k}, -1).at(w * time);
  return 2 * std::asin(k * cn / dn);
}

/// What a run is compared with: the place of a body, and the energy that its motion exchanges.
struct Judged {
  double place = 0;   ///< m, error
  double energy = 0;  ///< share of the swing
};

/// Runs without rest; compares body `i` with `expected`. `swing` [J] is the energy that the motion exchanges.
template <class Bench, class Place>
Judged judge(Bench& bench, int i, double time, const Place& expected, double swing) {
  bench.run_settings.stop_speed = 0;
  const double before = bench.world.total_energy();
  bench.run(time);
  return {(bench.world.bodies[i].x - expected).norm(), std::abs(bench.world.total_energy() - before) / swing};
}

/// A disk that swings in a drum; with grip it rolls.
Judged in_drum(double inner, double radius, double mass, double start, bool rolls, double time,
               const WorldSettings& settings) {
  Material material(0, rolls ? grip : 0);
  Bench bench(floor_far_below(), material, settings);
  const double arm = inner - radius;
  const auto at = [&](double angle) -> Vec2 { return arm * Vec2(std::sin(angle), -std::cos(angle)); };
  bench.add(fixed(ring(inner, 1)));
  const int i = bench.add(disk(radius, mass, at(start)));
  const double w = std::sqrt(g / arm / (rolls ? 1.5 : 1));
  return judge(bench, i, time, at(pendulum(start, w, time)), mass * g * arm * (1 - std::cos(start)));
}

/// A disk that rolls without slip in a drum that turns: the same swing, and a spin in addition.
Judged in_turning_drum(double inner, double radius, double mass, double start, double spin, double time,
                       const WorldSettings& settings) {
  Material material(0, grip);
  Bench bench(floor_far_below(), material, settings);
  const double arm = inner - radius;
  const auto at = [&](double angle) -> Vec2 { return arm * Vec2(std::sin(angle), -std::cos(angle)); };
  Body<2> drum = ring(inner, 1);
  drum.kind = BodyKind::driven;
  drum.w = spin;
  bench.add(drum);
  const int i = bench.add(disk(radius, mass, at(start), {0, 0}, spin * inner / radius));
  const double end = pendulum(start, std::sqrt(g / arm / 1.5), time);
  return judge(bench, i, time, at(end), mass * g * arm * (1 - std::cos(start)));
}

/// A ring that swings on a peg; with grip it rolls on it.
Judged on_peg(double inner, double radius, double mass, double start, bool rolls, double time,
              const WorldSettings& settings) {
  Material material(0, rolls ? grip : 0);
  Bench bench(floor_far_below(), material, settings);
  const double arm = inner - radius;
  const auto at = [&](double angle) -> Vec2 { return arm * Vec2(std::sin(angle), -std::cos(angle)); };
  bench.add(fixed(disk(radius, 1, Vec2::Zero())));
  Body<2> hung = ring(inner, mass);
  hung.move_to(at(start), 0);
  const double inertia = hung.inertia;
  const int i = bench.add(hung);
  const double w = std::sqrt(g / arm / (rolls ? 1 + inertia / (mass * inner * inner) : 1));
  return judge(bench, i, time, at(pendulum(start, w, time)), mass * g * arm * (1 - std::cos(start)));
}

/// A sphere that swings in a tube and moves along it.
Judged in_tube(double inner, double radius, double mass, double start, bool rolls, double time,
               const WorldSettings& settings) {
  Material material(0, rolls ? grip : 0);
  Bench3 bench(plane_far_below(), material, settings);
  const double arm = inner - radius, along = rolls ? 0 : 0.5;
  const auto at = [&](double angle, double t) -> Vec3 {
    return {arm * std::sin(angle), along * t, -arm * std::cos(angle)};
  };
  bench.add(tube(inner));
  const int i = bench.add(sphere(radius, mass, at(start, 0), {0, along, 0}));
  const double w = std::sqrt(g / arm / (rolls ? 1.4 : 1));
  return judge(bench, i, time, at(pendulum(start, w, time), time), mass * g * arm * (1 - std::cos(start)));
}

/// A cylinder that swings without friction in a tube, along which it moves.
Judged cylinder_in_tube(double inner, double radius, double height, double mass, double start, double time,
                        const WorldSettings& settings) {
  Material material(0, 0);
  Bench3 bench(plane_far_below(), material, settings);
  const double arm = inner - radius, along = 0.15;
  const auto at = [&](double angle, double t) -> Vec3 {
    return {arm * std::sin(angle), along * t, -arm * std::cos(angle)};
  };
  const Body<3> outer = tube(inner);
  bench.add(outer);
  Body<3> body = make_body({Contactor3::cylinder(radius, height)}, 0, mass);
  body.attitude = outer.attitude;
  body.x = at(start, 0);
  body.v = {0, along, 0};
  const int i = bench.add(body);
  return judge(bench, i, time, at(pendulum(start, std::sqrt(g / arm), time), time),
               mass * g * arm * (1 - std::cos(start)));
}

/// A sphere that rolls on a table which turns: circles with 2/7 of its spin (Weltner 1979).
Judged on_turntable(double spin, double radius, double mass, const Vec2& from, const Vec2& velocity,
                    double time, const WorldSettings& settings) {
  Material material(0, 0.8);
  Bench3 bench(plane_far_below(), material, settings);
  Body<3> table = make_body({Contactor3::cylinder(30, 0.2)}, 1000, 0);
  table.x = {0, 0, -0.1};
  table.kind = BodyKind::driven;
  table.w = {0, 0, spin};
  bench.add(table);
  // It rolls on the surface below it.
  const Vec2 slip = velocity - spin * Vec2(-from.y(), from.x());
  const int i = bench.add(sphere(radius, mass, {from.x(), from.y(), radius}, {velocity.x(), velocity.y(), 0},
                                 {-slip.y() / radius, slip.x() / radius, 0}));
  const double w = 2.0 / 7 * spin;
  const Vec2 centre = from + Vec2(-velocity.y(), velocity.x()) / w;
  const Vec2 end = centre + Rotation2::from_angle(w * time) * Vec2(from - centre);
  return judge(bench, i, time, Vec3(end.x(), end.y(), radius), 0.7 * mass * velocity.squaredNorm());
}

/// Runge and Kutta's scheme for theta'' = slope(theta, rate).
template <class Slope>
void integrate(double& theta, double& rate, double time, int parts, const Slope& slope) {
  const double dt = time / parts;
  for (int i = 0; i < parts; ++i) {
    const double k1 = rate, l1 = slope(theta, rate);
    const double k2 = rate + 0.5 * dt * l1, l2 = slope(theta + 0.5 * dt * k1, k2);
    const double k3 = rate + 0.5 * dt * l2, l3 = slope(theta + 0.5 * dt * k2, k3);
    const double k4 = rate + dt * l3, l4 = slope(theta + dt * k3, k4);
    theta += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    rate += dt / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
  }
}

/// A plank that rocks on a cylinder without slip, released at rest with its middle at the angle `start` of
/// roll.
Judged plank(double radius, double length, double height, double mass, double start, double time,
             const WorldSettings& settings) {
  Material material(0, grip);
  Bench bench(floor_far_below(), material, settings);
  const double a = 0.5 * height;
  const auto at = [&](double t) -> Vec2 {
    return (radius + a) * Vec2(std::sin(t), std::cos(t)) - radius * t * Vec2(std::cos(t), -std::sin(t));
  };
  bench.add(fixed(disk(radius, 1, Vec2::Zero())));
  Body<2> body = box(length, height, mass, at(start), -start);
  const double inertia = body.inertia / mass;
  const int i = bench.add(body);
  double theta = start, rate = 0;
  // L = (a^2 + R^2 theta^2 + I/m) theta'^2 / 2 - g ((R + a) cos theta + R theta sin theta)
  integrate(theta, rate, time, 20000, [&](double t, double w) {
    const double slope = g * (-a * std::sin(t) + radius * t * std::cos(t));
    return -(slope + radius * radius * t * w * w) / (a * a + radius * radius * t * t + inertia);
  });
  const double swing = mass * g * (at(start).y() - at(0).y());
  return judge(bench, i, time, at(theta), swing);
}

/// A slab that rocks on a sphere, about the y axis; only its energy is judged.
Judged slab(double radius, const Vec3& size, double mass, double start, double time,
            const WorldSettings& settings) {
  Material material(0, grip);
  Bench3 bench(plane_far_below(), material, settings);
  const auto at = [&](double t) -> Vec3 {
    const double up = radius + 0.5 * size.z();
    return {up * std::sin(t) - radius * t * std::cos(t), 0, up * std::cos(t) + radius * t * std::sin(t)};
  };
  bench.add(fixed(sphere(radius, 1, Vec3::Zero())));
  Body<3> body = make_body({Contactor3::box(size)}, 0, mass);
  body.attitude = Rotation3::from_vector({0, start, 0}) * body.attitude.rotation;
  body.x = at(start);
  const int i = bench.add(body);
  Judged judged = judge(bench, i, time, at(start), mass * g * (at(start).z() - at(0).z()));
  judged.place = 0;
  return judged;
}

/// The end of the level part of the ground, before a face that falls by 80 degrees.
Profile crest() {
  Profile profile;
  const double depth = floor_depth, out = depth / std::tan(80 * pi / 180);
  profile.points = {{-50, 0}, {0, 0}, {out, -depth}, {out + 50, -depth}};
  profile.part = {0, 0, 0};
  profile.parts = {""};
  return profile;
}

Mesh crest_mesh(double azimuth) {
  Mesh mesh;
  const Profile line = crest();
  for (const Vec2& p : line.points)
    for (const double y : {-50.0, 50.0})
      mesh.vertices.push_back({std::cos(azimuth) * p.x() - std::sin(azimuth) * y,
                               std::sin(azimuth) * p.x() + std::cos(azimuth) * y, p.y()});
  for (int k = 0; k < 3; ++k) {
    mesh.triangles.push_back({2 * k, 2 * k + 2, 2 * k + 3});
    mesh.triangles.push_back({2 * k, 2 * k + 3, 2 * k + 1});
  }
  mesh.part.assign(mesh.triangles.size(), 0);
  mesh.parts = {""};
  return mesh;
}

/// The way of a round body of radius R over the crest, from level ground with the speed v: it rolls (or, with
/// share = 0, slides) about the edge and leaves it where N = 0,
///   (1 + share) v^2 / 2 + g R cos theta = const,  v^2 = g R cos theta,   share = I/(m R^2)
struct OverCrest {
  double radius, share, speed;
  double leaves() const {  ///< the cosine of the angle
    return ((1 + share) * speed * speed / (2 * g * radius) + 1) / (1 + 0.5 * (1 + share));
  }
  /// The place at a time after the centre has passed the edge, before it lands (x along the path).
  Vec2 place(double time) const {
    const double cosine = leaves();
    double theta = 0, rate = speed / radius;
    // The time at which it leaves: by bisection of the closed form's angle with fine steps.
    const auto slope = [&](double t, double) { return g / radius * std::sin(t) / (1 + share); };
    constexpr double dt = 2e-5;
    double t = 0;
    while (t < time) {
      double next = theta, next_rate = rate;
      integrate(next, next_rate, dt, 1, slope);
      if (std::cos(next) < cosine) break;
      theta = next;
      rate = next_rate;
      t += dt;
    }
    double low = 0, high = dt;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      double next = theta, next_rate = rate;
      integrate(next, next_rate, middle, 1, slope);
      (std::cos(next) < cosine ? high : low) = middle;
    }
    integrate(theta, rate, low, 1, slope);
    const double left = time - t - low;
    const Vec2 v = radius * rate * Vec2(std::cos(theta), -std::sin(theta));
    return radius * Vec2(std::sin(theta), std::cos(theta)) + left * v + Vec2(0, -0.5 * g * left * left);
  }
};

Judged disk_over_crest(double radius, double mass, double speed, double run_up, bool rolls, double time,
                       const WorldSettings& settings) {
  Material material(0, rolls ? grip : 0);
  Bench bench(crest(), material, settings);
  const int i = bench.add(disk(radius, mass, {-run_up, radius}, {speed, 0}, rolls ? -speed / radius : 0));
  const OverCrest path{radius, rolls ? 0.5 : 0, speed};
  return judge(bench, i, time, path.place(time - run_up / speed), mass * g * radius);
}

Judged sphere_over_crest(double radius, double mass, double speed, double run_up, bool rolls, double azimuth,
                         double time, const WorldSettings& settings) {
  Material material(0, rolls ? grip : 0);
  Bench3 bench(crest_mesh(azimuth), material, settings);
  const Vec3 ahead(std::cos(azimuth), std::sin(azimuth), 0), left(-std::sin(azimuth), std::cos(azimuth), 0);
  const auto at = [&](const Vec2& p) -> Vec3 { return p.x() * ahead + Vec3(0, 0, p.y()); };
  const Vec3 spin = rolls ? Vec3(speed / radius * left) : Vec3::Zero();
  const int i = bench.add(sphere(radius, mass, at({-run_up, radius}), speed * ahead, spin));
  const OverCrest path{radius, rolls ? 0.4 : 0, speed};
  return judge(bench, i, time, at(path.place(time - run_up / speed)), mass * g * radius);
}

/// A swing of random dimensions.
struct Swing {
  double inner, radius, mass, start;
  explicit Swing(Dice& dice)
      : inner(dice(0.5, 2)), radius(inner * dice(0.1, 0.6)), mass(dice(1, 100)), start(dice(0.3, 1.5)) {}
};

/// The tolerance of a step holds for as long again as the phase has lasted: over 10 s the errors add up to a
/// few times of it.
constexpr double over_ten_seconds = 2.5 * step_tolerance;

/// Energy to 1e-3 of the swing, place to `share` of the diameter.
void check_swing(const Judged& judged, double radius, double share = over_ten_seconds) {
  CHECK(judged.energy < 1e-3);
  CHECK(judged.place < share * 2 * radius);
}

}  // namespace

TEST_CASE("what swings in a drum, on a peg or in a tube keeps its energy for 10 s at the defaults") {
  Dice dice(7);
  for (const bool rolls : {false, true})
    for (int n = 0; n < samples(15); ++n) {
      const Swing s(dice);
      CAPTURE(s.inner, s.radius, s.start, rolls);
      check_swing(in_drum(s.inner, s.radius, s.mass, s.start, rolls, 10, defaults()), s.radius);
      check_swing(on_peg(s.inner, s.radius, s.mass, s.start, rolls, 10, defaults()), s.radius);
      check_swing(in_tube(s.inner, s.radius, s.mass, s.start, rolls, 10, defaults()), s.radius);
    }
}

TEST_CASE("a disk rolls in a drum that turns, which does not press it") {
  Dice dice(11);
  for (int n = 0; n < samples(15); ++n) {
    const Swing s(dice);
    const double spin = dice(-5, 5);
    CAPTURE(s.inner, s.radius, s.start, spin);
    const double share = over_ten_seconds;
    CHECK(in_turning_drum(s.inner, s.radius, s.mass, s.start, spin, 10, defaults()).place <
          share * 2 * s.radius);
  }
}

TEST_CASE("the rims of a cylinder do not collide with the tube in which it swings") {
  Dice dice(12);
  for (int n = 0; n < samples(4); ++n) {
    const Swing s(dice);
    const double height = s.radius * dice(0.2, 3);
    CAPTURE(s.inner, s.radius, s.start, height);
    check_swing(cylinder_in_tube(s.inner, s.radius, height, s.mass, s.start, 10, defaults()), s.radius);
  }
}

TEST_CASE("a plank rocks on a cylinder and keeps its energy for 10 s at the defaults") {
  Dice dice(8);
  for (int n = 0; n < samples(15); ++n) {
    const double height = dice(0.05, 0.2), radius = height * dice(1, 3), length = dice(1, 2),
                 start = dice(0.05, 0.3);
    CAPTURE(height, radius, length, start);
    check_swing(plank(radius, length, height, dice(1, 100), start, 10, defaults()),
                std::sqrt(height * length / pi));
  }
}

/// Chosen steps err by a share of the size, whatever the swing is: small ones, of a twentieth of the length,
/// by up to 2 % of their energy.
TEST_CASE("a slab that rocks on a large sphere keeps the energy of its swing") {
  Dice dice(14);
  for (int n = 0; n < samples(15); ++n) {
    const Vec3 size(dice(0.5, 2), dice(0.5, 1.5), dice(0.05, 0.3));
    const double radius = dice(10, 60), start = dice(0.05, 0.3) * size.x() / radius;
    CAPTURE(radius, size, start);
    CHECK(slab(radius, size, dice(1, 100), start, 5, defaults()).energy < 0.025);
  }
}

TEST_CASE("a sphere on a turntable goes in circles at 2/7 of the spin of the table") {
  Dice dice(9);
  for (int n = 0; n < samples(8); ++n) {
    const double spin = dice(0.5, 4), radius = dice(0.05, 0.3);
    const Vec2 from(dice(-1, 1), dice(-1, 1)), velocity(dice(-1, 1), dice(-1, 1));
    CAPTURE(spin, radius, from, velocity);
    const Judged judged = on_turntable(spin, radius, 5, from, velocity, 10, defaults());
    CHECK(judged.place < step_tolerance * 2 * radius);
  }
}

TEST_CASE("a disk and a sphere leave a crest where N = 0") {
  CHECK(OverCrest{1, 0.4, 0}.leaves() == Approx(10.0 / 17));
  CHECK(OverCrest{1, 0, 0}.leaves() == Approx(2.0 / 3));
  Dice dice(10);
  for (const bool rolls : {false, true})
    for (int n = 0; n < samples(6); ++n) {
      const double radius = dice(0.1, 1), mass = dice(1, 100), run_up = 0.3,
                   speed = dice(0.05, 0.7) * std::sqrt(g * radius);
      const double after = 4 * std::sqrt(radius / g), time = run_up / speed + after;
      CAPTURE(radius, speed, rolls);
      // The error of the velocity goes on in the flight.
      const double share = step_tolerance * std::max(1.0, after / usual_phase);
      check_swing(disk_over_crest(radius, mass, speed, run_up, rolls, time, defaults()), radius, share);
      const double azimuth = dice(0, 6);
      check_swing(sphere_over_crest(radius, mass, speed, run_up, rolls, azimuth, time, defaults()), radius,
                  share);
    }
}

TEST_CASE("the error of contacts that turn is of second order in the step") {
  const auto order = [](const auto& place) {
    const double coarse = place(fixed_steps(2e-3)), fine = place(fixed_steps(5e-4));
    return std::log(coarse / fine) / std::log(4);
  };
  CHECK(order([](const WorldSettings& s) { return in_drum(1, 0.2, 5, 1, true, 5, s).place; }) > 1.65);
  CHECK(order([](const WorldSettings& s) { return on_peg(1, 0.2, 5, 1, false, 5, s).place; }) > 1.65);
  CHECK(order([](const WorldSettings& s) { return in_tube(1, 0.2, 5, 1, false, 5, s).place; }) > 1.65);
  CHECK(order([](const WorldSettings& s) { return plank(0.3, 1, 0.1, 5, 0.2, 5, s).place; }) > 1.9);
  CHECK(order([](const WorldSettings& s) {
          return on_turntable(2, 0.1, 5, {0.5, 0}, {0.3, 0.4}, 5, s).place;
        }) > 1.9);
}

}  // namespace turning_normal_test
