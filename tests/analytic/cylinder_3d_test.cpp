// Cylinders on planes and on many triangles, against closed forms. All at the default settings.

#include <catch2/catch.hpp>

#include "analytic/lab_ground.h"
#include "geometry/cone.h"
#include "geometry/ground.h"
#include "samples.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace cylinder_3d_test {

namespace {

constexpr double gravity = 9.81;

/// A rotation that takes z to the direction of `axis`.
Rotation3 from_z_to(const Vec3& axis) {
  const Eigen::Matrix3d frame = contact_frame(axis.normalized());
  Eigen::Matrix3d axes;
  axes << frame.col(2), frame.col(1), frame.col(0);
  return Rotation3(axes);
}

/// A cylinder with its axis along `axis`.
Body<3> cylinder(double radius, double height, const Vec3& at, const Vec3& axis) {
  Body<3> body = make_body({Contactor3::cylinder(radius, height)}, 2700, 0);
  body.x = at;
  body.attitude = from_z_to(axis);
  return body;
}

TerrainShape3 surface(const Plane& plane, bool in_triangles) {
  if (in_triangles) return mesh_of(height_of(plane), 8, 23, 0.3);
  return plane;
}

double energy_of(const Body<3>& body) { return body.kinetic_energy() + body.mass * gravity * body.x.z(); }

Vec3 axis_of(const Body<3>& body) { return body.attitude.rotation * Vec3::UnitZ(); }

}  // namespace

TEST_CASE("a cylinder across an incline rolls with 2/3 g sin, or slips, on a plane as on many triangles") {
  const double slope = 25 * pi / 180, azimuth = 0.4, radius = 0.2, mu = GENERATE(0.05, 0.5);
  const bool in_triangles = GENERATE(false, true);
  const Plane ground = plane(slope, azimuth);
  const Vec3 way = down(slope, azimuth), across = ground.normal.cross(way);
  Material material(0, mu);
  Bench3 bench(surface(ground, in_triangles), material);
  bench.add(cylinder(radius, 0.7, radius * ground.normal, across));
  const BodyHistory& history = bench.run(1.5);
  const bool rolls = mu >= std::tan(slope) / 3;
  CHECK(rolls == (mu > 0.1));
  const double a =
      rolls ? 2.0 / 3 * gravity * std::sin(slope) : gravity * (std::sin(slope) - mu * std::cos(slope));
  const double alpha = rolls ? a / radius : 2 * mu * gravity * std::cos(slope) / radius;
  CHECK((history.last.position - history.first.position - 0.5 * 1.5 * 1.5 * a * way).norm() < 1e-6);
  CHECK((history.last.spin - 1.5 * alpha * across).norm() < 1e-5);
  CHECK(bench.world.quality().max_penetration < 1e-8);
}

TEST_CASE("a cylinder falls flat on its end and on its side, and rests without sinking") {
  const double radius = 0.25, height = 0.6;
  const bool on_end = GENERATE(true, false), in_triangles = GENERATE(false, true);
  Material material(0.3, 0.6);
  Bench3 bench(surface(plane(), in_triangles), material);
  bench.add(cylinder(radius, height, {0.1, 0.2, 1}, on_end ? Vec3::UnitZ() : Vec3::UnitX()));
  const BodyHistory& history = bench.run(3);
  CHECK(history.reason == StopReason::stopped);
  CHECK(history.last.position.z() == Approx(on_end ? height / 2 : radius).margin(1e-7));
  CHECK((history.last.position - Vec3(0.1, 0.2, history.last.position.z())).norm() < 1e-7);
  CHECK(bench.world.quality().max_penetration < 1e-6 * radius);
}

TEST_CASE("a tilted cylinder that is dropped on its rim comes to rest on its end or side without sinking") {
  const double radius = 0.25, height = GENERATE(0.1, 0.3, 1.0), tilt = GENERATE(0.2, 0.7, 1.3);
  const bool in_triangles = GENERATE(false, true);
  Material material(0.3, 0.6, 0.005);
  Bench3 bench(surface(plane(), in_triangles), material);
  const int i = bench.add(cylinder(radius, height, {0.1, 0.2, 1}, {std::sin(tilt), 0.3, std::cos(tilt)}));
  const double before = energy_of(bench.world.bodies[i]);
  const BodyHistory& history = bench.run(8);
  INFO("height " << height << ", tilt " << tilt << ", triangles " << in_triangles);
  CHECK(history.reason == StopReason::stopped);
  const double up = std::abs(axis_of(bench.world.bodies[i]).z());
  CHECK(std::min(up, 1 - up) < 1e-6);
  CHECK(history.last.position.z() == Approx(up > 0.5 ? height / 2 : radius).margin(1e-6));
  CHECK(bench.world.quality().max_penetration < 2e-4 * radius);
  CHECK(energy_of(bench.world.bodies[i]) < before);
}

