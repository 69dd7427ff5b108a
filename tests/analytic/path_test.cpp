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

TEST_CASE("Bodies that meet in the air land where they meet the terrain") {
  lab::Material material(0.5, 0.6, 0.01);
  lab::Bench bench(lab::ground(100), material);
  const double radius = 0.2, g = 9.81;
  bench.add(lab::disk(radius, 10, {0, 10}, {5, 0}));
  bench.add(lab::disk(radius, 10, {4, 10}, {-5, 0}));
  bench.run(60);
  // They meet after 3.6 m at 10 m/s and part at half of it.
  const double meeting = 0.36, landing = std::sqrt(2 * (10 - radius) / g);
  for (const BodyHistory& history : bench.histories) {
    CHECK(history.landed);
    CHECK(history.flight_range == Approx(2.5 * (landing - meeting) - 5 * meeting).margin(1e-6));
    const int flight = static_cast<int>(TravelMode::flight);
    CHECK(history.travel.time[flight] == Approx(landing).margin(2 * bench.world.settings().time_step));
  }
}

TEST_CASE("A flight that is cut short has flown as far as it came, however it ended") {
  lab::Material material(0.5, 0.6);
  std::vector<Barrier> fence{{6, 100, 1e9}};
  const auto flown = [&](double stop_time, double half_length, bool fenced) {
    lab::Bench bench(lab::ground(half_length), material);
    bench.add(lab::disk(0.2, 10, {0, 10}, {5, 0}));
    if (fenced) bench.run_settings.barriers = fence;
    const BodyHistory history = bench.run(stop_time);
    CHECK_FALSE(history.landed);
    CHECK(history.flight_range == history.max_distance);
    return std::pair(history.reason, history.flight_range);
  };
  CHECK(flown(1, 100, false) == std::pair(StopReason::timed_out, 5.0));
  CHECK(flown(60, 6, false).first == StopReason::left_domain);
  CHECK(flown(60, 6, false).second == Approx(6));
  CHECK(flown(60, 100, true).first == StopReason::caught);
  CHECK(flown(60, 100, true).second == Approx(6));
}

TEST_CASE("The bins along a parabola hold its heights, speeds and energies") {
  lab::Material ground(0, 10);
  lab::Bench bench(lab::ground(100), ground);
  const double vx = 10, vy = 12, g = 9.81, radius = 0.2, mass = 10;
  bench.add(lab::disk(radius, mass, {0.5, radius}, {vx, vy}));
  bench.run_settings.bin_width = 2;
  const BodyHistory& history = bench.run(2 * vy / g);  // until it lands
  const PathBins& path = history.path;
  CHECK(path.first() == 0);
  REQUIRE(path.bins().size() >= 12);
  const auto height = [&](double t) { return radius + t * (vy - 0.5 * g * t); };
  const auto speed2 = [&](double t) { return vx * vx + (vy - g * t) * (vy - g * t); };
  for (std::size_t i = 0; i < 12; ++i) {
    const double enters = i == 0 ? 0 : (2.0 * static_cast<double>(i) - 0.5) / vx;
    const double leaves = (2.0 * static_cast<double>(i) + 1.5) / vx;
    CHECK(path.bins()[i].height == Approx(height(std::clamp(vy / g, enters, leaves))));
    CHECK(path.bins()[i].speed == Approx(std::sqrt(std::max(speed2(enters), speed2(leaves)))));
    CHECK(path.bins()[i].energy == Approx(0.5 * mass * std::max(speed2(enters), speed2(leaves))));
  }
}

TEST_CASE("Bins grow to both sides and end with the ground") {
  PathBins path(1, -3, 3);
  const auto count = [](PathBin& bin, double t0, double t1) { bin.height += t1 - t0; };
  path.visit(0.5, 1, 0, 1, count);     // to 1.5
  path.visit(1.5, -2, 0, 1.5, count);  // to -1.5
  path.visit(-1.5, -1, 0, 9, count);   // beyond the ground: its first bin keeps the rest
  CHECK(path.first() == -3);
  REQUIRE(path.bins().size() == 5);
  double time = 0;
  for (const PathBin& bin : path.bins()) time += bin.height;
  CHECK(time == Approx(1 + 1.5 + 9));
  CHECK(path.bins()[0].height == Approx(8.5));
  CHECK(path.bins()[3].height == Approx(0.5 + 0.5));
}
