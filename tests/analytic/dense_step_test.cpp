// Dense steps (world/dense_step.cpp): bounces, slides and flights beside closed forms; piles that come to
// rest.

#include <catch2/catch.hpp>
#include <random>

#include "analytic/lab.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace dense_step_test {

WorldSettings dense() {
  WorldSettings settings;
  settings.step_tolerance = 1e-3;
  settings.many = ManyBodies::dense;
  return settings;
}

WorldSettings automatic() {
  WorldSettings settings = dense();
  settings.many = ManyBodies::automatic;
  return settings;
}

/// A polygon of 5 to 9 corners on a circle that varies.
Body<2> lump(std::mt19937& dice, const Vec2& at) {
  std::uniform_real_distribution<double> part(0, 1);
  const double radius = 0.3 + 0.2 * part(dice), turn = part(dice);
  const int corners = 5 + static_cast<int>(5 * part(dice));
  std::vector<Vec2> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * (i + turn + 0.3 * (part(dice) - 0.5)) / corners;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  Body<2> body = make_body({Contactor2::polygon(points)}, 2700, 0, 1);
  body.move_to(at, 0);
  return body;
}

/// A pit with a level floor and steep sides.
Profile pit(double half_width) {
  Profile profile;
  profile.points = {{-half_width - 30, 30}, {-half_width - 1, 30}, {-half_width, 0},
                    {half_width, 0},        {half_width + 1, 30},  {half_width + 30, 30}};
  profile.part.assign(5, 0);
  profile.parts = {""};
  return profile;
}

/// The overlap of two convex polygons by the axis of least overlap among the normals of both [m].
double overlap(const Body<2>& a, const Body<2>& b) {
  double least = 1e300;
  const auto corners = [](const Body<2>& body) {
    std::vector<Vec2> points;
    for (const Vec2& p : body.contactors[0].points) points.push_back(body.pose() * p);
    return points;
  };
  const auto of_a = corners(a), of_b = corners(b);
  for (const auto* of : {&of_a, &of_b})
    for (std::size_t i = 0; i < of->size(); ++i) {
      const Vec2 side = (*of)[(i + 1) % of->size()] - (*of)[i];
      const Vec2 n = Vec2(side.y(), -side.x()).normalized();
      double low_a = 1e300, high_a = -1e300, low_b = 1e300, high_b = -1e300;
      for (const Vec2& p : of_a) low_a = std::min(low_a, n.dot(p)), high_a = std::max(high_a, n.dot(p));
      for (const Vec2& p : of_b) low_b = std::min(low_b, n.dot(p)), high_b = std::max(high_b, n.dot(p));
      least = std::min(least, std::min(high_a, high_b) - std::max(low_a, low_b));
    }
  return least;
}

double deepest(const std::vector<Body<2>>& bodies) {
  double most = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (std::size_t j = i + 1; j < bodies.size(); ++j)
      if ((bodies[i].x - bodies[j].x).norm() < bodies[i].size + bodies[j].size)
        most = std::max(most, overlap(bodies[i], bodies[j]));
  return most;
}

}  // namespace dense_step_test

using namespace dense_step_test;

TEST_CASE("a disk that lands in a dense world rebounds by its law at the velocity of its touch") {
  for (const double speed : {1.0, 5.0, 20.0})
    for (const double e : {0.2, 0.9}) {
      Material material(e, 0.5);
      Bench bench(ground(100), material, dense());
      bench.add(disk(0.5, 1000, {0, 0.5 + 0.3 * speed}, {2, -speed}));
      bench.add(disk(0.5, 1000, {50, 0.5}));
      bench.world.choose_density();
      REQUIRE(bench.world.is_dense());
      const double height = 0.3 * speed, landing = std::sqrt(speed * speed + 2 * 9.81 * height);
      const double touches = (landing - speed) / 9.81;
      std::vector<Impact> impacts;
      double highest = 0;
      while (bench.world.time < touches + e * landing / 9.81) {
        bench.world.step(bench.world.step_length(), true);
        for (const Impact& impact : bench.world.impacts()) impacts.push_back(impact);
        if (!impacts.empty()) highest = std::max(highest, bench.world.bodies[0].x.y() - 0.5);
      }
      REQUIRE(impacts.size() == 1);
      CHECK(impacts[0].vn_before == Approx(-landing).epsilon(1e-9));
      CHECK(impacts[0].vn_after == Approx(e * landing).epsilon(1e-9));
      CHECK(impacts[0].time == Approx(touches).margin(1e-9));
      CHECK(highest == Approx(e * e * landing * landing / (2 * 9.81)).epsilon(0.01));
    }
}

