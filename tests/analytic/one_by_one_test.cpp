// Contacts that close at one instant and collide one after the other (`impacts: one_by_one`).
#include <catch2/catch.hpp>

#include "analytic/lab_3d.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace {

WorldSettings one_by_one() {
  WorldSettings settings;
  settings.one_by_one = true;
  settings.step_tolerance = 1e-3;
  return settings;
}

/// The speeds of touching balls of 1 kg in a row, of which the first one arrives at 1 m/s.
std::vector<double> cradle(int balls, double e_n, double rest_speed, std::size_t* impacts = nullptr) {
  Material material(e_n, 0);
  WorldSettings settings = one_by_one();
  settings.rest_speed = rest_speed;
  Bench bench(ground(50), material, settings, {0, 0});
  for (int i = 0; i < balls; ++i)
    bench.add(disk(0.1, 1, {0.2 * i - (i == 0 ? 0.3 : 0), 5}, {i == 0 ? 1.0 : 0.0, 0}));
  bench.run_settings.keep_impacts = true;
  bench.run_settings.stop_speed = 0;
  bench.run(0.4);
  std::vector<double> speeds;
  for (const Body<2>& ball : bench.world.bodies) speeds.push_back(ball.v.x());
  if (impacts) {
    *impacts = 0;
    for (const BodyHistory& history : bench.histories) *impacts += history.impacts.size();
  }
  return speeds;
}

/// The same by hand.
std::vector<double> by_hand(int balls, double e_n, double rest_speed) {
  std::vector<double> v(balls, 0.0);
  v[0] = 1;
  for (;;) {
    int next = -1;
    double fastest = rest_speed;
    for (int i = 0; i + 1 < balls; ++i)
      if (v[i] - v[i + 1] > fastest) fastest = v[i] - v[i + 1], next = i;
    if (next < 0) return v;
    const double sum = v[next] + v[next + 1], open = e_n * (v[next] - v[next + 1]);
    v[next] = 0.5 * (sum - open);
    v[next + 1] = 0.5 * (sum + open);
  }
}

}  // namespace

TEST_CASE("a touching cradle hands its speed on, one ball after the other") {
  std::size_t impacts = 0;
  const std::vector<double> speeds = cradle(5, 1, 0.02, &impacts);
  for (int i = 0; i < 4; ++i) CHECK(speeds[i] == Approx(0).margin(1e-12));
  CHECK(speeds[4] == Approx(1));
  CHECK(impacts == 8);  // each in the history of both balls
}

TEST_CASE(
    "balls that lose energy collide again, the fastest approach first, until none exceeds the rest speed") {
  for (const double e_n : {0.9, 0.5, 0.2}) {
    const std::vector<double> speeds = cradle(5, e_n, 0.003), expected = by_hand(5, e_n, 0.003);
    double momentum = 0;
    for (int i = 0; i < 5; ++i) {
      INFO("e_n " << e_n << ", ball " << i);
      // What is slower than the rest speed is stopped in one problem of all contacts, two of a ball.
      CHECK(speeds[i] == Approx(expected[i]).margin(2 * 0.003));
      momentum += speeds[i];
    }
    CHECK(momentum == Approx(1));
  }
}

TEST_CASE("a box that lands flat bounces corner after corner, keeps its energy balance and ends at rest") {
  for (const double e_n : {0.0, 0.5, 1.0}) {
    Material material(e_n, 0);  // with friction, Newton's law may gain energy at a corner
    Bench bench(ground(50), material, one_by_one());
    bench.add(box(1, 0.5, 10, {0, 1.25}));
    const BodyHistory& history = bench.run(e_n < 1 ? 20 : 2);
    CHECK(bench.world.quality().energy_gains == 0);
    CHECK(history.reason == (e_n < 1 ? StopReason::stopped : StopReason::timed_out));
    CHECK(history.last.position.y() > 0.25 - 1e-6);
    if (e_n < 1) CHECK(history.last.position.y() == Approx(0.25).margin(1e-6));
  }
}

TEST_CASE("in 3D a box on four corners ends at rest, and a spring among the contacts is left to the steps") {
  Material material(0.6, 0.4);
  Bench3 bench(plane(), material, one_by_one());
  bench.add(box({1, 1, 0.5}, 10, {0, 0, 1}));
  const BodyHistory& history = bench.run(20);
  CHECK(history.reason == StopReason::stopped);
  CHECK(history.last.position.z() == Approx(0.25).margin(1e-6));

  struct Soft : UnilateralLaw {
    bool constant() const override { return true; }
    std::string origin() const override { return "penalty"; }
    Unilateral condition(Values, const ContactState&) const override {
      return {NormalCondition::penalty, {.stiffness = 1e5, .damping = 300}, 0};
    }
  } soft;
  Material springs(0.6, 0.4);
  springs.surface.unilateral.law = &soft;
  Bench landing(ground(5), springs, one_by_one());
  landing.add(disk(0.1, 1, {0, 1}));
  landing.run(10);
  CHECK(landing.histories[0].reason == StopReason::stopped);
  CHECK(landing.histories[0].last.position.y() == Approx(0.1 - 9.81 / 1e5).margin(1e-6));
}
