// A body is at rest where it stays, not where it is slow for a moment.
#include "flight/rest.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "analytic/lab.h"

using namespace flyrock;
using namespace flyrock::lab;

TEST_CASE("a box that slowly passes over its corner comes to rest on its side") {
  // About the corner I = m (1/6 + 1/2) of a square of 1 m. The energy at the tilt a before the top:
  // I w^2 / 2 = I w_top^2 / 2 + m g r (1 - cos a), with r = 1 / sqrt(2).
  const double r = std::sqrt(0.5), inertia = 2.0 / 3;
  for (const double speed_at_top : {0.002, 0.005, 0.01, 0.02, 0.035, 0.045}) {
    for (const double tilt : {0.002, 0.01, 0.03}) {
      INFO(speed_at_top << " m/s at the top, released " << tilt << " rad before it");
      Material rough(0, 2);
      Bench bench(ground(20), rough);
      Body<2> square = box(1, 1, 1000, {-r * std::sin(tilt), r * std::cos(tilt)}, pi / 4 + tilt);
      square.w = -std::sqrt(std::pow(speed_at_top / r, 2) + 2 * 9.81 * r * (1 - std::cos(tilt)) / inertia);
      square.v = -square.w * Vec2(square.x.y(), -square.x.x());
      bench.add(square);
      const BodyHistory& history = bench.run(30);
      CHECK(history.reason == StopReason::stopped);
      CHECK(std::abs(history.last.position.y() - 0.5) < 1e-6);
      CHECK(std::abs(std::remainder(history.last.angle, pi / 2)) < 1e-6);
      CHECK(history.last.position.x() > 0.4);  // on the side beyond the top
    }
  }
}

TEST_CASE("a disk that rolls slowly on level ground counts as at rest after 0.2 s") {
  Material rough(0, 0.5);
  Bench bench(ground(20), rough);
  bench.add(disk(0.5, 1000, {0, 0.5}, {0.03, 0}, -0.06));
  const BodyHistory& history = bench.run(30);
  CHECK(history.reason == StopReason::stopped);
  CHECK(history.stop_time == 0);
  CHECK(history.last.time == Approx(rest_time));
}

TEST_CASE(
    "a disk that starts to slide down a slope of half a millimetre a metre does not rest, however slow it "
    "is") {
  Material smooth(0, 0);
  const double slope = 5e-4;
  Bench bench(ground(20, slope), smooth);
  bench.add(disk(0.5, 1000, 0.5 * Vec2(std::sin(slope), std::cos(slope))));
  const BodyHistory& history = bench.run(20);
  CHECK(history.reason == StopReason::timed_out);
  CHECK(history.last.velocity.norm() == Approx(20 * 9.81 * std::sin(slope)));
}

TEST_CASE("a body that rocks slower than the stop speed is at rest after the settling time") {
  BodyHistory history;
  RestWatch watch(RestWatch::Kind::body, 0.05, history);
  const double h = 0.01;
  double time = 0, speed = 0.049;
  for (; std::isnan(history.stop_time); time += h) {
    const double next = 0.049 * std::abs(std::cos(3 * (time + h)));
    watch.rests(time, time + h, speed, next, {});
    speed = next;
    REQUIRE(time < 2 * settling_time);
  }
  CHECK(time == Approx(settling_time).margin(2 * h));
}