TEST_CASE("a body that touches nothing flies through a dense world along its parabola") {
  Material material(0.5, 0.5);
  Bench bench(ground(100), material, dense());
  bench.add(disk(0.5, 1000, {0, 20}, {8, 3}, 2));
  for (int i = 0; i < 3; ++i) bench.add(disk(0.5, 1000, {-50.0 + i, 0.5}));
  bench.world.choose_density();
  while (bench.world.time < 1) bench.world.step(bench.world.step_length(), true);
  const double t = bench.world.time;
  CHECK((bench.world.bodies[0].x - Vec2(8 * t, 20 + 3 * t - 0.5 * 9.81 * t * t)).norm() < 1e-9);
  CHECK(bench.world.bodies[0].attitude.angle == Approx(2 * t));
}

TEST_CASE("a block that slides alone in a dense world is ahead by half a step of its last speed") {
  constexpr double mu = 0.3, slope = 0.5, t_end = 2;
  Material material(0, mu);
  Bench bench(ground(100, slope), material, dense());
  const Vec2 normal(std::sin(slope), std::cos(slope)), along(std::cos(slope), -std::sin(slope));
  bench.add(box(1, 0.5, 1000, 0.25 * normal, -slope));
  bench.add(box(1, 0.5, 1000, 0.25 * normal - 50 * along, -slope));
  bench.world.choose_density();
  while (bench.world.time < t_end - 1e-9)
    bench.world.step(std::min(bench.world.step_length(), t_end - bench.world.time), true);
  const double a = 9.81 * (std::sin(slope) - mu * std::cos(slope));
  const double exact = 0.5 * a * t_end * t_end, error = 0.5 * a * 4e-3 * t_end;
  CHECK(along.dot(bench.world.bodies[0].x) - exact == Approx(error).epsilon(0.01));
  CHECK(bench.world.bodies[0].v.norm() == Approx(a * t_end).epsilon(1e-4));
}

TEST_CASE("a stack of ten boxes in dense steps keeps its height") {
  Material material(0, 0.6);
  Bench bench(ground(10), material, dense());
  for (int i = 0; i < 10; ++i) bench.add(box(1, 1, 2700, {0, 0.5 + i}));
  bench.world.choose_density();
  for (int k = 0; k < 1000; ++k) bench.world.step(bench.world.step_length(), true);
  for (int i = 0; i < 10; ++i) {
    CHECK(std::abs(bench.world.bodies[i].x.y() - (0.5 + i)) < 1e-7);
    CHECK(std::abs(bench.world.bodies[i].x.x()) < 1e-5);  // by residuals of 1e-4 of the speed scale
  }
}

TEST_CASE("a stack that has bounced in dense steps comes to rest at once, without new impacts") {
  for (const double e : {0.1, 0.3, 0.8}) {
    Material material(e, 0.6);
    Bench bench(ground(10), material, dense());
    for (int i = 0; i < 5; ++i) bench.add(box(1, 1, 2700, {0, 0.5 + 1.01 * (i + 1)}));
    bench.world.choose_density();
    bench.run(3);
    for (const BodyHistory& history : bench.histories) CHECK(history.reason == StopReason::stopped);
    const double weight = 2700 * 9.81;
    CHECK(bench.world.quality().projection_energy < 1e-4 * 5 * weight);  // a tenth of a millimetre
    for (const Body<2>& body : bench.world.bodies) CHECK(body.v.norm() < 1e-3);
  }
}

