// Links against closed forms: pendulums, springs, ropes, and linked bodies that collide.
#include <catch2/catch.hpp>

#include "analytic/lab_3d.h"
#include "math/elliptic.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace links_test {

constexpr double gravity = 9.81;

WorldSettings steps_of(double h) {
  WorldSettings settings;
  settings.time_step = h;
  return settings;
}

template <int D>
Link<D> link_of(LinkType type, const World<D>& world, int a, int b, const Vec<D>& end_a,
                const Vec<D>& end_b) {
  const auto in_frame = [&](int i, const Vec<D>& place) -> Vec<D> {
    return i < 0 ? place : world.bodies[i].pose().r.inverse(Vec<D>(place - world.bodies[i].x));
  };
  Link<D> link;
  link.name = "link";
  link.type = type;
  link.a = a;
  link.b = b;
  link.end_a = in_frame(a, end_a);
  link.end_b = in_frame(b, end_b);
  if (type != LinkType::hinge) link.length = (end_a - end_b).norm();
  return link;
}

void add_hinge(World<2>& world, int a, int b, const Vec2& at) {
  Link<2> hinge = link_of<2>(LinkType::hinge, world, a, b, at, at);
  hinge.turned = world.bodies[a].attitude.angle - (b < 0 ? 0 : world.bodies[b].attitude.angle);
  world.links.add(hinge);
}

/// The greatest error of a length over all steps.
struct LengthWatch {
  double greatest = 0;
  void see(const World<2>& world) {
    for (const Link<2>& link : world.links.list())
      greatest = std::max(greatest, std::abs(world.links.length(link, world.bodies) - link.length));
  }
};

/// The time in which a pendulum with this rate of small swings comes down from rest at an angle.
double quarter(double angle, double rate) {
  const double sine = std::sin(angle / 2), cosine = std::cos(angle / 2);
  return first_kind({sine * sine, cosine * cosine}, 1, 0) / rate;
}

}  // namespace links_test

using namespace links_test;

TEST_CASE("a pendulum on a rod has the period of the elliptic integral") {
  const double length = 1.5, angle = 2.5;
  Material material(0, 0);
  Bench bench(ground(10), material, steps_of(1e-3));
  const Vec2 pivot(0, 4), start = pivot + length * Vec2(std::sin(angle), -std::cos(angle));
  const int bob = bench.add(disk(0.1, 2, start));
  bench.world.links.add(link_of<2>(LinkType::rod, bench.world, bob, -1, start, pivot));
  LengthWatch lengths;
  bench.run_settings.advanced = [&](double) { lengths.see(bench.world); };
  const double energy = bench.world.total_energy();
  bench.run(5 * quarter(angle, std::sqrt(gravity / length)));
  const Body<2>& body = bench.world.bodies[bob];
  CHECK(body.x.x() == Approx(0).margin(1e-4));
  CHECK(body.v.norm() == Approx(std::sqrt(2 * gravity * length * (1 - std::cos(angle)))).epsilon(1e-8));
  CHECK(bench.world.total_energy() == Approx(energy).epsilon(1e-11));
  CHECK(lengths.greatest < 1e-11);
  CHECK(body.w == 0);
}

TEST_CASE("a bar on a hinge swings as a physical pendulum") {
  const double width = 1, height = 0.2, angle = 1.2, mass = 3;
  Material material(0, 0);
  Bench bench(ground(10), material, steps_of(1e-3));
  const Vec2 pivot(0, 4);
  Body<2> bar = box(width, height, mass, {0, 0});
  const Vec2 lever(-width / 2, 0);  // of the hinge, in the frame of the bar
  const double attitude = angle - pi / 2;
  bar.move_to(pivot - Rotation2::from_angle(attitude) * lever, attitude);
  const int i = bench.add(bar);
  add_hinge(bench.world, i, -1, pivot);
  const double about_pivot = mass * (width * width + height * height) / 12 + mass * width * width / 4;
  const double rate = std::sqrt(mass * gravity * width / 2 / about_pivot);
  const double energy = bench.world.total_energy();
  bench.run(3 * quarter(angle, rate));
  const Body<2>& body = bench.world.bodies[i];
  CHECK(body.attitude.angle == Approx(-pi / 2).margin(1e-5));
  CHECK(bench.world.links.angle(bench.world.links.list()[0], bench.world.bodies) ==
        Approx(-angle).margin(1e-5));
  CHECK(bench.world.total_energy() == Approx(energy).epsilon(1e-10));
  CHECK((bench.world.links.ends(bench.world.links.list()[0], bench.world.bodies)[0] - pivot).norm() < 1e-10);
}

