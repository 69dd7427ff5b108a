// Loads over time: a table that tilts, ground that shakes, forces and friction that change.

#include <catch2/catch.hpp>

#include "flight/settle.h"
#include "lab_3d.h"

namespace loads_test {

using namespace flyrock;
using namespace flyrock::lab;

constexpr double earth_gravity = 9.81;  // m/s2

/// A number over time.
OverTime numbers(const std::vector<std::pair<double, double>>& rows) {
  std::vector<OverTime::Row> list;
  for (const auto& [time, value] : rows) list.push_back({time, {value, 0, 0}});
  return OverTime(std::move(list));
}

/// Gravity in the frame of a table that falls towards +x by this angle [rad].
Vec3 gravity_on(double tilt) { return earth_gravity * Vec3(std::sin(tilt), -std::cos(tilt), 0); }

TEST_CASE("A block on a table that tilts slides from atan(mu) on, to a millionth of a radian") {
  const double mu = 0.6, limit = std::atan(mu), end = 3;
  for (const double beyond : {-1e-6, 1e-6}) {
    Material rock(0, mu);
    Bench bench(ground(50), rock);
    bench.add(box(1, 0.5, 100, {0, 0.25}));
    const OverTime gravity(
        {{0, gravity_on(0)}, {0.5, gravity_on(0.9 * limit)}, {1, gravity_on(limit + beyond)}});
    const LoadTables loads{.gravity = &gravity, .last_change = 1};
    bench.run_settings.loads = &loads;
    bench.run_settings.stop_speed = 0;
    bench.run(end);
    const double pull = earth_gravity * (std::sin(limit + beyond) - mu * std::cos(limit + beyond));
    const double slides = 0.5 * std::max(0.0, pull) * (end - 1) * (end - 1);
    CHECK(bench.world.bodies[0].x.x() == Approx(slides).epsilon(0.01).margin(1e-8));
  }
}

struct StaticDynamic : FrictionLaw {
  double mu_s, mu_d;
  StaticDynamic(double at_rest, double sliding) : mu_s(at_rest), mu_d(sliding) {}
  bool constant() const override { return true; }
  std::string origin() const override { return "static_dynamic"; }
  Friction friction(Values, const ContactState&) const override { return {mu_s, mu_d}; }
};

/// The place of a block along the fall line at `end` [m], on a table that is at the angle `tilt` from 1 s on.
template <int D>
double slid_on_table(BenchOf<D>& bench, double tilt, double end) {
  const auto axes = [](const Vec3& in_plane) {
    return D == 2 ? in_plane : Vec3(in_plane.x(), 0, in_plane.y());
  };
  const OverTime gravity({{0, axes(gravity_on(0))}, {1, axes(gravity_on(tilt))}});
  const LoadTables loads{.gravity = &gravity, .last_change = 1};
  bench.run_settings.loads = &loads;
  bench.run_settings.stop_speed = 0;
  bench.run(end);
  return bench.world.bodies[0].x.x();
}

TEST_CASE("A block on two or four corners slips from mu_s on, and then all of it with mu_d") {
  const double mu_s = 0.6, mu_d = 0.4, end = 2;
  const StaticDynamic friction(mu_s, mu_d);
  for (const double share : {0.9999, 1.0001}) {
    const double tilt = std::atan(share * mu_s);
    const double pull = earth_gravity * (std::sin(tilt) - mu_d * std::cos(tilt));
    const double slides = share > 1 ? 0.5 * pull * (end - 1) * (end - 1) : 0;
    Material rock(0, 0);
    rock.surface.friction.law = &friction;
    Bench in_2d(ground(50), rock);
    in_2d.add(box(1, 0.5, 100, {0, 0.25}));
    CHECK(slid_on_table(in_2d, tilt, end) == Approx(slides).epsilon(0.01).margin(1e-8));
    Bench3 in_3d(plane(), rock);
    in_3d.add(box(Vec3(1, 0.6, 0.5), 100, {0, 0, 0.25}));
    CHECK(slid_on_table(in_3d, tilt, end) == Approx(slides).epsilon(0.01).margin(1e-8));
  }
}

TEST_CASE("A block slides on shaken ground as Newmark's sliding block") {
  const double mu = 0.3, push = 0.5 * earth_gravity, yield = mu * earth_gravity, pulse = 0.2;
  const double speed = push * pulse;
  Material rock(0, mu);
  Bench bench(ground(50), rock);
  bench.add(box(1, 0.5, 100, {0, 1.25}));
  Body<2> table = box(20, 1, 0, {0, 0.5});
  table.kind = BodyKind::driven;
  bench.add(std::move(table));
  const OverTime velocity = numbers({{0.1, 0}, {0.1 + pulse, speed}});
  const LoadTables loads{.of_body = {nullptr, &velocity}, .last_change = 0.1 + pulse};
  bench.run_settings.loads = &loads;
  bench.run(1);
  const auto& bodies = bench.world.bodies;
  CHECK(bodies[1].x.x() == Approx(0.5 * push * pulse * pulse + speed * (0.9 - pulse)));
  const double newmark = 0.5 * speed * speed / yield * (1 - yield / push);
  CHECK(bodies[1].x.x() - bodies[0].x.x() == Approx(newmark).epsilon(1e-4));
  CHECK(bodies[0].v.x() == Approx(speed).epsilon(1e-6));
}

/// The times between the last impacts of a ball on a table that swings with this acceleration [g].
std::vector<double> intervals_on(double shaking) {
  const double e = 0.5, period = 0.1, omega = 2 * pi / period;
  const double amplitude = shaking * earth_gravity / (omega * omega);
  // Where a ball bounces once a period: the phase of the impacts from the centre of the swing
  const double phase = std::acos(pi * (1 - e) / (1 + e) / shaking);
  Material rock(e, 0);
  Bench bench(ground(50), rock);
  const double rises = amplitude * std::sin(phase);
  bench.add(disk(0.05, 1, {0, 0.5 + rises + 0.05 + 1e-9}, {0, 0.5 * earth_gravity * period + 1e-3}));
  Body<2> table = box(1, 0.2, 0, {0, 0.4 + rises});
  table.kind = BodyKind::driven;
  bench.add(std::move(table));
  std::vector<OverTime::Row> rows;
  for (int k = 0; k <= 16'000; ++k) {
    const double time = k * period / 200;
    rows.push_back({time, {0, amplitude * omega * std::cos(omega * time + phase), 0}});
  }
  const OverTime velocity(std::move(rows));
  const LoadTables loads{.of_body = {nullptr, &velocity}, .last_change = velocity.last_change()};
  bench.run_settings.loads = &loads;
  const BodyHistory& history = bench.run(80 * period);
  std::vector<double> intervals;
  for (std::size_t k = history.impacts.size() - 8; k < history.impacts.size(); ++k)
    intervals.push_back((history.impacts[k].time - history.impacts[k - 1].time) / period);
  return intervals;
}

// Gamma_1^2 = (pi (1 - e)/(1 + e))^2 + (2 (1 + e^2)/(1 + e)^2)^2 = 1.527^2 for e = 0.5
TEST_CASE("The bounces of a ball on a shaken table double their period at the known acceleration") {
  for (const double interval : intervals_on(1.48)) CHECK(interval == Approx(1).margin(2e-3));
  const std::vector<double> doubled = intervals_on(1.57);
  for (std::size_t k = 1; k < doubled.size(); ++k) {
    CHECK(std::abs(doubled[k] - doubled[k - 1]) > 0.05);
    CHECK(doubled[k] + doubled[k - 1] == Approx(2).margin(5e-3));
  }
}

TEST_CASE("A block on a slope moves once its coefficient of friction has fallen below tan(slope)") {
  const double slope = pi / 6, rate = 0.1, end = 3;
  Material rock(0, 0.7);
  const OverTime mu = numbers({{0, 0.7}, {end, 0.7 - rate * end}});
  rock.surface.mu = &mu;
  Bench bench(ground(50, slope), rock);
  const Vec2 normal(std::sin(slope), std::cos(slope)), along(std::cos(slope), -std::sin(slope));
  bench.add(box(1, 0.5, 100, 0.25 * normal, -slope));
  const LoadTables loads{.last_change = end};
  bench.run_settings.loads = &loads;
  bench.run(end);
  const double begins = (0.7 - std::tan(slope)) / rate;
  const double slides = earth_gravity * std::cos(slope) * rate * std::pow(end - begins, 3) / 6;
  CHECK(along.dot(bench.world.bodies[0].x) == Approx(slides).epsilon(1e-3));
}

TEST_CASE("A force that grows moves a body in flight with the cube of time, and its work is counted") {
  Material rock(0.5, 0.5);
  Bench bench(ground(50), rock, {}, Vec2::Zero());
  bench.add(disk(0.5, 100, {0, 8}));
  const OverTime force({{0, {0, 0, 0}}, {2, {600, 300, 0}}});
  const LoadTables loads{.of_body = {&force}, .last_change = 2};
  bench.run_settings.loads = &loads;
  bench.run(2);
  const Body<2>& body = bench.world.bodies[0];
  CHECK(body.x.x() == Approx(600. / 100 / 2 * 8 / 6).epsilon(1e-6));
  CHECK(body.x.y() == Approx(8 + 300. / 100 / 2 * 8 / 6).epsilon(1e-6));
  CHECK(bench.world.energy_given() == Approx(0.5 * 100 * (36 + 9)).epsilon(1e-6));
}

TEST_CASE("Gravity that turns leaves the balance of energy closed") {
  Material rock(0.5, 0.5);
  Bench bench(ground(50), rock);
  bench.add(disk(0.5, 100, {3, 8}));
  const OverTime gravity({{0, gravity_on(0)}, {1, gravity_on(0.5)}});
  const LoadTables loads{.gravity = &gravity, .last_change = 1};
  bench.run_settings.loads = &loads;
  const double start = bench.world.total_energy();
  bench.run(1);
  CHECK(bench.world.bodies[0].v.x() == Approx(0.5 * earth_gravity * std::sin(0.5)).epsilon(1e-9));
  CHECK(bench.world.total_energy() == Approx(start + bench.world.energy_given()));
}

TEST_CASE("A run goes on until its loads no longer change, and a body at rest may move again") {
  Material rock(0, 0.3);
  Bench bench(ground(50), rock);
  bench.add(box(1, 0.5, 100, {0, 0.25}));
  const OverTime force = numbers({{3, 0}, {3.001, 600}, {4, 600}, {4.001, 0}});
  const LoadTables loads{.of_body = {&force}, .last_change = 4.001};
  bench.run_settings.loads = &loads;
  const BodyHistory& history = bench.run(20);
  CHECK(history.reason == StopReason::stopped);
  const double pull = 6 - 0.3 * earth_gravity, brake = 0.3 * earth_gravity;
  CHECK(history.last.position.x() == Approx(0.5 * pull * (1 + pull / brake)).epsilon(2e-3));
  CHECK(history.stop_time == Approx(4 + pull / brake).margin(0.05));
}

TEST_CASE("Bodies settle under the loads of time 0") {
  Material rock(0.5, 0.3);
  Bench bench(ground(50), rock);
  bench.add(box(1, 0.5, 100, {0, 0.35}));
  const OverTime gravity({{0, gravity_on(0)}, {1, gravity_on(1.2)}});
  const LoadTables loads{.gravity = &gravity, .last_change = 1};
  settle<2>(bench.world, {.until = 0.01, .at_most = 10, .loads = &loads});
  CHECK(bench.world.bodies[0].x.x() == Approx(0).margin(1e-6));
  CHECK(bench.world.bodies[0].x.y() == Approx(0.25).margin(1e-6));
  CHECK(bench.world.gravity().x() == 0);
}

TEST_CASE("A table over time is linear between its rows and constant outside of them") {
  const OverTime table = numbers({{1, 2}, {3, 6}});
  CHECK(table.at(0).x() == 2);
  CHECK(table.at(2).x() == 4);
  CHECK(table.at(9).x() == 6);
  CHECK(table.end_of_piece(0) == 1);
  CHECK(table.end_of_piece(3) == infinite);
  int pieces = 0;
  for (double time = 1; time < 3; time = table.end_of_piece(time)) ++pieces;
  CHECK(pieces == 667);  // each with a thousandth of 6
  const OverTime quick = numbers({{0, 0}, {0.01, 5}});
  for (double time = 0; time < 0.01; time = quick.end_of_piece(time)) ++pieces;
  CHECK(pieces == 677);  // of 1 ms
}

}  // namespace loads_test
