// Pills on planes and on many triangles, against closed forms. All at the default settings.

#include <catch2/catch.hpp>

#include "analytic/lab_ground.h"
#include "geometry/ground.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace pill_3d_test {

namespace {

constexpr double gravity = 9.81;

/// A pill with its axis along `axis`.
Body<3> pill(double length, double radius, double mass, const Vec3& at, const Vec3& axis) {
  const Vec3 half = 0.5 * length * axis.normalized();
  Body<3> body = make_body({Contactor3::pill(-half, half, radius)}, 0, mass);
  body.x = at;
  return body;
}

/// I/(m r^2) about the axis.
double roundness(double length, double radius) {
  return (length / 2 + 8.0 / 15 * radius) / (length + 4.0 / 3 * radius);
}

TerrainShape3 surface(const Plane& plane, bool in_triangles) {
  if (in_triangles) return mesh_of(height_of(plane), 8, 23, 0.3);
  return plane;
}

}  // namespace

TEST_CASE("a pill across an incline rolls with g sin / (1 + k), or slips, on a plane as on many triangles") {
  const double slope = 25 * pi / 180, azimuth = 0.4, length = 0.7, radius = 0.2, mu = GENERATE(0.05, 0.5);
  const bool in_triangles = GENERATE(false, true);
  const Plane ground = plane(slope, azimuth);
  const Vec3 way = down(slope, azimuth), across = ground.normal.cross(way);
  Material material(0, mu);
  Bench3 bench(surface(ground, in_triangles), material);
  bench.add(pill(length, radius, 300, radius * ground.normal, across));
  const BodyHistory& history = bench.run(1.5);
  const double k = roundness(length, radius);
  const bool rolls = mu >= std::tan(slope) * k / (1 + k);
  CHECK(rolls == (mu > 0.1));
  const double a =
      rolls ? gravity * std::sin(slope) / (1 + k) : gravity * (std::sin(slope) - mu * std::cos(slope));
  const double alpha = rolls ? a / radius : mu * gravity * std::cos(slope) / (k * radius);
  CHECK((history.last.position - history.first.position - 0.5 * 1.5 * 1.5 * a * way).norm() < 1e-6);
  CHECK((history.last.spin - 1.5 * alpha * across).norm() < 1e-5);
}

TEST_CASE("a pill along an incline rests where friction holds it, and slides where it does not") {
  const double slope = 20 * pi / 180, length = 0.7, radius = 0.2, mu = GENERATE(0.5, 0.2);
  const bool in_triangles = GENERATE(false, true);
  const Plane ground = plane(slope);
  Material material(0, mu);
  Bench3 bench(surface(ground, in_triangles), material);
  bench.add(pill(length, radius, 300, radius * ground.normal, down(slope)));
  const BodyHistory& history = bench.run(1);
  const double a = std::max(0.0, gravity * (std::sin(slope) - mu * std::cos(slope)));
  CHECK((history.last.position - history.first.position - 0.5 * a * down(slope)).norm() < 1e-6);
  CHECK((a > 0 || history.reason == StopReason::stopped));
}

TEST_CASE("a thrown pill comes down on many triangles as on one plane") {
  const Plane ground = plane(15 * pi / 180, 0.3);
  std::array<Vec3, 2> places, spins;
  std::array<std::size_t, 2> impacts;
  for (const bool in_triangles : {false, true}) {
    Material material(0.3, 0.4);
    Bench3 bench(surface(ground, in_triangles), material);
    const int i = bench.add(pill(0.7, 0.2, 300, {-1, 0.5, 2}, {1, 2, 0.5}));
    bench.world.bodies[i].v = {2, -1, 0};
    bench.world.bodies[i].w = {2, 3, -1};
    const BodyHistory& history = bench.run(1);
    places[in_triangles] = history.last.position;
    spins[in_triangles] = history.last.spin;
    impacts[in_triangles] = history.impacts.size();
  }
  CHECK(impacts[0] >= 2);
  CHECK(impacts[0] == impacts[1]);
  CHECK((places[0] - places[1]).norm() < 1e-6);
  CHECK((spins[0] - spins[1]).norm() < 1e-5);
}

namespace {

double energy_of(const Body<3>& body) {
  const Vec3 w = body.attitude.rotation.inverse(body.w);
  return 0.5 * body.mass * body.v.squaredNorm() + 0.5 * w.dot(body.inertia.cwiseProduct(w)) +
         body.mass * gravity * body.x.z();
}

}  // namespace

