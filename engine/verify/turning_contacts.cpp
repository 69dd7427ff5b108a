// Contacts whose normal or whose other surface turns within a step: swings in a drum, and the turntable. Rows
// of the order of the scheme in the length of the step, from the error in place at two lengths.

#include <cmath>

#include "flight/run.h"
#include "math/elliptic.h"
#include "verify/check.h"

namespace flyrock {

namespace {

constexpr double fall = 9.81, lasts = 5;  // m/s2, s

struct Grip : FrictionLaw {
  bool constant() const override { return true; }
  std::string origin() const override { return "grip"; }
  Friction friction(Values, const ContactState&) const override { return {100, 100}; }
};

WorldSettings steps_of(double h) {
  WorldSettings settings;
  settings.time_step = h;
  settings.tolerance = 1e-12;
  return settings;
}

/// Runs until `lasts`. With grip nothing slips.
template <int D>
void run_with(World<D>& world, bool grip) {
  static const Grip law;
  PairLaws laws;
  if (grip) laws.friction.law = &law;
  world.laws_between = [&](int, int) { return &laws; };
  RunSettings settings;
  settings.stop_time = lasts;
  settings.stop_speed = 0;
  std::vector<BodyHistory> histories;
  run(world, settings, histories);
}

/// The error in place of a disk of 0.2 m in a drum of 1 m that starts at rest one radian from the bottom: a
/// pendulum of length R - r; if it rolls, with 2/3 of gravity [m].
double swing_error(double h, bool rolls) {
  constexpr double drum_radius = 1, radius = 0.2, arm = drum_radius - radius, start = 1;
  Profile floor;
  floor.points = {{-50, -20}, {50, -20}};
  floor.part = {0};
  floor.parts = {""};
  const Terrain2 terrain(floor);
  World<2> world(terrain, {0, -fall}, steps_of(h));
  const auto at = [&](double angle) -> Vec2 { return arm * Vec2(std::sin(angle), -std::cos(angle)); };
  Body<2> drum = make_body({Contactor2::hollow_disk(drum_radius, 1.1 * drum_radius)}, 0, 1, 0);
  drum.kind = BodyKind::fixed;
  world.add(drum);
  Body<2> disk = make_body({Contactor2::disk(radius)}, 0, 5, 0);
  disk.move_to(at(start), 0);
  world.add(disk);
  run_with(world, rolls);
  const double k = std::sin(0.5 * start), w = std::sqrt(fall / arm / (rolls ? 1.5 : 1));
  const auto [sn, cn, dn, third] = EllipticFunctions({k * k, 1 - k * k}, -1).at(w * lasts);
  return (world.bodies[1].x - at(2 * std::asin(k * cn / dn))).norm();
}

/// The error in place of a sphere that rolls on a turntable: it goes in circles at 2/7 of the spin of the
/// table (K. Weltner, American Journal of Physics 47, 1979) [m].
double turntable_error(double h) {
  constexpr double radius = 0.1, spin = 2, circles = 2.0 / 7 * spin;
  const Vec2 from(0.5, 0), v(0.3, 0.4);
  Plane floor;
  floor.point = {0, 0, -5};
  const Terrain3 terrain((TerrainShape3(floor)));
  World<3> world(terrain, {0, 0, -fall}, steps_of(h));
  Body<3> table = make_body({Contactor3::cylinder(3, 0.2)}, 1000, 0);
  table.kind = BodyKind::driven;
  table.x = {0, 0, -0.1};
  table.w = {0, 0, spin};
  world.add(table);
  Body<3> ball = make_body({Contactor3::sphere(radius)}, 0, 5);
  ball.x = {from.x(), from.y(), radius};
  ball.v = {v.x(), v.y(), 0};
  const Vec2 over = v - spin * Vec2(-from.y(), from.x());  // relative to the table below it
  ball.w = {-over.y() / radius, over.x() / radius, 0};
  world.add(ball);
  run_with(world, true);
  const Vec2 centre = from + Vec2(-v.y(), v.x()) / circles;
  const Vec2 end = centre + Rotation2::from_angle(circles * lasts) * Vec2(from - centre);
  return (world.bodies[1].x.head<2>() - end).norm();
}

/// Adds the order between steps of 2 ms and 0.5 ms.
template <class Error>
void check_order(Checks& checks, const std::string& name, double tolerance, const Error& error) {
  constexpr double coarse = 2e-3, fine = 5e-4;
  const double order = std::log(error(coarse) / error(fine)) / std::log(coarse / fine);
  checks.push_back(
      {name + ": order in the step", "run", order, 2, tolerance, std::abs(order - 2) <= tolerance});
}

}  // namespace

void check_turning_contacts(Checks& checks) {
  check_order(checks, "a disk swings in a drum without friction", 0.35,
              [](double h) { return swing_error(h, false); });
  check_order(checks, "a disk rolls in a drum", 0.35, [](double h) { return swing_error(h, true); });
  check_order(checks, "a sphere rolls on a turntable", 0.1, [](double h) { return turntable_error(h); });
}

}  // namespace flyrock
