// Pneumatic disks against their equation, integrated apart from the engine.

#include <catch2/catch.hpp>

#include "analytic/lab.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace pneumatic_test {

namespace {

constexpr double gravity = 9.81, air = 101325, r0 = 0.3, mass = 3, thickness = 0.2;

const Pneumatic soft{.pressure = air, .outside = air, .gamma = 1.4, .stiffness = 2e4, .radial_mass = {}};

Body<2> ball(const Pneumatic& filling, const Vec2& at, double spin = 0) {
  Body<2> body = make_body({Contactor2::disk(r0)}, 0, mass, thickness);
  make_pneumatic(body, filling);
  body.move_to(at, 0);
  body.w = spin;
  return body;
}

Body<2> ring(const Pneumatic& filling, const Vec2& at) {
  Body<2> body = make_body({Contactor2::hollow_disk(r0, 1.05 * r0)}, 0, mass, thickness);
  make_pneumatic(body, filling);
  body.move_to(at, 0);
  return body;
}

WorldSettings fixed_steps(double h) {
  WorldSettings settings;
  settings.time_step = h;
  return settings;
}

WorldSettings chosen_steps() {
  WorldSettings settings;
  settings.step_tolerance = 1e-3;
  return settings;
}

/// m_R R'' without contacts, written once more; `momentum` is J w.
double radial_force(const Pneumatic& p, double share, double r, double rate, double momentum) {
  const double inside = p.pressure * std::pow(r0 / r, 2 * p.gamma);
  return 2 * pi * r * thickness * (inside - p.outside) - p.stiffness * (r - r0) - p.damping * rate +
         momentum * momentum / (share * mass * r * r * r);
}

struct Motion {
  double y, v, r, rate;
};

/// One step of the classic Runge-Kutta scheme of (y, v, R, R'); `rates` are the derivatives.
template <class Rates>
Motion runge_kutta(const Motion& s, double h, const Rates& rates) {
  const auto ahead = [&](const Motion& d, double t) {
    return Motion{s.y + t * d.y, s.v + t * d.v, s.r + t * d.r, s.rate + t * d.rate};
  };
  const Motion a = rates(s), b = rates(ahead(a, h / 2)), c = rates(ahead(b, h / 2)), d = rates(ahead(c, h));
  const Motion mean{(a.y + 2 * b.y + 2 * c.y + d.y) / 6, (a.v + 2 * b.v + 2 * c.v + d.v) / 6,
                    (a.r + 2 * b.r + 2 * c.r + d.r) / 6, (a.rate + 2 * b.rate + 2 * c.rate + d.rate) / 6};
  return ahead(mean, h);
}

/// A ball above a floor that takes its approach (e_n = 0): in the air, an impact, and in contact until the
/// force of the floor is zero.
Motion fall_and_bounce(const Pneumatic& p, double height, double time, double momentum = 0) {
  constexpr double h = 1e-6, m_r = mass / 2;
  Motion s{height, 0, r0, 0};
  bool touches = false;
  const auto force = [&](const Motion& at) { return radial_force(p, 0.5, at.r, at.rate, momentum); };
  const auto in_air = [&](const Motion& at) { return Motion{at.v, -gravity, at.rate, force(at) / m_r}; };
  const auto on_floor = [&](const Motion& at) {
    const double a = (force(at) - mass * gravity) / (mass + m_r);
    return Motion{at.v, a, at.rate, a};
  };
  for (int i = 0; i < std::lround(time / h); ++i) {
    if (touches) {
      s = runge_kutta(s, h, on_floor);
      touches = on_floor(s).v + gravity > 0;
    } else {
      s = runge_kutta(s, h, in_air);
      if (s.y > s.r || s.v > s.rate) continue;
      s.v = s.rate = (mass * s.v + m_r * s.rate) / (mass + m_r);
      s.y = s.r;
      touches = true;
    }
  }
  return s;
}

/// The period of a small swing of R, from the times at which it passes the radius at rest upwards.
double period_of(World<2>& world, int body, double rest, int periods) {
  double first = 0, last = 0;
  for (int found = 0; found <= periods;) {
    const double before = world.bodies[body].breathing.now.radius - rest, start = world.time;
    world.step(world.step_length(), true);
    const double after = world.bodies[body].breathing.now.radius - rest;
    if (!(before < 0 && after >= 0)) continue;
    last = start + (world.time - start) * before / (before - after);
    if (found++ == 0) first = last;
  }
  return (last - first) / periods;
}

}  // namespace