TEST_CASE("features that have slid off each other are not deep, nor pushed apart") {
  constexpr double size = 0.266;
  for (const int seed : {10, 24}) {
    std::mt19937 dice(seed);
    std::uniform_real_distribution<double> part(0, 1);
    Material material(0, 0.5);
    Bench bench(pit(2), material, automatic());
    for (int k = 0; k < 60; ++k) {
      Body<2> body =
          make_body({Contactor2::polygon({{-0.2, -0.15}, {0.2, -0.15}, {0.25, 0.1}, {0, 0.2}, {-0.2, 0.1}})},
                    2700, 0, 1);
      body.move_to({0.55 * (k % 6 - 2.5), 0.5 + 0.55 * (k / 6)}, 2 * pi * part(dice));
      bench.add(std::move(body));
    }
    bench.run(1.5);
    const SolverQuality& quality = bench.world.quality();
    CHECK(quality.dense_steps > 0);
    CHECK(deepest(bench.world.bodies) < 1e-4 * size);  // what a solve may leave
    // Deeper steps are halved, at most eight times: of 30 pits the deepest ended at 0.15 mm.
    CHECK(quality.max_penetration < 1.2 * 5e-4 * size);
  }
}

TEST_CASE("thirty random polygons that fall into a pit come to rest, and nothing lies in anything") {
  std::mt19937 dice(12345);
  Material material(0.1, 0.6);
  Bench bench(pit(4), material, automatic());
  for (int k = 0; k < 30; ++k) bench.add(lump(dice, {1.1 * (k % 6 - 2.5), 0.6 + 1.1 * (k / 6)}));
  bench.run(20);
  for (const BodyHistory& history : bench.histories) CHECK(history.reason == StopReason::stopped);
  const SolverQuality& quality = bench.world.quality();
  CHECK(quality.dense_steps > 0);
  CHECK(quality.dense_steps < quality.steps);  // the first touches are exact
  CHECK(quality.unsolved_depth <= 1e-5);
  CHECK(quality.max_penetration < 1e-3);
  CHECK(deepest(bench.world.bodies) < 1e-3 * 0.3);
  for (const Body<2>& body : bench.world.bodies) CHECK(body.x.y() > 0.2);
}

TEST_CASE(
    "the energy of a dense pile changes by its contacts, the first order of the step, and what is lifted") {
  std::mt19937 dice(7);
  Material material(0, 0.5);
  WorldSettings settings = dense();
  settings.dense_tolerance = 1e-9;
  settings.dense_iterations = 10'000;
  Bench bench(pit(4), material, settings);
  for (int k = 0; k < 12; ++k) bench.add(lump(dice, {1.1 * (k % 6 - 2.5), 0.6 + 1.1 * (k / 6)}));
  bench.world.choose_density();
  double contacts = 0;
  const double start = bench.world.total_energy();
  for (int k = 0; k < 250; ++k) {
    std::vector<typename Body<2>::Rows> before;
    for (const Body<2>& body : bench.world.bodies) before.push_back(body.velocity());
    const double h = bench.world.step(bench.world.step_length(), true).duration;
    for (std::size_t i = 0; i < before.size(); ++i) {  // the work of contacts, from what the bodies gained
      const Body<2>& body = bench.world.bodies[i];
      const auto gain = (body.velocity() - before[i]).eval(), sum = (body.velocity() + before[i]).eval();
      contacts += 0.5 * body.mass * (gain.head<2>() - h * Vec2(0, -9.81)).dot(sum.head<2>());
      contacts += 0.5 * body.inertia * gain[2] * sum[2];
    }
  }
  const SolverQuality& quality = bench.world.quality();
  const double change = bench.world.total_energy() - start;
  CHECK(contacts < 0);
  CHECK(change == Approx(contacts - quality.theta_loss + quality.projection_energy).epsilon(1e-6));
}

TEST_CASE("a wall of forty contacts is dense, and a few bodies are exact, springs are never dense") {
  Material material(0, 0.6);
  for (const int rows : {2, 12}) {
    Bench bench(ground(30), material, automatic());
    for (int row = 0; row < rows; ++row)
      for (int i = 0; i < 3; ++i)
        bench.add(box(1, 0.5, 675, {1.01 * i + (row % 2 ? 0.25 : 0), 0.25 + 0.5 * row}));
    bench.world.step(1e-3, true);
    CHECK(bench.world.is_dense() == (rows == 12));
  }
}