TEST_CASE("pills thrown on rough ground come down without gain of energy, and stay above it") {
  const Height rough = [](double x, double y) {
    return 0.15 * std::sin(2.1 * x + 1) * std::cos(1.7 * y) - 0.3 * x;
  };
  for (unsigned seed = 1; seed <= 3; ++seed) {
    std::mt19937 rng(seed);
    std::uniform_real_distribution<double> random(-1, 1);
    Material material(0.4, 0.5, 0.02);
    Bench3 bench(mesh_of(rough, 8, 32, 0.3, seed), material);
    const int i = bench.add(
        pill(0.7, 0.2, 300, {random(rng) - 3, random(rng), 3}, {random(rng), random(rng), random(rng)}));
    Body<3>& body = bench.world.bodies[i];
    body.v = {3 * random(rng), 3 * random(rng), 0};
    body.w = {9 * random(rng), 9 * random(rng), 9 * random(rng)};
    const double before = energy_of(body);
    const BodyHistory& history = bench.run(2);
    CHECK(history.reason != StopReason::diverged);
    // The end of a pill that rocks about an edge of the ground meets the facet beside it in time.
    CHECK(bench.world.quality().max_penetration < 1e-5);
    CHECK(energy_of(bench.world.bodies[i]) < before);
    const Body<3>& last = bench.world.bodies[i];
    for (int k = 0; k <= 10; ++k) {
      const Vec3 place = last.x + last.attitude.rotation * (last.contactors[0].points[0] * (1 - k / 5.0));
      const auto nearest = bench.terrain.ground().nearest(place, 1);
      CHECK((!nearest || nearest->distance > 0.2 * (1 - 1e-3)));
    }
  }
}

TEST_CASE("a pill comes to rest in the valley of two fixed pills, and across two others") {
  const double radius = 0.2;
  for (const bool across : {false, true}) {
    Material material(0, 0.6, 0.01);
    Bench3 bench(plane(), material);
    const Vec3 along = across ? Vec3::UnitX() : Vec3::UnitY();
    bench.add(pill(0.8, radius, 300, {0, 0, 0.75}, along));
    for (const double x : {-0.25, 0.25}) {
      const int fixed = bench.add(pill(1, radius, 300, {x, 0, radius}, Vec3::UnitY()));
      bench.world.bodies[fixed].kind = BodyKind::fixed;
    }
    const BodyHistory& history = bench.run(3);
    const double height = radius + (across ? 2 * radius : std::sqrt(4 * radius * radius - 0.25 * 0.25));
    CHECK((history.last.position - Vec3(0, 0, height)).norm() < 1e-5);
    CHECK(history.reason == StopReason::stopped);
  }
}

TEST_CASE("a log that rolls and yaws keeps both ends down while its weight holds its gyroscopic moment") {
  // The moment I_a p W of the spins p about the axis and W about the vertical is held by loads that differ by
  // 2 I_a p W / L, as long as this is below m g; L is the length of the line on which the log lies. In half a
  // step one end rises by p W L h^2 / 16, many times what gravity would make of it.
  const double length = 1.2, radius = 0.15, yaw = 6, share = GENERATE(0.5, 0.9);
  const bool is_pill = GENERATE(true, false);
  Body<3> log = is_pill ? pill(length, radius, 300, {0, 0, radius}, Vec3::UnitX())
                        : make_body({Contactor3::cylinder(radius, length)}, 0, 300);
  if (!is_pill) log.attitude = Rotation3::from_vector({0, pi / 2, 0}) * log.attitude.rotation;
  log.x = {0, 0, radius};
  const double along = log.attitude.rotation.inverse(Vec3::UnitX()).cwiseAbs2().dot(log.inertia);
  const double roll = share * log.mass * gravity * length / (2 * along * yaw);
  log.v = {0.3, 0.2, 0};
  log.w = {roll, 0, yaw};
  Material material(0.3, 0);
  Bench3 bench(plane(), material);
  const int i = bench.add(log);
  const double time = 2, before = energy_of(log);
  const BodyHistory& history = bench.run(time);
  const Body<3>& last = bench.world.bodies[i];
  INFO((is_pill ? "pill" : "cylinder") << ", " << share << " of the greatest moment");
  const Vec3 axis(std::cos(yaw * time), std::sin(yaw * time), 0);
  // Of second order: the log turns by 0.1 rad about its axis in a step.
  CHECK((last.w - roll * axis - Vec3(0, 0, yaw)).norm() < 5e-3 * roll);
  CHECK((last.x - log.x - time * log.v).norm() < 1e-6);
  CHECK(energy_of(last) == Approx(before).epsilon(5e-5));
  CHECK(history.impacts.empty());
  CHECK(history.last.time == Approx(time));
  CHECK(bench.world.quality().max_penetration < 1e-4 * length);
}

}  // namespace pill_3d_test