TEST_CASE("a pneumatic disk breathes with 2 pi sqrt(m_R/(k + 4 pi gamma p_0 T)), at fixed and chosen steps") {
  const bool hollow = GENERATE(false, true), chosen = GENERATE(false, true);
  Material material(0, 0);
  Bench bench(ground(50), material, chosen ? chosen_steps() : fixed_steps(2e-5), Vec2::Zero());
  const int i = bench.add(hollow ? ring(soft, {0, 2}) : ball(soft, {0, 2}));
  Body<2>& body = bench.world.bodies[i];
  body.set_shape({r0 * (1 + 1e-5), 0});
  const double m_r = hollow ? mass : mass / 2;
  const double expected = 2 * pi * std::sqrt(m_r / (soft.stiffness + 4 * pi * soft.gamma * air * thickness));
  CHECK(period_of(bench.world, i, r0, 10) == Approx(expected).epsilon(chosen ? 5e-3 : 1e-5));
  CHECK(bench.world.quality().greatest_step <= expected / 20 * (1 + 1e-9));
}

TEST_CASE("a pneumatic disk at rest on the floor is pressed in until its force is its weight") {
  Pneumatic damped = soft;
  damped.damping = 500;
  Material material(0, 0.5);
  Bench bench(ground(50), material, chosen_steps());
  const int i = bench.add(ball(damped, {0, r0}));
  bench.run_settings.stop_speed = 0;
  bench.run(1);
  double low = 0.9 * r0, high = r0;  // bisection of the force on the radius
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (low + high);
    (radial_force(damped, 0.5, middle, 0, 0) > mass * gravity ? low : high) = middle;
  }
  CHECK(bench.world.bodies[i].breathing.now.radius == Approx(low).epsilon(1e-7));
  CHECK(bench.world.bodies[i].x.y() == Approx(low).epsilon(1e-7));
}

TEST_CASE("a pneumatic disk falls, is pressed in and jumps as its equation says") {
  const double spin = GENERATE(0.0, 60.0);
  const Pneumatic filling = soft;
  const double moment = 0.5 * mass * r0 * r0;
  const Motion expected = fall_and_bounce(filling, 0.5, 0.35, moment * spin);
  Material material(0, 0);
  const auto run = [&](const WorldSettings& settings) {
    Bench bench(ground(50), material, settings);
    const int i = bench.add(ball(filling, {0, 0.5}, spin));
    bench.run_settings.stop_speed = 0;
    bench.run(0.35);
    return bench.world.bodies[i];
  };
  const Body<2> fine = run(fixed_steps(1e-5));
  CAPTURE(expected.y, expected.v, fine.x.y(), fine.v.y());
  CHECK(fine.x.y() == Approx(expected.y).margin(2e-4));
  CHECK(fine.v.y() == Approx(expected.v).margin(5e-3));
  const Body<2> usual = run(chosen_steps());
  CAPTURE(usual.x.y(), usual.v.y());
  CHECK(usual.x.y() == Approx(expected.y).margin(5e-3));
}

