// A driven body closes on a free one: pressed against something that does not give way, it ends as diverged;
// pushed, lifted, carried, wedged or held, it goes on.

#include <catch2/catch.hpp>

#include "analytic/lab_3d.h"
#include "dice.h"
#include "samples.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace pressed_test {

namespace {

Body<2> driven(Body<2> body, const Vec2& velocity) {
  body.kind = BodyKind::driven;
  body.v = velocity;
  return body;
}
Body<3> driven(Body<3> body, const Vec3& velocity) {
  body.kind = BodyKind::driven;
  body.v = velocity;
  return body;
}

Body<2> rounded_box(double side, double rounding) {
  const double half = side / 2 - rounding;
  return make_body({Contactor2::hull({{-half, -half}, {half, -half}, {half, half}, {-half, half}}, rounding)},
                   0, 400, 0);
}

/// Four disks a row between two walls, below a plate that is driven down: the plate closes the last gap.
void add_box_of_disks(Bench& bench, double speed, double radius, double shift) {
  for (const double side : {-1.0, 1.0}) {
    Body<2> wall = box(0.1, 2.4, 1, {1.1 * side, 1.2});
    wall.kind = BodyKind::fixed;
    bench.add(std::move(wall));
  }
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) {
      const Vec2 at(-0.75 + shift * row + 0.5 * column, 0.25 + 0.5 * row);
      Body<2> rock = disk(radius, 2700 * pi * radius * radius, at);
      rock.group = "rock";
      bench.add(std::move(rock));
    }
  bench.add(driven(box(1.9, 0.2, 1, {0, 2.2}), {0, -speed}));
}

bool ends_as_pressed(const BodyHistory& history) {
  return history.reason == StopReason::diverged &&
         history.fault.find("presses `rock`") != std::string::npos &&
         history.fault.find("leaves no way out") != std::string::npos;
}

}  // namespace