TEST_CASE("a standing cylinder topples where the slope exceeds the angle atan(d/h)") {
  const double radius = 0.2, height = 0.8, limit = std::atan(2 * radius / height);
  const double azimuth = GENERATE(0.0, 0.3, 0.8), share = GENERATE(0.99, 1.01);
  const double slope = share * limit;
  const Plane ground = plane(slope, azimuth);
  Material material(0, 2);
  Bench3 bench(ground, material);
  const int i = bench.add(cylinder(radius, height, 0.5 * height * ground.normal, ground.normal));
  bench.run(1.5);
  INFO("azimuth " << azimuth << ", share " << share);
  const bool stands = axis_of(bench.world.bodies[i]).dot(ground.normal) > 1 - 1e-6;
  CHECK(stands == (share < 1));
}

TEST_CASE("a disk rolls steadily on its rim about a centre at rest at the rate of theory") {
  // The spin is along the line from the centre to the contact, and
  //   Omega^2 = m g rho / (sin a (I_t cos a - I_a H/(2 R) sin a)), rho = R cos a - H/2 sin a.
  const double radius = 0.3, height = GENERATE(0.01, 0.1), tilt = GENERATE(0.3, 0.8);
  const Vec3 axis(std::sin(tilt), 0, std::cos(tilt)), out(std::cos(tilt), 0, -std::sin(tilt));
  const Vec3 lever = radius * out - 0.5 * height * axis;
  Body<3> disk = cylinder(radius, height, {0, 0, -lever.z()}, axis);
  const double across = disk.inertia.x(), along = disk.inertia.z();
  const double rate = std::sqrt(
      disk.mass * gravity * lever.x() /
      (std::sin(tilt) * (across * std::cos(tilt) - along * height / (2 * radius) * std::sin(tilt))));
  disk.w = -rate * std::sin(tilt) * (out - height / (2 * radius) * axis);
  Material material(0, 0.8);
  Bench3 bench(plane(), material);
  const int i = bench.add(disk);
  const double time = 1, before = energy_of(disk);
  bench.run(time);
  const Body<3>& last = bench.world.bodies[i];
  INFO("height " << height << ", tilt " << tilt);
  CHECK((last.x - disk.x).norm() < 1e-3 * radius);
  CHECK(std::acos(axis_of(last).z()) == Approx(tilt).epsilon(1e-3));
  const double azimuth = std::atan2(axis_of(last).y(), axis_of(last).x());
  const double error = std::remainder(azimuth - rate * time, 2 * pi);
  CHECK(std::abs(error) < 2e-3 * rate * time);
  CHECK(energy_of(last) == Approx(before).epsilon(1e-3));
  CHECK(bench.world.quality().max_penetration < 1e-6);
}

TEST_CASE("cylinders thrown on rough ground come down without gain of energy, and stay above it", "[slow]") {
  const Height rough = [](double x, double y) {
    return 0.15 * std::sin(2.1 * x + 1) * std::cos(1.7 * y) - 0.3 * x;
  };
  for (unsigned seed = 1; seed <= 2; ++seed) {
    std::mt19937 rng(seed);
    std::uniform_real_distribution<double> random(-1, 1);
    Material material(0.4, 0.5, 0.02);
    Bench3 bench(mesh_of(rough, 8, 32, 0.3, seed), material);
    const int i = bench.add(cylinder(0.3, 0.25 * seed, {random(rng) - 3, random(rng), 3},
                                     {random(rng), random(rng), random(rng)}));
    Body<3>& body = bench.world.bodies[i];
    body.v = {3 * random(rng), 3 * random(rng), 0};
    body.w = {9 * random(rng), 9 * random(rng), 9 * random(rng)};
    const double before = energy_of(body);
    const BodyHistory& history = bench.run(1.5);
    CHECK(history.reason != StopReason::diverged);
    CHECK(bench.world.quality().max_penetration < 1e-4);
    const Body<3>& last = bench.world.bodies[i];
    CHECK(energy_of(last) < before);
    for (const Contactor3::Circle& circle : last.contactors[0].circles)
      for (int k = 0; k < 24; ++k) {
        const Vec3 out(std::cos(k * pi / 12), std::sin(k * pi / 12), 0);
        CHECK(bench.terrain.ground().depth(last.pose() * (circle.centre + circle.radius * out)) < 1e-4);
      }
  }
}

