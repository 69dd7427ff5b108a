// One surface given in several ways moves a body in one way: as a plane, as triangles, as a grid of heights,
// as a profile in 2D, and turned about the vertical.
#include <catch2/catch.hpp>

#include "analytic/lab_ground.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace {

std::vector<Impact> impacts_on(const TerrainShape3& shape, const Body<3>& body, double e_n, double mu,
                               double seconds) {
  Material material(e_n, mu);
  Bench3 bench(shape, material);
  bench.add(body);
  bench.run_settings.stop_speed = 0;
  return bench.run(seconds).impacts;
}

Body<3> thrown(int kind) {
  Body<3> body = body_of_kind(kind, 0.4);
  body.x = {-3.1, 1.7, 2.5};
  body.v = {2.5, -1, 1};
  body.w = {1, 2, -1};
  body.attitude = Attitude<3>(Rotation3::from_vector({0.3, 0.5, -0.2}) * body.attitude.rotation);
  return body;
}

}  // namespace

TEST_CASE("a plane, 20,000 random triangles in it and a grid of its heights give the same impacts") {
  const int kind = GENERATE(0, 1, 2);
  CAPTURE(kind);
  const Plane slope = plane(0.15, 0.4);
  // A polyhedron tumbles, which multiplies what rounding changes at each impact; the more, the higher it
  // bounces.
  const double e_n = kind == 0 ? 0.7 : 0.5;
  const auto expected = impacts_on(slope, thrown(kind), e_n, 0.3, 6);
  check_equal(expected, impacts_on(mesh_of(height_of(slope), 30, 100, 0.3), thrown(kind), e_n, 0.3, 6), 10,
              1e-9);
  check_equal(expected, impacts_on(grid_of(height_of(slope), 30, 100), thrown(kind), e_n, 0.3, 6), 10, 1e-9);
}

TEST_CASE("a sphere on a profile extended along y meets it as a disk meets the profile") {
  Profile profile;
  profile.points = {{-30, 6},   {-4, 2.5}, {-1, 1.4}, {0.5, 1.6}, {2, 0},
                    {3.1, 0.2}, {6, -2},   {9, -2.3}, {40, -4}};
  profile.part.assign(profile.points.size() - 1, 0);
  profile.parts = {""};
  Material material(0.5, 0);
  Bench in_2d(profile, material);
  in_2d.add(disk(0.4, 100, {-3, 4}, {2, 0.5}));
  in_2d.run_settings.stop_speed = 0;
  const auto expected = in_2d.run(8).impacts;
  Body<3> ball = sphere(0.4, 100, {-3, 0.123, 4}, {2, 0, 0.5});
  auto found = impacts_on(extruded(profile, 5, 7), ball, 0.5, 0, 8);
  for (Impact& impact : found) {
    CHECK(std::abs(impact.place.y() - 0.123) < 1e-9);
    impact.place = {impact.place.x(), impact.place.z(), 0};
  }
  auto unsigned_slip = expected;
  for (Impact& impact : unsigned_slip) {
    impact.vt_before = std::abs(impact.vt_before);
    impact.vt_after = std::abs(impact.vt_after);
  }
  check_equal(unsigned_slip, found, 10, 1e-9);
}

TEST_CASE("on ground turned about the vertical, a body moves as before, turned") {
  const int kind = GENERATE(0, 1, 2);
  CAPTURE(kind);
  constexpr double angle = 37 * pi / 180;
  const Rotation3 turn = Rotation3::from_vector({0, 0, angle});
  const Mesh mesh = mesh_of(rough(3, 0.6), 30, 60, 0.2);
  const Body<3> straight = [&] {
    Body<3> body = thrown(kind);
    body.x.z() += 2;
    return body;
  }();
  Body<3> turned = straight;
  turned.x = turn * straight.x;
  turned.v = turn * straight.v;
  turned.w = turn * straight.w;
  turned.attitude = Attitude<3>(turn * straight.attitude.rotation);
  check_equal(impacts_on(mesh, straight, 0.5, 0.4, 6),
              impacts_on(turned_about_z(mesh, angle), turned, 0.5, 0.4, 6), kind == 0 ? 10 : 6, 1e-9, turn);
}

TEST_CASE("a body slides over 10,000 triangles of a plane as over the plane") {
  const int kind = GENERATE(0, 1, 2);
  CAPTURE(kind);
  const Plane slope = plane(0.2, 0.3);
  Body<3> body = body_of_kind(kind, 0.3);
  if (kind == 2) body.attitude = Attitude<3>();
  // Just above the ground, with its lowest point.
  double lowest = 1e300;
  for (const Vec3& p : body.contactors[0].points)
    lowest = std::min(lowest, slope.normal.dot(body.attitude.rotation * p) - body.contactors[0].radius);
  if (kind == 1) {
    const Vec3 way = down(0.2, 0.3);
    body = box({0.45, 0.33, 0.27}, 100, Vec3::Zero(), way, slope.normal);
    lowest = -0.135;
  }
  body.x = slope.height(-8, -2) * Vec3::UnitZ() + Vec3(-8, -2, 0) - lowest * slope.normal;
  body.v = 3 * down(0.2, 0.3);
  const auto end = [&](const TerrainShape3& shape) {
    Material material(0.2, 0.25);
    Bench3 bench(shape, material);
    bench.add(body);
    bench.run_settings.stop_speed = 0;
    bench.run(2);
    CHECK(bench.histories[0].reason == StopReason::timed_out);
    return bench.world.bodies[0].x;
  };
  const Vec3 expected = end(slope);
  // The polyhedron starts on a corner and tumbles before it slides: what rounding changes grows with its
  // impacts.
  const double margin = kind == 2 ? 1e-5 : 1e-9;
  CHECK((end(mesh_of(height_of(slope), 15, 71, 0.3)) - expected).norm() < margin);
  CHECK((end(grid_of(height_of(slope), 15, 71)) - expected).norm() < margin);
}