TEST_CASE("in 2D a body between a driven plate and the ground ends as diverged, wherever the plate is") {
  struct Shape {
    Contactor2 contactor;
    double half_height;
  };
  const Shape shapes[] = {{Contactor2::disk(0.5), 0.5},
                          {Contactor2::polygon({{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}), 0.5},
                          {rounded_box(1, 0.2).contactors[0], 0.5},
                          {Contactor2::wall({-0.5, 0}, {0.5, 0}, 0.2), 0.2}};
  for (const Shape& shape : shapes)
    for (const double aside : {0.0, 1e-9, 1e-6, 1e-3, 0.13})
      for (const double speed : {0.02, 1.0, 20.0})
        for (const double mu : {0.0, 0.5})
          for (const double slope : {0.0, 0.1}) {  // of the ground and the plate
            CAPTURE(shape.contactor.points.size(), shape.contactor.radius, aside, speed, mu, slope);
            const Vec2 normal(std::sin(slope), std::cos(slope)), along(std::cos(slope), -std::sin(slope));
            Material material(mu > 0 ? 0.3 : 0, mu);
            Bench bench(ground(20, slope), material, {}, -9.81 * normal);
            Body<2> rock = make_body({shape.contactor}, 0, 1000, 0);
            rock.group = "rock";
            rock.move_to((shape.half_height + 1e-3) * normal, -slope);
            bench.add(std::move(rock));
            const double away = std::min(0.1, 0.2 * speed);
            const Body<2> plate =
                box(6, 1, 1, (2 * shape.half_height + 0.5 + away) * normal + aside * along, -slope);
            bench.add(driven(plate, -speed * normal + (mu > 0 ? 0.2 * speed : 0) * along));
            const BodyHistory& history = bench.run(3 * away / speed + 0.1);
            CHECK(ends_as_pressed(history));
            CHECK(bench.world.quality().problems < 3000);
          }
}

TEST_CASE("in 3D a body between a driven plate and the ground ends as diverged") {
  struct Shape {
    Contactor3 contactor;
    double half_height;
  };
  const Shape shapes[] = {{Contactor3::sphere(0.3), 0.3},
                          {Contactor3::box({0.5, 0.6, 0.4}), 0.2},
                          {Contactor3::cylinder(0.3, 1), 0.5},
                          {Contactor3::pill({-0.3, 0, 0}, {0.3, 0, 0}, 0.2), 0.2}};
  for (const Shape& shape : shapes)
    for (const double aside : {0.0, 1e-9, 1e-6, 1e-3})
      for (const double speed : {0.02, 1.0}) {
        CAPTURE(shape.half_height, aside, speed);
        Material material(0.3, 0.5);
        Bench3 bench(Plane{}, material);
        Body<3> rock = make_body({shape.contactor}, 0, 1000);
        rock.group = "rock";
        rock.x = {0, 0, shape.half_height + 1e-3};
        bench.add(std::move(rock));
        const double away = std::min(0.1, 0.2 * speed);
        bench.add(driven(box(Vec3(4, 4, 1), 1, {aside, 0, 2 * shape.half_height + 0.5 + away}),
                         {0.2 * speed, 0, -speed}));
        CHECK(ends_as_pressed(bench.run(3 * away / speed + 0.1)));
      }
}

TEST_CASE("a plate that is driven into a box of disks ends at the jam, and throws none of them") {
  for (const double mu : {0.0, 0.3, 0.7})
    for (const double shift : {0.02, 0.0})
      for (const double time_step : {0.002, 0.0}) {  // 0: chosen steps
        CAPTURE(mu, shift, time_step);
        Material material(0, mu);
        WorldSettings settings;
        if (time_step > 0)
          settings.time_step = time_step;
        else
          settings.step_tolerance = 1e-3;
        Bench bench(ground(50), material, settings);
        bench.run_settings.stop_speed = 0;
        add_box_of_disks(bench, 0.2, 0.245, shift);
        bench.run(6);
        const BodyHistory& rock = bench.histories[2];
        INFO(rock.fault);
        CHECK(ends_as_pressed(rock));
        CHECK(bench.world.quality().max_penetration < 2e-3);
        for (const BodyHistory& history : bench.histories) CHECK(history.max_speed < 3);
      }
}

TEST_CASE("a box of frictionless disks jams where chosen steps have left them, and throws none") {
  constexpr double most_ratio = 200;  // a way out that asks for more is narrower than places are known
  Dice dice(3);
  Material material(0, 0);
  for (int n = 0; n < samples(12); ++n) {
    const double speed = dice(0.1, 0.4), radius = dice(0.24, 0.248), shift = dice(0.005, 0.03);
    CAPTURE(speed, radius, shift);
    WorldSettings settings;
    settings.step_tolerance = 1e-3;
    Bench bench(ground(50), material, settings);
    bench.run_settings.stop_speed = 0;
    add_box_of_disks(bench, speed, radius, shift);
    bench.run(1.2 / speed);
    CHECK(ends_as_pressed(bench.histories[2]));
    for (const BodyHistory& history : bench.histories) CHECK(history.max_speed < most_ratio * speed);
  }
}

TEST_CASE("a disk that frictionless plates squeeze out at a small angle is not taken for pressed") {
  for (const double angle : {0.02, 0.1}) {
    Material material(0, 0);
    WorldSettings settings;
    settings.step_tolerance = 1e-3;
    Bench bench(ground(50), material, settings);
    bench.run_settings.stop_speed = 0;
    bench.add(disk(0.5, 1000, {0, 0.5}));
    Body<2> plate = box(6, 0.2, 1, Vec2(0, 0.5) + 0.602 * Vec2(-std::sin(angle), std::cos(angle)), angle);
    bench.add(driven(std::move(plate), {0, -0.02}));
    const BodyHistory& history = bench.run(0.5);
    INFO(history.fault);
    CHECK(history.reason != StopReason::diverged);
    CHECK(history.max_speed > 0.5 * 0.02 / angle);
  }
}

TEST_CASE("a body that can leave a driven one is not taken for pressed") {
  Material material(0.3, 0.5);
  Bench bench(ground(50), material);
  bench.run_settings.stop_speed = 0;
  SECTION("a stack on a plate that is driven up") {
    bench.add(driven(box(4, 0.2, 1, {0, 0.1}), {0, 0.5}));
    for (const double y : {0.7, 1.7, 2.7}) bench.add(box(1, 1, 1000, {0, y}));
  }
  SECTION("a stack that a driven wall pushes along") {
    for (const double y : {0.5, 1.5}) bench.add(box(1, 1, 1000, {0, y}));
    bench.add(driven(box(1, 4, 1, {-1.01, 2.5}), {1, 0}));
  }
  SECTION("a row of disks that a driven wall pushes") {
    for (const double x : {0.0, 1.0, 2.0, 3.0}) bench.add(disk(0.5, 1000, {x, 0.5}));
    bench.add(driven(box(1, 4, 1, {-1.01, 2.5}), {2, 0}));
  }
  SECTION("a disk that a driven wedge lifts, against a fixed wall") {
    Body<2> wall = box(1, 6, 1, {1.0, 3});
    wall.kind = BodyKind::fixed;
    bench.add(disk(0.5, 1000, {0, 0.5}));
    bench.add(std::move(wall));
    Body<2> wedge = make_body({Contactor2::polygon({{-3, 0}, {0, 0}, {-3, 2}})}, 0, 1, 0);
    wedge.move_to(wedge.x + Vec2(-1.2, 0.01), 0);
    bench.add(driven(std::move(wedge), {0.2, 0}));
  }
  SECTION("a box that two driven plates hold and carry") {
    bench.add(box(1, 1, 1000, {0, 1.5}));
    bench.add(driven(box(1, 2, 1, {-1, 1.5}), {0.3, 0.4}));
    bench.add(driven(box(1, 2, 1, {1, 1.5}), {0.3, 0.4}));
  }
  SECTION("a disk that a tilted plate squeezes out") {
    bench.add(disk(0.5, 1000, {0, 0.5}));
    bench.add(driven(box(6, 0.2, 1, {0, 1.25}, 0.9), {0, -0.2}));
  }
  SECTION("a heap in a driven tray that shakes") {
    bench.add(driven(box(4, 0.2, 1, {0, 0.3}), {0.5, 0.2}));
    for (int i = 0; i < 12; ++i)
      bench.add(disk(0.2, 100, {-0.9 + 0.45 * (i % 4) + 0.05 * (i / 4), 0.61 + 0.42 * (i / 4)}));
  }
  bench.run(1);
  for (const BodyHistory& history : bench.histories) {
    INFO(history.fault);
    CHECK(history.reason != StopReason::diverged);
  }
}

TEST_CASE("a drum that turns presses nothing, also where solves fail") {
  Material material(0, 0.5);
  WorldSettings settings;
  settings.tolerance = 1e-13;  // which two iterations do not reach
  settings.max_iterations = 2;
  Bench bench(ground(50), material, settings);
  Body<2> drum = make_body({Contactor2::hollow_disk(1, 1.05)}, 1000, 0, 1);
  drum.move_to({0, 1.5}, 0);
  drum.w = 0.5;
  bench.add(driven(std::move(drum), {0, 0}));
  for (int i = 0; i < 20; ++i)
    bench.add(box(0.15, 0.15, 60, {-0.4 + 0.2 * (i % 5), 0.9 + 0.2 * (i / 5)}, 0.1 * i));
  bench.run(0.3);
  CHECK(bench.world.quality().not_converged > 100);
  for (const BodyHistory& history : bench.histories) {
    INFO(history.fault);
    CHECK(history.reason != StopReason::diverged);
  }
}

}  // namespace pressed_test