TEST_CASE("a cylinder comes to rest in the valley of two fixed cylinders, on a box, and carries a box") {
  const double radius = 0.2;
  Material material(0, 0.6, 0.01);
  Bench3 bench(plane(), material);
  const auto fix = [&](int i) { bench.world.bodies[i].kind = BodyKind::fixed; };
  bench.add(cylinder(radius, 0.8, {0, 0, 0.75}, Vec3::UnitY()));
  for (const double x : {-0.25, 0.25}) fix(bench.add(cylinder(radius, 1, {x, 0, radius}, Vec3::UnitY())));
  const int on_box = bench.add(cylinder(0.3, 0.4, {3, 0.1, 1.3}, Vec3::UnitZ()));
  fix(bench.add(box({1, 1, 1}, 1000, {3, 0, 0.5})));
  const int carried = bench.add(box({1, 0.8, 0.2}, 300, {6, 0, 0.8}));
  bench.add(cylinder(0.2, 0.5, {6, 0.1, 0.25}, Vec3::UnitZ()));
  const BodyHistory& history = bench.run(3);
  const double height = radius + std::sqrt(4 * radius * radius - 0.25 * 0.25);
  CHECK((history.last.position - Vec3(0, 0, height)).norm() < 1e-5);
  CHECK((bench.world.bodies[on_box].x - Vec3(3, 0.1, 1.2)).norm() < 1e-5);
  CHECK((bench.world.bodies[carried].x - Vec3(6, 0, 0.6)).norm() < 1e-5);
  for (const int i : {0, on_box, carried}) CHECK(bench.histories[i].reason == StopReason::stopped);
}

TEST_CASE("a cone rolls around its point on a level plane, and is back after a turn") {
  // It turns about the line on which it lies, with the spin Omega cot b; b is half the angle at the point.
  const double radius = 0.2, height = 0.5, b = std::atan(radius / height), rate = 2;
  Body<3> body = make_body({cone(radius, height)}, 2700, 0);
  const Vec3 axis(-std::cos(b), 0, -std::sin(b));  // to the point, at the origin
  body.x = -0.75 * height * axis;
  body.attitude = from_z_to(axis) * body.attitude.rotation;
  body.w = Vec3(-rate / std::tan(b), 0, 0);
  body.v = body.w.cross(body.x);
  Material material(0, 0.8);
  Bench3 bench(plane(), material);
  const int i = bench.add(body);
  bench.run(2 * pi / rate);
  const Body<3>& last = bench.world.bodies[i];
  CHECK((last.x - body.x).norm() < 1e-3 * height);
  CHECK(last.x.z() == Approx(body.x.z()).margin(1e-7));
  CHECK(energy_of(last) == Approx(energy_of(body)).epsilon(1e-5));
}

TEST_CASE("the place where an edge crosses a rim stays there, however flat the cap lies on the edge") {
  // The place of the rim that is farthest along the normal n would move by R/s |w| for the angle s between n
  // and the axis, here with 34 m/s and more. What a step adds for it threw the cylinder.
  std::mt19937 rng(7);
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(rng); };
  const Height ridge = [](double, double y) { return -0.6 * std::abs(y); };
  for (int i = 0; i < samples(10); ++i) {
    CAPTURE(i);
    Material material(0.5, 0.6);
    Bench3 bench(mesh_of(ridge, 4, 8), material);
    const Vec3 axis = Vec3(uniform(-0.02, 0.02), uniform(-0.3, 0.3), 1).normalized();
    Body<3> body = cylinder(0.2, 0.4, {uniform(-1, 1), uniform(-0.15, 0.15), 0.3}, axis);
    body.v = {uniform(-0.5, 0.5), uniform(-0.1, 0.1), -0.3};
    body.w = {uniform(-3, 3), uniform(-3, 3), uniform(-3, 3)};
    const double start = energy_of(body);
    bench.add(body);
    double most = -1e300;
    bench.run_settings.advanced = [&](double) { most = std::max(most, energy_of(bench.world.bodies[0])); };
    bench.run(0.6);
    CHECK(most < start * (1 + 1e-6));
    CHECK(bench.world.quality().energy_gains == 0);
  }
}

}  // namespace cylinder_3d_test