TEST_CASE("a spinning pneumatic disk keeps J w while its radius moves, and its energy") {
  Material material(0, 0);
  Bench bench(ground(50), material, fixed_steps(1e-5), Vec2::Zero());
  const int i = bench.add(ball(soft, {0, 5}, 100));
  const double start = bench.world.total_energy();
  const double momentum = bench.world.bodies[i].inertia * 100;
  const auto rates = [&](const Motion& s) {
    return Motion{0, 0, s.rate, radial_force(soft, 0.5, s.r, s.rate, momentum) / (mass / 2)};
  };
  Motion s{0, 0, r0, 0};
  for (int k = 0; k < 20000; ++k) s = runge_kutta(s, 1e-6, rates);
  bench.run_settings.stop_speed = 0;
  bench.run(0.02);
  const Body<2>& body = bench.world.bodies[i];
  CHECK(body.breathing.now.radius == Approx(s.r).epsilon(1e-6));
  CHECK(body.inertia * body.w == Approx(momentum).epsilon(1e-13));
  CHECK(std::abs(bench.world.total_energy() - start) <= bench.world.energy_in_doubt());
  CHECK(bench.world.energy_in_doubt() < 2e-6 * start);  // (h omega)^2/4 of what the spin gives to the radius
}

TEST_CASE("a growing disk does not pass a thin plate or a corner between two steps") {
  // It grows at 200 m/s beside a wall of 1 mm: the touch is found within the step.
  Material material(0, 0);
  Bench bench(ground(50), material, fixed_steps(1e-3), Vec2::Zero());
  Body<2> plate = make_body({Contactor2::wall({0, -1}, {0, 1}, 0.5e-3)}, 1000, 0, 0.1);
  plate.kind = BodyKind::fixed;
  plate.move_to({1, 2}, 0);
  bench.add(plate);
  Body<2> growing = ball(soft, {0.6, 2});
  growing.breathing.now.rate = 200;
  const int i = bench.add(growing);
  bench.run(2e-3);
  CHECK(bench.world.bodies[i].x.x() + bench.world.bodies[i].breathing.now.radius < 1);
  CHECK(bench.world.quality().max_penetration < 1e-6);
}

TEST_CASE("a ring whose gas and spring are too soft collapses, and the fault says so") {
  Material material(0, 0.5);
  Pneumatic empty{.pressure = 0, .outside = air, .gamma = 0, .radial_mass = {}};
  Bench bench(ground(50), material, chosen_steps());
  const int i = bench.add(ball(empty, {0, 1}));
  bench.run(1);
  CHECK(bench.histories[i].reason == StopReason::diverged);
  CHECK(bench.histories[i].fault.find("radius") != std::string::npos);
}

TEST_CASE("a ring of gas that hangs on a peg is pushed out until its force is its weight") {
  Pneumatic damped = soft;
  damped.damping = 500;
  Material material(0, 0.5);
  Profile floor = ground(50);
  for (Vec2& point : floor.points) point.y() = -20;
  Bench bench(floor, material, chosen_steps());
  Body<2> peg = disk(0.1, 1, {0, 0});
  peg.kind = BodyKind::fixed;
  bench.add(peg);
  const int i = bench.add(ring(damped, {0, 0.1 - r0}));
  bench.run_settings.stop_speed = 0;
  bench.run(1);
  const Body<2>& body = bench.world.bodies[i];
  double low = r0, high = 1.1 * r0;
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (low + high);
    (radial_force(damped, 1, middle, 0, 0) + mass * gravity > 0 ? low : high) = middle;
  }
  CHECK(body.breathing.now.radius == Approx(low).epsilon(1e-7));
  CHECK(body.x.y() == Approx(0.1 - low).epsilon(1e-6));
}

TEST_CASE("two pneumatic disks that meet head-on move as each of them against a wall") {
  Material material(0, 0);
  const auto run = [&](bool wall) {
    Profile floor = ground(50);
    for (Vec2& point : floor.points) point.y() = -20;
    Bench bench(floor, material, fixed_steps(2e-5), Vec2::Zero());
    Body<2> left = ball(soft, {-0.4, 0});
    left.v = {6, 0};
    const int i = bench.add(left);
    if (wall) {
      Body<2> plate = box(1, 4, 1000, {0.5, 0}, 0);
      plate.kind = BodyKind::fixed;
      bench.add(plate);
    } else {
      Body<2> right = ball(soft, {0.4, 0});
      right.v = {-6, 0};
      bench.add(right);
    }
    bench.run_settings.stop_speed = 0;
    bench.run(0.06);
    if (!wall) {
      const Body<2>&a = bench.world.bodies[0], &b = bench.world.bodies[1];
      CHECK(std::abs(a.v.x() + b.v.x()) < 1e-10);
      CHECK(std::abs(a.x.x() + b.x.x()) < 1e-10);
      CHECK(std::abs(a.breathing.now.radius - b.breathing.now.radius) < 1e-10);
    }
    return bench.world.bodies[i];
  };
  const Body<2> at_wall = run(true), meeting = run(false);
  CHECK(at_wall.v.x() < -3);  // it jumped back
  CHECK(meeting.x.x() == Approx(at_wall.x.x()).margin(1e-8));
  CHECK(meeting.v.x() == Approx(at_wall.v.x()).margin(1e-7));
  CHECK(meeting.breathing.now.radius == Approx(at_wall.breathing.now.radius).margin(1e-9));
}