TEST_CASE("a double pendulum keeps its energy to 1e-6 in 10 s") {
  for (const double h : {1e-3, 4e-3}) {
    Material material(0, 0);
    Bench bench(ground(10), material, steps_of(h));
    const Vec2 pivot(0, 5);
    const int upper = bench.add(box(1, 0.1, 2, {0.5, 5})), lower = bench.add(box(1, 0.1, 2, {1.5, 5}));
    add_hinge(bench.world, upper, -1, pivot);
    add_hinge(bench.world, lower, upper, {1, 5});
    LengthWatch lengths;
    bench.run_settings.advanced = [&](double) { lengths.see(bench.world); };
    const double energy = bench.world.total_energy(), scale = 4 * gravity;
    bench.run(10);
    CHECK(bench.world.bodies[lower].v.norm() > 0.01);
    CHECK(std::abs(bench.world.total_energy() - energy) < 1e-6 * scale);
    CHECK(lengths.greatest < 1e-9);
    CAPTURE(h, bench.world.total_energy() - energy, lengths.greatest);
    CHECK(bench.histories[lower].reason == StopReason::timed_out);
  }
}

TEST_CASE("a mass on a spring swings about its rest as a damped oscillator") {
  const double mass = 2, stiffness = 200, damping = GENERATE(0.0, 4.0);
  Material material(0, 0);
  Bench bench(ground(10), material, steps_of(1e-3));
  const Vec2 hook(0, 5), start(0, 4);
  const int i = bench.add(disk(0.1, mass, start));
  Link<2> spring = link_of<2>(LinkType::spring, bench.world, i, -1, start, hook);
  spring.stiffness = stiffness;
  spring.damping = damping;
  bench.world.links.add(spring);
  const double energy = bench.world.total_energy(), time = 3.3;
  bench.run(time);
  const double sag = mass * gravity / stiffness, decay = damping / mass / 2;
  const double rate = std::sqrt(stiffness / mass - decay * decay);
  const double swing =
      std::exp(-decay * time) * (std::cos(rate * time) + decay / rate * std::sin(rate * time));
  CHECK(bench.world.bodies[i].x.y() == Approx(start.y() - sag * (1 - swing)).margin(2e-5));
  if (damping == 0) CHECK(bench.world.total_energy() == Approx(energy).epsilon(1e-11));
  if (damping > 0) CHECK(bench.world.total_energy() < energy);
}

TEST_CASE("a rope does nothing while it is slack, and stops what pulls it taut") {
  const double length = 1;
  Material material(0, 0);
  Bench bench(ground(10), material, steps_of(1e-3));
  const Vec2 hook(0, 5), start(0, 4.8);
  const int i = bench.add(disk(0.05, 2, start, {0.5, 0}));
  Link<2> rope = link_of<2>(LinkType::rope, bench.world, i, -1, start, hook);
  rope.length = length;
  bench.world.links.add(rope);
  bench.run(0.3);
  CHECK((bench.world.bodies[i].x - Vec2(0.15, 4.8 - 0.5 * gravity * 0.09)).norm() < 1e-12);
  CHECK(bench.world.links.list()[0].tension == 0);

  // It becomes taut at a place of its parabola, and keeps what is across it.
  double taut = 0.3;
  const auto place = [&](double t) { return Vec2(0.5 * t, 4.8 - 0.5 * gravity * t * t); };
  for (double step = 0.1; step > 1e-13; step /= 2)
    while ((place(taut + step) - hook).norm() < length) taut += step;
  const Vec2 along = (place(taut) - hook).normalized(), v(0.5, -gravity * taut);
  const Vec2 across = v - along.dot(v) * along;
  const double energy = 2 * (0.5 * across.squaredNorm() + gravity * place(taut).y());
  bench.run(2);
  CHECK((bench.world.bodies[i].x - hook).norm() <= length * (1 + 1e-12));
  CHECK(bench.world.total_energy() == Approx(energy).epsilon(2e-4));
}

