// What a history keeps of the way between two ends: the mode of travel of each stored point.

#include <catch2/catch.hpp>

#include "lab.h"

using namespace flyrock;

TEST_CASE("A stored point says in which mode the body arrived there") {
  lab::Material ground(0.5, 0.6, 0.01);
  lab::Bench bench(lab::ground(100), ground);
  bench.add(lab::disk(0.2, 10, {0, 3}, {4, 0}));
  bench.run_settings.trajectory_every = 0.02;
  bench.run_settings.stop_speed = 0.01;
  const BodyHistory& history = bench.run(60);
  REQUIRE(history.reason == StopReason::stopped);
  // The path of each mode, from the stored points: bounces, then rolling to the end.
  std::array<double, 4> distance{};
  for (std::size_t i = 1; i < history.trajectory.size(); ++i) {
    const TrajectoryPoint &a = history.trajectory[i - 1], &b = history.trajectory[i];
    CHECK(b.state.time > a.state.time);
    distance[static_cast<int>(b.mode)] += (b.state.position - a.state.position).norm();
  }
  for (std::size_t mode = 0; mode < distance.size(); ++mode)
    CHECK(distance[mode] == Approx(history.travel.distance[mode]).margin(0.02 * history.max_distance));
  CHECK(history.trajectory.back().mode == TravelMode::roll);
}
