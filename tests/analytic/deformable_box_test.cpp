// Deformable blocks in 3D in the world: they rebound by their waves, rest, slide and turn.

#include <catch2/catch.hpp>

#include "analytic/lab_ground.h"
#include "elastic/elastic_block.h"
#include "unit/elastic/bounce.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace deformable_box_test {

namespace {

constexpr double young = 50e9, density = 2700;
const double sound = std::sqrt(young / density);

struct Rock {
  Vec3 size = Vec3::Ones();
  std::array<int, 3> cells{4, 4, 4};
  double poisson = 0.25, alpha = 0, beta = 0, theta = 0.5, stiffness = young;
};

/// A block of limestone for steps of length h.
Body<3> block_of(const Rock& rock, double h, const Vec3& at) {
  Body<3> body = make_body({Contactor3::box(rock.size)}, density, 0);
  const ElasticMaterial material{.young = rock.stiffness,
                                 .poisson = rock.poisson,
                                 .density = density,
                                 .alpha = rock.alpha,
                                 .beta = rock.beta};
  make_deformable<3>(
      body,
      std::make_shared<const ElasticBlock<3>>(bricked_box(rock.size, rock.cells), material, h, rock.theta),
      std::nullopt);
  body.x = at;
  return body;
}

WorldSettings steps_of(double h, double theta = 0.5) {
  WorldSettings settings;
  settings.time_step = h;
  settings.theta = theta;
  return settings;
}

/// All that the energy of a block and its contacts goes to [J].
double balance(const World<3>& world) {
  const Deformation<3>& own = world.bodies[0].deformation;
  return world.total_energy() + own.damped + own.touch + own.settled;
}

}  // namespace

TEST_CASE("a deformable cube that falls flat rebounds as the small program of its scheme does") {
  for (const double poisson : {0.0, 0.25}) {
    const double h = 0.25 / sound;
    const Rock rock{.poisson = poisson};
    const double rebound =
        test::bounce(block_of(rock, h, Vec3::Zero()).deformation.block->model, h, 1, 0).rebound;
    for (const double height : {0.0, 1e-5, 0.0123}) {
      Material material(0.5, 0);
      Bench3 bench(plane(), material, steps_of(h), Vec3::Zero());
      Body<3> block = block_of(rock, h, {0, 0, 0.5 + height});
      block.v = {0, 0, -1};
      bench.add(std::move(block));
      const double start = balance(bench.world);
      bench.run(height + 0.002);
      const Body<3>& end = bench.world.bodies[0];
      CHECK(end.v.z() == Approx(rebound).epsilon(1e-5));
      CHECK(end.v.head<2>().norm() + end.w.norm() < 1e-9);
      CHECK(balance(bench.world) == Approx(start).epsilon(1e-9));
      CHECK(end.deformation.touch > 0);
    }
  }
}

TEST_CASE("the energy of a tumbling deformable box closes with what damping, contacts and rest take") {
  for (const double theta : {0.5, 0.6}) {
    const double h = 0.1 / sound;
    Material material(0.5, 0.4);
    Bench3 bench(plane(0.3), material, steps_of(h, theta));
    Body<3> block =
        block_of({.size = {1, 0.6, 0.4}, .cells = {4, 3, 2}, .beta = 2e-6, .theta = theta}, h, {0, 0, 0.9});
    block.attitude = Rotation3::from_vector({0.4, -0.3, 0.6});
    block.v = {3, 0.5, -2};
    block.w = {-4, 5, 3};
    bench.add(std::move(block));
    const double start = balance(bench.world);
    double lost = 0, error = 0;
    bool grows = false;
    bench.run_settings.advanced = [&](double) {
      const Deformation<3>& own = bench.world.bodies[0].deformation;
      const double now = own.damped + own.touch + own.settled;
      grows = grows || now < lost - 1e-9 * start;
      lost = now;
      error = std::max(error, std::abs(balance(bench.world) - start) / start);
    };
    bench.run(0.4);
    CHECK(error < 1e-9);
    CHECK_FALSE(grows);
    const Deformation<3>& own = bench.world.bodies[0].deformation;
    CHECK(own.damped > 0);
    CHECK(own.touch > 0);
    CHECK(bench.world.quality().energy_gains == 0);
  }
}