TEST_CASE("a rope goes slack where its tension is 0, and its weight flies on a parabola") {
  // v0^2 = gravity L (2 + 3 c): slack where the weight is c L above the hook, with v^2 = gravity L c.
  const double length = 1, c = 0.5, v0 = std::sqrt(gravity * length * (2 + 3 * c));
  Material material(0, 0);
  Bench bench(ground(10), material, steps_of(2e-4));
  const Vec2 hook(0, 5), start(0, 4);
  const int i = bench.add(disk(0.05, 2, start, {v0, 0}));
  bench.world.links.add(link_of<2>(LinkType::rope, bench.world, i, -1, start, hook));
  double slack = 0;
  const auto height = [&](double) {
    if (slack == 0 && bench.world.links.list()[0].tension == 0)
      slack = bench.world.bodies[i].x.y() - hook.y();
  };
  bench.run_settings.advanced = height;
  bench.run(0.75);
  CHECK(slack == Approx(c * length).margin(2e-3));
  const double top = c * length + gravity * length * c * (1 - c * c) / (2 * gravity);
  CHECK(bench.histories[i].max.position.y() == Approx(hook.y() + top).margin(1e-3));
}

TEST_CASE("a bar struck at its centre of percussion does not push its hinge") {
  const double length = 1.2, width = 0.02, mass = 3;
  const double about_pivot = mass * (length * length + width * width) / 12 + mass * length * length / 4;
  const double percussion = about_pivot / (mass * length / 2);
  for (const double e : {0.0, 0.6, 1.0}) {
    Material material(e, 0);
    Bench bench(ground(10), material, steps_of(1e-3), {0, 0});
    const Vec2 pivot(0, 5);
    Body<2> bar = box(width, length, mass, {0, 5 - length / 2});
    bar.w = 2;
    bar.v = {2 * length / 2, 0};
    const int i = bench.add(bar);
    add_hinge(bench.world, i, -1, pivot);
    Body<2> ball = disk(0.1, 1, {width / 2 + 0.1, 5 - percussion});
    ball.kind = BodyKind::fixed;
    bench.add(ball);
    double push = -1;
    bench.run_settings.advanced = [&](double step) {
      if (step == 0 && !bench.world.impacts().empty()) push = bench.world.links.list()[0].impulse.norm();
    };
    bench.run(0.01);
    CHECK(push == Approx(0).margin(1e-3 * mass));
    CHECK(bench.world.bodies[i].w == Approx(-2 * e).margin(1e-6));
  }
}

TEST_CASE("links keep their lengths to 1e-6 in a pile") {
  Material material(0.2, 0.5);
  WorldSettings settings;
  settings.step_tolerance = 1e-3;
  Bench bench(ground(5), material, settings);
  for (int row = 0; row < 4; ++row)
    for (int k = 0; k < 4; ++k) bench.add(disk(0.1, 1, {0.25 * k + 0.05 * row, 0.2 + 0.25 * row}));
  const auto& bodies = bench.world.bodies;
  for (const auto& [a, b] : {std::pair(0, 1), {1, 2}, {4, 9}, {8, 13}})
    bench.world.links.add(link_of<2>(LinkType::rod, bench.world, a, b, bodies[a].x, bodies[b].x));
  LengthWatch lengths;
  bench.run_settings.advanced = [&](double) { lengths.see(bench.world); };
  bench.run(1.5);
  CHECK(lengths.greatest < 1e-6);
  CHECK(bench.world.quality().max_penetration < 1e-4);
  for (const BodyHistory& history : bench.histories) CHECK(history.fault.empty());
}

