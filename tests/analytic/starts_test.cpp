// How bodies start: settled, held until a time, under a force.

#include <catch2/catch.hpp>

#include "flight/settle.h"
#include "lab.h"

using namespace flyrock;
using namespace flyrock::lab;

TEST_CASE("A disk that would bounce settles without a bounce, and starts at rest at time 0") {
  Material rock(0.9, 0.5);
  Bench bench(ground(50), rock);
  bench.add(disk(0.5, 100, {0, 0.7}));
  settle<2>(bench.world, {.until = 0.01, .at_most = 10});
  CHECK(bench.world.time == 0);
  CHECK_FALSE(bench.world.settling);
  CHECK(bench.world.bodies[0].x.y() == Approx(0.5).margin(1e-6));
  CHECK(bench.world.bodies[0].v.norm() < 0.01);
  CHECK(bench.world.bodies[0].impacts == 0);
  const BodyHistory& history = bench.run(5);
  CHECK(history.reason == StopReason::stopped);
  CHECK(history.stop_time == Approx(0).margin(1e-9));
  CHECK(history.impact_count == 0);
}

TEST_CASE("Settling ends when all bodies are at rest, not when its time is up") {
  Material rock(0.8, 0.3);
  Bench bench(ground(50), rock);
  bench.add(box(0.4, 0.2, 40, {0, 0.13}));
  bench.add(box(0.4, 0.2, 40, {0, 0.38}));
  Body<2> waiting = disk(0.5, 100, {-5, 3});
  waiting.hold.emplace();
  bench.add(std::move(waiting));
  settle<2>(bench.world, {.until = 0.01, .at_most = 1e4});
  CHECK(bench.world.quality().step_time < 2);  // s, of all steps
  CHECK(bench.world.bodies[0].x.y() == Approx(0.1).margin(1e-6));
  CHECK(bench.world.bodies[1].x.y() == Approx(0.3).margin(1e-6));
  CHECK(bench.world.bodies[2].x.y() == 3);
}

TEST_CASE("Bodies that settle for too short a time go on from where they are at time 0") {
  Material rock(0.9, 0.5);
  Bench bench(ground(50), rock);
  bench.add(disk(0.5, 100, {0, 10}));
  settle<2>(bench.world, {.until = 0.01, .at_most = 0.5});
  CHECK(bench.world.time == 0);
  CHECK(bench.world.bodies[0].x.y() == Approx(10 - 0.5 * 9.81 * 0.25));
  CHECK(bench.world.bodies[0].v.y() == Approx(-9.81 * 0.5));
}

TEST_CASE("A driven body and one that is held until time 0 stand while the others settle") {
  Material rock(0.5, 0.5);
  Bench bench(ground(50), rock);
  bench.add(disk(0.5, 100, {0, 0.6}));
  Body<2> wall = box(1, 1, 0, {5, 3});
  wall.kind = BodyKind::driven;
  wall.v = {1, 0};
  wall.push = {0.5, 0};
  bench.add(std::move(wall));
  Body<2> striker = disk(0.5, 100, {-5, 3});
  striker.hold = {.until = 0, .v = {2, 1}, .w = 3};
  bench.add(std::move(striker));
  settle<2>(bench.world, {.until = 0.01, .at_most = 3});
  const auto& bodies = bench.world.bodies;
  CHECK(bodies[1].x == Vec2(5, 3));
  CHECK(bodies[1].v == Vec2(1, 0));
  CHECK(bodies[1].push == Vec2(0.5, 0));
  CHECK(bodies[2].x == Vec2(-5, 3));
  bench.run(0.2);
  CHECK(bodies[1].x.x() == Approx(5 + 0.2 + 0.25 * 0.04));
  CHECK(bodies[2].x.x() == Approx(-5 + 0.4));
  CHECK(bodies[2].x.y() == Approx(3 + 0.2 - 0.5 * 9.81 * 0.04));
  CHECK(bodies[2].w == Approx(3));
}