TEST_CASE("friction turns the spin of a pneumatic disk into speed while its radius swings") {
  constexpr double mu = 0.3, spin = -6, time = 0.05, m_r = mass / 2;
  // y: the momentum J w; v: along the floor. The floor gives N = m (g + R''), friction mu N at the arm R.
  const auto rates = [&](const Motion& s) {
    const double a = (radial_force(soft, 0.5, s.r, s.rate, s.y) - mass * gravity) / (mass + m_r);
    const double push = mu * mass * (gravity + a);
    return Motion{push * s.r, push / mass, s.rate, a};
  };
  Motion expected{0.5 * mass * r0 * r0 * spin, 0, r0, 0};
  for (int i = 0; i < std::lround(time / 1e-6); ++i) expected = runge_kutta(expected, 1e-6, rates);
  Material material(0, mu);
  const auto run = [&](const WorldSettings& settings) {
    Bench bench(ground(50), material, settings);
    const int i = bench.add(ball(soft, {0, r0}, spin));
    bench.run_settings.stop_speed = 0;
    bench.run(time);
    return bench.world.bodies[i];
  };
  const Body<2> fine = run(fixed_steps(1e-5)), usual = run(chosen_steps());
  CAPTURE(expected.y, expected.v, expected.r, expected.rate, fine.breathing.now.rate);
  CHECK(fine.v.x() == Approx(expected.v).epsilon(1e-4));
  CHECK(fine.inertia * fine.w == Approx(expected.y).epsilon(1e-4));
  CHECK(fine.breathing.now.radius == Approx(expected.r).epsilon(1e-5));
  CHECK(usual.v.x() == Approx(expected.v).epsilon(1e-2));
}

TEST_CASE("a pneumatic disk at 300 m/s that breathes passes neither a thin plate nor a corner") {
  Material material(0.5, 0.3);
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> random(-1, 1);
  int passed = 0;
  for (int k = 0; k < 60; ++k) {
    Profile floor = ground(50);
    for (Vec2& point : floor.points) point.y() = -20;
    Bench bench(floor, material, chosen_steps());
    Body<2> plate = k % 2 == 0 ? make_body({Contactor2::wall({0, -2}, {0, 2}, 0.5e-3)}, 1000, 0, 0.1)
                               : box(1, 1, 1000, {0, 0}, pi / 4);
    plate.kind = BodyKind::fixed;
    plate.move_to({k % 2 == 0 ? 2 : 2 + std::sqrt(0.5), 0}, k % 2 == 0 ? 0 : pi / 4);
    bench.add(plate);
    Body<2> shot = ball(soft, {0.2 * random(rng), 0.2 * random(rng)}, 200 * random(rng));
    shot.v = {300, 10 * random(rng)};
    shot.breathing.now.rate = 20 * random(rng);
    const int i = bench.add(shot);
    bench.run(0.02);
    const Body<2>& body = bench.world.bodies[i];
    passed += body.x.x() > 2 && std::abs(body.x.y()) < 1;
    CHECK(bench.histories[i].fault == "");
    CHECK(bench.world.quality().energy_gained <= 1e-6 * 0.5 * mass * 9e4);
  }
  CHECK(passed == 0);
}

}  // namespace pneumatic_test