TEST_CASE("a vibrating box turns a hundred times in the air, and keeps its vibration") {
  for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(0.48, 0.6, 0.64)}) {
    const double h = 0.1 / sound;
    Material material(0.5, 0.4);
    Bench3 bench(plane(), material, steps_of(h), Vec3::Zero());
    Body<3> block = block_of({.size = {1, 0.6, 0.4}, .cells = {3, 2, 1}}, h, {0, 0, 20});
    block.w = 200 * pi / (5000 * h) * axis;
    Eigen::VectorXd& rate = block.deformation.rate;
    for (Eigen::Index i = 0; i < rate.size(); ++i) rate[i] = std::sin(static_cast<double>(i * i % 17));
    block.deformation.block->model.drop_rigid_motion(rate);
    bench.add(std::move(block));
    const Body<3>& body = bench.world.bodies[0];
    const auto momentum = [&]() -> Vec3 {
      return body.attitude.rotation * body.inertia.cwiseProduct(body.attitude.rotation.inverse(body.w));
    };
    const double start = bench.world.total_energy();
    const Vec3 first = momentum();
    for (int n = 0; n < 5000; ++n) bench.world.step(h, false);
    if (axis.z() == 1) CHECK(body.attitude.rotation.vector().norm() < 1e-9);
    CHECK((momentum() - first).norm() < 1e-3 * first.norm());
    CHECK(momentum().norm() == Approx(first.norm()).epsilon(1e-10));
    CHECK(bench.world.total_energy() == Approx(start).epsilon(1e-10));
  }
}

TEST_CASE("a deformable cube at rest presses with its weight and is as much lower as the weight makes it") {
  const double h = 1e-3;
  Material material(0, 0.6);
  Bench3 bench(plane(), material, steps_of(h));
  bench.add(block_of({.poisson = 0, .beta = 1e-5}, h, {0, 0, 0.5}));
  for (int n = 0; n < 900; ++n) bench.world.step(h, false);
  const Vec3 before = bench.world.bodies[0].x;
  for (int n = 0; n < 100; ++n) bench.world.step(h, false);
  double force = 0;
  for (const auto& contact : bench.world.contacts()) force += contact.impulse[0] / h;
  CHECK(force == Approx(density * 9.81).epsilon(1e-6));
  const Body<3>& block = bench.world.bodies[0];
  CHECK((block.x - before).norm() < 1e-9);
  double low = 0, high = 0;
  for (const Contactor3& node : block.contactors) {
    low = std::min(low, node.points.front().z());
    high = std::max(high, node.points.front().z());
  }
  CHECK(1 - (high - low) == Approx(density * 9.81 / (2 * young)).epsilon(0.05));
}

TEST_CASE("a deformable cube on an incline slides and sticks as a rigid one does") {
  for (const double share : {0.99, 1.01}) {
    const double h = 1e-3, slope = 0.3, azimuth = 0.7, mu = std::tan(slope) * share;
    Material material(0, mu);
    const double theta = 0.6;  // damps what vibrates faster than a step, and then slips while it presses less
    Bench3 bench(plane(slope, azimuth), material, steps_of(h, theta));
    const Vec3 up(std::sin(slope) * std::cos(azimuth), std::sin(slope) * std::sin(azimuth), std::cos(slope));
    const Vec3 down = (up.z() * up - Vec3::UnitZ()).normalized();
    Body<3> block = block_of({.cells = {3, 3, 3}, .theta = theta}, h, 0.5 * up);
    block.attitude = Rotation3(Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), up));
    bench.add(std::move(block));
    for (int n = 0; n < 500; ++n) bench.world.step(h, false);
    const Body<3>& end = bench.world.bodies[0];
    const double before = end.v.dot(down);
    const Vec3 place = end.x;
    for (int n = 0; n < 500; ++n) bench.world.step(h, false);
    const double slides = 9.81 * std::cos(slope) * (std::tan(slope) - mu);
    if (share < 1)
      CHECK((end.v.dot(down) - before) / (500 * h) == Approx(slides).epsilon(0.01));
    else
      CHECK((end.x - place).norm() < 1e-9);
  }
}

TEST_CASE("a corner of the ground that enters a deformable block between its nodes is a penetration") {
  // A pyramid 1 cm high under the middle of a brick, which no node is over
  Mesh peak;
  peak.vertices = {{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}, {0.02, 0.03, 0.01}};
  peak.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  peak.part = {0, 0, 0, 0};
  peak.parts = {""};
  const double h = 1e-3;
  Material material(0, 0.6);
  Bench3 bench(TerrainShape3(peak), material, steps_of(h));
  bench.add(block_of({.cells = {1, 1, 1}, .beta = 1e-5}, h, {0, 0, 0.5}));
  bench.world.step(h, false);
  CHECK(bench.world.quality().max_penetration == Approx(0.01).epsilon(0.01));
}

}  // namespace deformable_box_test