TEST_CASE("A body in the air is held until its time, and then flies its parabola") {
  Material rock(0.5, 0.5);
  Bench bench(ground(50), rock);
  Body<2> body = disk(0.5, 100, {0, 8});
  body.hold = {.until = 0.5, .v = {3, 2}, .w = 1};
  bench.add(std::move(body));
  const BodyHistory& history = bench.run(1);
  CHECK(history.reason == StopReason::timed_out);
  CHECK(history.last.position.x() == Approx(1.5));
  CHECK(history.last.position.y() == Approx(8 + 1 - 0.5 * 9.81 * 0.25));
  CHECK(bench.world.bodies[0].attitude.angle == Approx(0.5));
  CHECK(std::abs(bench.world.quality().energy_relative_change) < 1e-12);
}

TEST_CASE("A box that is held on a smooth slope slides from its time on") {
  const double slope = pi / 6;
  Material ice(0, 0);
  Bench bench(ground(50, slope), ice);
  const Vec2 normal(std::sin(slope), std::cos(slope)), along(std::cos(slope), -std::sin(slope));
  Body<2> body = box(1, 1, 2700, 0.5 * normal, -slope);
  body.hold.emplace().until = 0.5;
  bench.add(std::move(body));
  const BodyHistory& history = bench.run(1.5);
  CHECK(along.dot(history.last.position.head<2>()) == Approx(0.5 * 9.81 * std::sin(slope)).epsilon(1e-6));
  CHECK(normal.dot(history.last.position.head<2>()) == Approx(0.5).margin(1e-6));
}

TEST_CASE("A held body carries another one until it is let go") {
  Material rock(0, 0.5);
  Bench bench(ground(50), rock);
  Body<2> shelf = box(4, 1, 2700, {0, 6});
  shelf.hold.emplace().until = 1;
  bench.add(std::move(shelf));
  bench.add(box(1, 1, 2700, {0, 7}));
  bench.run(1.5);
  const double fall = 0.5 * 9.81 * 0.25;
  CHECK(bench.world.bodies[0].x.y() == Approx(6 - fall).epsilon(1e-6));
  CHECK(bench.world.bodies[1].x.y() == Approx(7 - fall).epsilon(1e-6));
}

TEST_CASE("A force bends the parabola of a body, and its work is in the balance of energy") {
  Material rock(0.5, 0.5);
  Bench bench(ground(50), rock);
  Body<2> body = disk(0.5, 100, {0, 8});
  body.load = body.push = Vec2(300, 400) / 100;
  bench.add(std::move(body));
  const double start = bench.world.total_energy();
  const BodyHistory& history = bench.run(1);
  CHECK(history.reason == StopReason::timed_out);
  CHECK(history.last.position.x() == Approx(1.5));
  CHECK(history.last.position.y() == Approx(8 - 0.5 * 5.81));
  CHECK(bench.world.energy_given() == Approx(300 * 1.5 - 400 * 0.5 * 5.81));
  CHECK(bench.world.total_energy() == Approx(start + bench.world.energy_given()));
}

TEST_CASE("A force moves a box on rough ground with F/m - mu g, in exact and in dense steps") {
  for (const ManyBodies many : {ManyBodies::exact, ManyBodies::dense}) {
    Material rock(0, 0.3);
    Bench bench(ground(50), rock, {.many = many});
    Body<2> body = box(1, 0.5, 100, {0, 0.25});
    body.load = body.push = Vec2(600, 0) / 100;
    bench.add(std::move(body));
    bench.add(box(1, 0.5, 100, {-20, 0.25}));  // the force of the other one does not move it
    bench.run(2);
    const double accuracy = many == ManyBodies::exact ? 1e-5 : 3e-3;
    CHECK(bench.world.bodies[0].x.x() == Approx(0.5 * (6 - 0.3 * 9.81) * 4).epsilon(accuracy));
    CHECK(bench.world.bodies[1].x.x() == Approx(-20).margin(1e-9));
  }
}

TEST_CASE("A force below the friction limit does not move a box") {
  Material rock(0, 0.3);
  Bench bench(ground(50), rock);
  Body<2> body = box(1, 0.5, 100, {0, 0.25});
  body.load = body.push = Vec2(294, 0) / 100;
  bench.add(std::move(body));
  const BodyHistory& history = bench.run(5);
  CHECK(history.reason == StopReason::stopped);
  CHECK(history.last.position.x() == Approx(0).margin(1e-6));
}