TEST_CASE("a chain of three links held at both ends hangs as its funicular polygon") {
  Material material(0, 0);
  Bench bench(ground(10), material, steps_of(2e-3));
  // Two equal weights at x = -0.5 and 0.5 below hooks at x = -1 and 1: their tensions follow from the slopes.
  const double drop = 0.5;
  const Vec2 left(-1, 5), right(1, 5), a(-0.5, 5 - drop), b(0.5, 5 - drop);
  const int i = bench.add(disk(0.05, 2, a)), j = bench.add(disk(0.05, 2, b));
  bench.world.links.add(link_of<2>(LinkType::rope, bench.world, i, -1, a, left));
  bench.world.links.add(link_of<2>(LinkType::rope, bench.world, i, j, a, b));
  bench.world.links.add(link_of<2>(LinkType::rope, bench.world, j, -1, b, right));
  bench.run(0.1);
  const double h = bench.world.last_step(), slant = std::sqrt(drop * drop + 0.25);
  const auto& links = bench.world.links.list();
  CHECK(links[0].tension / h == Approx(2 * gravity * slant / drop).epsilon(1e-9));
  CHECK(links[1].tension / h == Approx(2 * gravity * 0.5 / drop).epsilon(1e-9));
  CHECK(links[2].tension / h == Approx(2 * gravity * slant / drop).epsilon(1e-9));
}

TEST_CASE("a hinge in 3D keeps its axis, and a bar on it swings as in 2D") {
  const double width = 1, height = 0.2, depth = 0.4, angle = 1.2, mass = 3;
  Material material(0, 0);
  Bench3 bench(plane(), material, steps_of(1e-3));
  // About an axis that lies level, 30 deg from y; the bar hangs at its end.
  const Vec3 pivot(0.3, 0.2, 4), axis(0.5, std::cos(pi / 6), 0), out(axis.y(), -axis.x(), 0);
  const Vec3 along = std::sin(angle) * out - std::cos(angle) * Vec3::UnitZ();
  const int i =
      bench.add(box({width, depth, height}, mass, pivot + width / 2 * along, along, axis.cross(along)));
  World<3>& world = bench.world;
  Link<3> hinge = link_of<3>(LinkType::hinge, world, i, -1, pivot, pivot);
  const Eigen::Matrix3d frame = contact_frame(axis);
  hinge.axis = world.bodies[i].pose().r.inverse(axis);
  hinge.side = world.bodies[i].pose().r.inverse(frame.col(1));
  for (int k = 0; k < 3; ++k) hinge.frame_b[k] = frame.col(k);
  world.links.add(hinge);
  const double about_pivot = mass * (width * width + height * height) / 12 + mass * width * width / 4;
  const double energy = world.total_energy();
  bench.run(3 * quarter(angle, std::sqrt(mass * gravity * width / 2 / about_pivot)));
  const auto& link = world.links.list()[0];
  CHECK((world.bodies[i].x - pivot).normalized().dot(Vec3::UnitZ()) == Approx(-1).epsilon(1e-9));
  CHECK(std::abs(world.links.angle(link, world.bodies)) == Approx(angle).margin(1e-5));
  CHECK(world.links.length(link, world.bodies) < 1e-10);
  CHECK((world.bodies[i].pose().r * hinge.axis - axis).norm() < 1e-10);
  CHECK(world.total_energy() == Approx(energy).epsilon(1e-8));
}

TEST_CASE("bars on two hinges of one axis hold what one of them holds already") {
  Material material(0, 0);
  Bench3 bench(plane(), material, steps_of(1e-3));
  World<3>& world = bench.world;
  const int i = bench.add(box({1, 0.6, 0.1}, 3, {0.5, 0, 4}));
  for (const double y : {-0.3, 0.3}) {
    const Vec3 at(0, y, 4);
    Link<3> hinge = link_of<3>(LinkType::hinge, world, i, -1, at, at);
    const Eigen::Matrix3d frame = contact_frame(Vec3::UnitY().eval());
    hinge.axis = world.bodies[i].pose().r.inverse(Vec3::UnitY());
    hinge.side = world.bodies[i].pose().r.inverse(frame.col(1));
    for (int k = 0; k < 3; ++k) hinge.frame_b[k] = frame.col(k);
    world.links.add(hinge);
  }
  const double about_axis = 3 * (1 + 0.01) / 12 + 3 * 0.25;
  bench.run(quarter(pi / 2, std::sqrt(3 * gravity * 0.5 / about_axis)));
  const Body<3>& body = world.bodies[i];
  CHECK((body.x - Vec3(0, 0, 3.5)).norm() < 1e-5);
  CHECK(std::abs(body.w.y()) == Approx(std::sqrt(2 * 3 * gravity * 0.5 / about_axis)).epsilon(1e-5));
}
