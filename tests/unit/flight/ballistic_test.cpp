// Flights of a point with and without air, against closed forms and the reference integration of the issue: a
// sphere of 0.1 m and 2700 kg/m3 with c_d 1 at 60 m/s and 45 degrees.

#include "flight/ballistic.h"

#include <catch2/catch.hpp>

#include "flight/shroud.h"
#include "geometry/profile.h"
#include "random/stream.h"
#include "unit/flight/vacuum_range.h"

using namespace flyrock;

namespace ballistic_test {

namespace {

constexpr double g = 9.81;
constexpr double day = 86400;  // s, longer than any flight

Profile level() {
  Profile ground;
  ground.points = {{-1e4, 0}, {1e4, 0}};
  ground.part = {0};
  ground.parts = {""};
  return ground;
}

Profile bench() {
  Profile ground;
  ground.points = {{-50, 12}, {0, 12}, {4.368, 0}, {600, 0}};
  ground.part = {0, 0, 0};
  ground.parts = {""};
  return ground;
}

double sphere_drag(double diameter, double cd) {
  const double volume = pi / 6 * std::pow(diameter, 3);
  return drag_constant(1.225, cd, 2700 * volume, volume);
}

Forces<2> air(double drag, double wind = 0) { return {{0, -g}, {drag, {wind, 0}}}; }

Vec2 launch(double speed, double degrees) {
  return speed * Vec2(std::cos(degrees * pi / 180), std::sin(degrees * pi / 180));
}

struct Flown : Landing<2> {
  double apex = 0;
  int arcs = 0;
};

Flown fly(const Forces<2>& forces, const Vec2& from, const Vec2& velocity, const Profile& ground) {
  Flown flown;
  static_cast<Landing<2>&>(flown) = land(
      BallisticFlight<2>(forces, from, velocity), ground, 1e3, [&](const Arc<2>& arc, const ArcEnd& end) {
        ++flown.arcs;
        for (int i = 0; i <= 1000; ++i) flown.apex = std::max(flown.apex, arc.position(end.s * i / 1000).y());
      });
  return flown;
}

/// The classical Runge-Kutta scheme in small steps, then the last one shortened to the ground by linear
/// interpolation.
Vec2 reference_landing(const Forces<2>& forces, Vec2 x, Vec2 v, double dt) {
  while (true) {
    const Vec2 a1 = forces.acceleration(v), v2 = v + dt / 2 * a1, a2 = forces.acceleration(v2),
               v3 = v + dt / 2 * a2, a3 = forces.acceleration(v3), v4 = v + dt * a3,
               a4 = forces.acceleration(v4);
    const Vec2 next = x + dt / 6 * (v + 2 * v2 + 2 * v3 + v4);
    if (next.y() < 0) return x + x.y() / (x.y() - next.y()) * (next - x);
    x = next;
    v += dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
}

}  // namespace

TEST_CASE("without air the flight is the parabola, landed on to rounding") {
  const Flown flown = fly(air(0), {0, 12}, launch(30, 30), level());
  CHECK(flown.position.x() == Approx(vacuum_range(30, pi / 6, 12, g)).epsilon(1e-13));
  CHECK(flown.velocity.norm() == Approx(std::sqrt(30 * 30 + 2 * g * 12)).epsilon(1e-13));
  CHECK(flown.arcs == 1);
}

TEST_CASE("Roth's ranges, and the best angle is not 45 degrees from a height") {
  const double v = 35.3167;
  CHECK(vacuum_range(v, pi / 4, 0, g) == Approx(127.1).epsilon(1e-3));
  CHECK(vacuum_range(v, pi / 4, 12, g) == Approx(138.18).epsilon(1e-4));
  CHECK(greatest_vacuum_range(v, 12, g) == Approx(138.62).epsilon(1e-4));
  CHECK(vacuum_range(v, best_vacuum_elevation(v, 12, g), 12, g) ==
        Approx(greatest_vacuum_range(v, 12, g)).epsilon(1e-14));
  const Farthest found = farthest(air(0), v, 12, day);
  CHECK(found.range == Approx(greatest_vacuum_range(v, 12, g)).epsilon(1e-7));
  CHECK(found.elevation == Approx(best_vacuum_elevation(v, 12, g)).margin(2e-4));
}

TEST_CASE("drag against the reference integration") {
  const Forces<2> forces = air(sphere_drag(0.1, 1));
  const Flown flown = fly(forces, {0, 0}, launch(60, 45), level());
  CHECK(flown.position.x() == Approx(197.893).epsilon(1e-5));
  CHECK(flown.time == Approx(7.1524).epsilon(1e-5));
  CHECK(flown.apex == Approx(63.326).epsilon(1e-5));
  CHECK(flown.velocity.norm() == Approx(35.924).epsilon(2e-5));
  const Flown high = fly(forces, {0, 12}, launch(60, 45), level());
  CHECK(high.position.x() == Approx(204.704).epsilon(1e-5));
  CHECK(high.time == Approx(7.5287).epsilon(1e-5));
  CHECK(high.velocity.norm() == Approx(37.412).epsilon(2e-5));
}

TEST_CASE("air matters below 0.3 m, and flattens the best angle") {
  struct Case {
    double diameter, cd, range, best;
  };
  for (const Case& c : {Case{0.05, 0.47, 203.0, 41},
                        {0.05, 1, 141.8, 38},
                        {0.1, 0.47, 257.4, 42},
                        {0.1, 1, 197.9, 40},
                        {0.3, 0.47, 319.4, 44},
                        {0.3, 1, 280.6, 43},
                        {1, 0.47, 351.0, 45},
                        {1, 1, 334.8, 44}}) {
    const Forces<2> forces = air(sphere_drag(c.diameter, c.cd));
    CHECK(fly(forces, {0, 0}, launch(60, 45), level()).position.x() == Approx(c.range).epsilon(5e-4));
    CHECK(farthest(forces, 60, 0, day).elevation * 180 / pi == Approx(c.best).margin(0.6));
  }
}

TEST_CASE("a falling rock tends to its terminal speed") {
  const Flown flown = fly(air(sphere_drag(0.1, 1)), {0, 5000}, {0, 0}, level());
  CHECK(flown.velocity.norm() == Approx(std::sqrt(4 * 2700 * g * 0.1 / (3 * 1.225))).epsilon(1e-6));
}

TEST_CASE("wind carries: in the frame of the air the flight is one in still air") {
  const double drag = sphere_drag(0.1, 1), wind = 12;
  const Flown windy = fly(air(drag, wind), {0, 0}, launch(60, 45), level());
  const Flown still = fly(air(drag), {0, 0}, launch(60, 45) - Vec2(wind, 0), level());
  CHECK(windy.time == Approx(still.time).epsilon(1e-6));
  CHECK(windy.position.x() == Approx(still.position.x() + wind * still.time).epsilon(1e-6));
}

TEST_CASE("flights in space: an azimuth turns the path, a cross wind drifts it") {
  const double drag = sphere_drag(0.1, 1);
  const Vec2 v = launch(60, 45);
  const auto at = [&](const Vec3& velocity, const Vec3& wind) {
    BallisticFlight<3> flight({{0, 0, -g}, {drag, wind}}, Vec3::Zero(), velocity);
    double time = 0;
    Vec3 place;
    while (time < 7) {
      const Arc<3> arc = flight.next(7 - time);
      time = arc.start + arc.length;
      place = arc.position(1);
    }
    return place;
  };
  const Vec3 ahead = at({v.x(), 0, v.y()}, Vec3::Zero()), left = at({0, v.x(), v.y()}, Vec3::Zero());
  CHECK((left - Vec3(0, ahead.x(), ahead.z())).norm() < 1e-9);
  CHECK(at({v.x(), 0, v.y()}, {0, 5, 0}).y() > 1);
}

TEST_CASE("no flight leaves the envelope, and it is touched") {
  double nearest = 1e9;
  for (double degrees = 1; degrees < 90; degrees += 0.25) {
    BallisticFlight<2> flight(air(0), Vec2::Zero(), launch(40, degrees));
    const Arc<2> arc = flight.next(10);
    for (int i = 1; i <= 200; ++i) {
      const Vec2 p = arc.position(i / 200.0);
      const double below = vacuum_envelope(40, p.x(), g) - p.y();
      REQUIRE(below > -1e-9);
      nearest = std::min(nearest, below);
    }
  }
  CHECK(nearest < 1e-3);
}

TEST_CASE(
    "the shroud: the closed form without air, and with little air nearly so, no flight in air leaves it") {
  const std::vector<Vec2> line = shroud(air(0), 40, 12, day, 41);
  REQUIRE(line.size() == 41);
  for (const Vec2& point : line) CHECK(point.y() == Approx(vacuum_envelope(40, point.x(), g)).margin(1e-6));
  CHECK(line.back().x() == Approx(greatest_vacuum_range(40, 12, g)).epsilon(1e-7));
  CHECK(line.back().y() == Approx(-12).margin(1e-3));
  const std::vector<Vec2> thin = shroud(air(1e-9), 40, 12, day, 41);
  for (std::size_t i = 0; i < line.size(); ++i) CHECK((thin[i] - line[i]).norm() < 1e-3 * line.back().x());
  const Forces<2> thick = air(0.02);
  const std::vector<Vec2> low = shroud(thick, 40, 0, day, 21);
  for (double degrees = 1.3; degrees < 90; degrees += 7)
    for (const Vec2& point : low) {
      BallisticFlight<2> flight(thick, Vec2::Zero(), launch(40, degrees));
      for (int i = 0; i < 20; ++i) {
        const Arc<2> arc = flight.next(1);
        if (const auto s = first_arrival(arc, point.x(), 1, 1); s && point.x() > arc.position(0).x())
          CHECK(arc.position(*s).y() < point.y() + 1e-3 * low.back().x());
      }
    }
  CHECK(low.back().x() < 0.7 * greatest_vacuum_range(40, 0, g));
  CHECK(shroud(thick, 0, 0, day, 21).empty());
}

TEST_CASE("landing on a bench: the face, the floor, and the end of the terrain") {
  const Profile ground = bench();
  const Flown face = fly(air(0), {0.2, 13}, {1, 0}, ground);
  CHECK(face.on_ground);
  CHECK(face.position.y() == Approx(12 - (face.position.x()) * 12 / 4.368).margin(1e-9));
  CHECK(fly(air(0), {-5, 13}, {1, 0}, ground).position.y() == Approx(12).margin(1e-12));
  const Flown away = fly(air(0), {-5, 13}, {-40, 20}, ground);
  CHECK(away.left);
  CHECK(away.position.x() == Approx(-50).margin(1e-9));
  const Flown leaving =
      fly(air(sphere_drag(0.3, 1)), {0, 12}, {10, 5}, ground);  // begins on the crest and rises
  CHECK(leaving.position.y() == Approx(0).margin(1e-9));
  const Landing<2> timed =
      land(BallisticFlight<2>(air(0), {0, 20}, {10, 0}), ground, 0.5, [](const Arc<2>&, const ArcEnd&) {});
  CHECK_FALSE(timed.on_ground);
  CHECK_FALSE(timed.left);
  CHECK(timed.time == 0.5);
}

TEST_CASE("a point meets a vertical wall, and a spike within one arc") {
  Profile wall = level();
  wall.points = {{-1e4, 0}, {50, 0}, {50, 30}, {50.01, 30}, {50.01, 0}, {1e4, 0}};
  wall.part = {0, 0, 0, 0, 0};
  const Flown hit = fly(air(0), {0, 0.1}, launch(60, 10), wall);
  CHECK(hit.position.x() == Approx(50).margin(1e-9));
}

TEST_CASE("shots over a bench against small steps") {
  const Profile ground = bench();
  RandomStream rng(1, "shots", {});
  double worst = 0;
  for (int i = 0; i < 50; ++i) {
    const Forces<2> forces = air(sphere_drag(rng.uniform(0.05, 1), 1));
    const Vec2 from(0, 12.5), velocity = launch(rng.uniform(10, 80), rng.uniform(5, 85));
    const Landing<2> landing =
        land(BallisticFlight<2>(forces, from, velocity), ground, 1e3, [](const Arc<2>&, const ArcEnd&) {});
    if (landing.on_ground && landing.position.x() > 5)
      worst = std::max(worst, (landing.position - reference_landing(forces, from, velocity, 1e-3)).norm());
  }
  CHECK(worst < 1e-4);  // the reference's last step is straight: g dt^2 / 8 and its slope
}

}  // namespace ballistic_test