TEST_CASE(
    "a slope of blocks that lean on each other stands above the limit of its equilibrium in dense steps") {
  // Goodman and Bray 1976: columns 10 m wide on steps of 1 m, on a base that falls by 30 deg, here turned to
  // the level. They topple below 38.15 deg of friction.
  constexpr int blocks = 16, crest = 10;
  constexpr double width = 10, base = 30 * pi / 180, friction = 40 * pi / 180;
  Profile steps;
  steps.points = {{-200, 0}};
  for (int n = 1; n <= blocks; ++n) {
    steps.points.push_back({width * n, n - 1});
    steps.points.push_back({width * n, n});
  }
  steps.points.push_back({width * blocks + 100, blocks});
  steps.part.assign(steps.points.size() - 1, 0);
  steps.parts = {""};
  Material rock(0, std::tan(friction));
  Bench bench(steps, rock, dense(), 9.81 * Vec2(-std::sin(base), -std::cos(base)));
  for (int n = 1; n <= blocks; ++n) {
    const double height = n <= crest ? 4 * n : 4 * crest - 6 * (n - crest);
    bench.add(box(width, height, 2500 * width * height, {width * (n - 0.5), n - 1 + height / 2}));
  }
  const std::vector<Body<2>> start = bench.world.bodies;
  bench.run(2);
  for (int n = 0; n < blocks; ++n) CHECK((bench.world.bodies[n].x - start[n].x).norm() < 5e-3);
}

TEST_CASE("what a pile keeps grows with time: not with its steps, touches and impacts") {
  Material material(0.3, 0.5);
  Bench bench(pit(2), material, automatic());
  std::mt19937 dice(5);
  for (int i = 0; i < 40; ++i) bench.add(lump(dice, {-1.5 + i % 4, 1 + i / 4}));
  bench.run_settings.trajectory_every = 0.02;
  bench.run_settings.stop_speed = 0;
  bench.run(4);
  int rows = 0, impacts = 0;
  for (const BodyHistory& body : bench.histories) {
    int counted = 0;
    for (const Impact& impact : body.impacts) counted += impact.count;
    CHECK(counted == body.impact_count);
    for (std::size_t i = 1; i < body.impacts.size(); ++i)
      CHECK(body.impacts[i].number > body.impacts[i - 1].number);
    rows += static_cast<int>(body.impacts.size()), impacts += body.impact_count;
    CHECK(body.trajectory.size() <
          2 * 4 / 0.02);  // about those that fall due: of all steps, several thousand
  }
  CHECK(rows < impacts);
}

TEST_CASE("a flight has no points more where others collide meanwhile") {
  Material material(1, 0);
  Bench bench(ground(100), material, {.step_tolerance = 1e-3});
  bench.add(disk(0.5, 1000, {50, 60}, {-3, 0}));
  for (int i = 0; i < 5; ++i) bench.add(disk(0.5, 1000, {3.0 * i, 0.501 + 0.01 * i}));
  bench.run_settings.trajectory_every = 0.1;
  bench.run(2);
  CHECK(bench.histories[1].impact_count > 20);
  CHECK(bench.histories[0].trajectory.size() == 21);
}

TEST_CASE("impacts of a pair are summed: means by impulse, sums of impulse and energy") {
  Impact sum, later;
  sum.pn = 1, sum.vn_before = -2, sum.vn_after = 1, sum.energy_change = -3, sum.pt = 0.5, sum.number = 4;
  later.pn = 3, later.vn_before = -4, later.vn_after = 2, later.energy_change = -5, later.pt = 1,
  later.number = 5;
  later.place.x() = 8;
  add(sum, later);
  CHECK(sum.pn == 4);
  CHECK(sum.pt == 1.5);
  CHECK(sum.energy_change == -8);
  CHECK(sum.vn_before == -3.5);
  CHECK(sum.vn_after == 1.75);
  CHECK(sum.place.x() == 6);
  CHECK(sum.count == 2);
  CHECK(sum.number == 4);
}
