// Deformable blocks in the world: they rebound by their waves, rest, slide and turn.

#include <catch2/catch.hpp>

#include "analytic/lab.h"
#include "elastic/elastic_block.h"
#include "elastic/stress_share.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace deformable_test {

namespace {

constexpr double young = 50e9, density = 2700;
const double sound = std::sqrt(young / density);

struct Rock {
  double poisson = 0.25, alpha = 0, beta = 0, theta = 0.5, stiffness = young;
  int cells = 10;
};

/// A square of 1 m of limestone, of which a step is `courant` times a cell divided by the speed of sound.
Body<2> square(const Rock& rock, double h, const Vec2& at, double angle = 0) {
  Body<2> body =
      make_body({Contactor2::polygon({{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})}, density, 0, 1);
  const ElasticMaterial material{.young = rock.stiffness,
                                 .poisson = rock.poisson,
                                 .density = density,
                                 .alpha = rock.alpha,
                                 .beta = rock.beta};
  make_deformable<2>(body,
                     std::make_shared<const ElasticBlock<2>>(
                         crossed_rectangle({1, 1}, {rock.cells, rock.cells}), material, h, rock.theta),
                     std::nullopt);
  body.move_to(at, angle);
  return body;
}

WorldSettings steps_of(double h) {
  WorldSettings settings;
  settings.time_step = h;
  return settings;
}

/// All that the energy of a block and its contacts goes to [J].
double balance(const World<2>& world) {
  const Deformation<2>& own = world.bodies[0].deformation;
  return world.total_energy() + own.damped + own.touch + own.settled;
}

}  // namespace

TEST_CASE("a deformable square that falls flat rebounds by its waves, from any height and whatever e_n") {
  for (const double poisson : {0.0, 0.25})
    for (const double height : {0.0, 1e-5, 0.0123}) {
      const double h = 0.1 / sound;
      Material material(0.5, 0);
      Bench bench(ground(5), material, steps_of(h), Vec2::Zero());
      Body<2> block = square({.poisson = poisson}, h, {0, 0.5 + height});
      block.v = {0, -1};
      bench.add(std::move(block));
      const double start = balance(bench.world);
      bench.run(height + 0.002);
      const Body<2>& end = bench.world.bodies[0];
      CHECK(end.v.y() == Approx(poisson == 0 ? 0.911201 : 0.825063).epsilon(1e-5));
      CHECK(std::abs(end.v.x()) + std::abs(end.w) < 1e-9);
      if (poisson > 0) CHECK(bench.world.total_energy() / start == Approx(0.935374).epsilon(1e-5));
      CHECK(balance(bench.world) == Approx(start).epsilon(1e-9));
      CHECK(end.deformation.touch > 0);
    }
}

TEST_CASE("a block that is too stiff for its step stops as a rigid one") {
  const double transits = 1e4, h = 1.0 / sound * transits;
  Material material(0.5, 0);
  Bench bench(ground(5), material, steps_of(h), Vec2::Zero());
  Body<2> block = square({.cells = 20}, h, {0, 0.5});
  const double speed = 1e-6 / h;
  block.v = {0, -speed};
  bench.add(std::move(block));
  double impulse = 0;
  for (int n = 0; n < 40; ++n) {
    bench.world.step(h, false);
    for (const auto& contact : bench.world.contacts()) impulse += contact.impulse[0];
  }
  CHECK(std::abs(bench.world.bodies[0].v.y()) < 2e-6 * speed);
  CHECK(impulse == Approx(density * speed).epsilon(2e-6));
}

TEST_CASE("the energy of a tumbling deformable block closes with what damping, contacts and rest take") {
  const double h = 0.25 / sound;
  Material material(0.5, 0.4);
  Bench bench(ground(50, 0.3), material, steps_of(h));
  Body<2> block = square({.beta = 2e-6, .cells = 4}, h, {0, 0.9}, 0.4);
  block.v = {3, -2};
  block.w = -4;
  bench.add(std::move(block));
  const double start = balance(bench.world);
  double lost = 0, error = 0;
  bool grows = false;
  bench.run_settings.advanced = [&](double) {
    const Deformation<2>& own = bench.world.bodies[0].deformation;
    const double now = own.damped + own.touch + own.settled;
    grows = grows || now < lost - 1e-9 * start;
    lost = now;
    error = std::max(error, std::abs(balance(bench.world) - start) / start);
  };
  bench.run(0.6);
  CHECK(error < 1e-9);
  CHECK_FALSE(grows);
  const Deformation<2>& own = bench.world.bodies[0].deformation;
  CHECK(own.damped > 0);
  CHECK(own.touch > 0);
  CHECK(bench.world.quality().energy_gains == 0);
}

TEST_CASE(
    "a node that slides while its block turns gains energy of the order of the step, which is no fault") {
  double last = 0;
  for (const double courant : {1.0, 0.5, 0.25}) {
    const double h = courant * 0.05 / sound;
    Material material(0, 0);
    Bench bench(ground(5), material, steps_of(h), Vec2::Zero());
    Body<2> block = square({.cells = 20}, h, {0, 0.58}, 10 * pi / 180);
    block.v = {0, -1};
    bench.add(std::move(block));
    double touch = 0, gained = 0;
    while (bench.world.time < 0.002) {
      bench.world.step(h, false);
      const double now = bench.world.bodies[0].deformation.touch;
      gained += std::max(0.0, touch - now);
      touch = now;
    }
    if (courant == 1) CHECK(gained == Approx(0.0104).epsilon(0.01));
    if (last > 0) CHECK(gained == Approx(last / 2).epsilon(0.02));
    last = gained;
    CHECK(bench.world.quality().energy_gains == 0);
  }
}

TEST_CASE("a vibrating block turns a hundred times in the air, and keeps its vibration") {
  const double h = 0.25 / sound;
  Material material(0.5, 0.4);
  Bench bench(ground(50), material, steps_of(h), Vec2::Zero());
  Body<2> block = square({.cells = 4}, h, {0, 20});
  block.w = 200 * pi / (2000 * h);
  Eigen::VectorXd& rate = block.deformation.rate;
  for (Eigen::Index i = 0; i < rate.size(); ++i) rate[i] = std::sin(static_cast<double>(i * i % 17));
  block.deformation.block->model.drop_rigid_motion(rate);
  bench.add(std::move(block));
  const double start = bench.world.total_energy(), spin = bench.world.bodies[0].w;
  for (int n = 0; n < 2000; ++n) bench.world.step(h, false);
  CHECK(bench.world.bodies[0].attitude.angle == Approx(200 * pi).epsilon(1e-10));
  CHECK(bench.world.bodies[0].w == spin);
  CHECK(bench.world.total_energy() == Approx(start).epsilon(1e-12));
}

TEST_CASE(
    "a deformable block at rest presses with its weight and is as much shorter as the weight makes it") {
  const double h = 1e-3;
  Material material(0, 0.6);
  Bench bench(ground(5), material, steps_of(h));
  bench.add(square({.poisson = 0, .beta = 1e-5}, h, {0, 0.5}));
  for (int n = 0; n < 900; ++n) bench.world.step(h, false);
  const Vec2 before = bench.world.bodies[0].x;
  for (int n = 0; n < 100; ++n) bench.world.step(h, false);
  double force = 0;
  for (const auto& contact : bench.world.contacts()) force += contact.impulse[0] / h;
  CHECK(force == Approx(density * 9.81).epsilon(1e-6));
  const Body<2>& block = bench.world.bodies[0];
  CHECK((block.x - before).norm() < 1e-9);
  double low = 0, high = 0;
  for (const Contactor2& node : block.contactors) {
    low = std::min(low, node.points.front().y());
    high = std::max(high, node.points.front().y());
  }
  CHECK(1 - (high - low) == Approx(density * 9.81 / (2 * young)).epsilon(0.01));
}

TEST_CASE("a run of a deformable block that stands on the ground leaves it there") {
  for (const double theta : {0.5, 0.6}) {
    WorldSettings settings = steps_of(1e-3);
    settings.theta = theta;
    Material material(0.4, 0.5);
    Bench bench(ground(5), material, settings);
    bench.add(square({.beta = 1e-5, .theta = theta, .cells = 6}, 1e-3, {-3, 0.5}));
    bench.run_settings.stop_speed = 0;
    bench.run(0.2);
    CHECK((bench.world.bodies[0].x - Vec2(-3, 0.5)).norm() < 1e-6);
  }
}

TEST_CASE("a deformable block on an incline slides and sticks as a rigid one does") {
  for (const double share : {0.99, 1.01}) {
    const double h = 1e-3, slope = 0.3, mu = std::tan(slope) * share;
    Material material(0, mu);
    Bench bench(ground(20, slope), material, steps_of(h));
    const Vec2 up(std::sin(slope), std::cos(slope)), down(std::cos(slope), -std::sin(slope));
    bench.add(square({.beta = 1e-5, .cells = 4}, h, 0.5 * up, -slope));
    // Its weight makes it vibrate at first, and it slips while it presses less.
    for (int n = 0; n < 500; ++n) bench.world.step(h, false);
    const Body<2>& block = bench.world.bodies[0];
    const double before = block.v.dot(down);
    const Vec2 place = block.x;
    for (int n = 0; n < 500; ++n) bench.world.step(h, false);
    const double slides = 9.81 * std::cos(slope) * (std::tan(slope) - mu);
    if (share < 1)
      CHECK((block.v.dot(down) - before) / (500 * h) == Approx(slides).epsilon(0.01));
    else
      CHECK((block.x - place).norm() < 1e-9);
  }
}

TEST_CASE("the tension that a hundredth of a square exceeds hardly depends on its mesh") {
  // The greatest over time comes after the rebound, when waves meet: at 4.8 and 4.7 L/c.
  for (const auto& [cells, expected] : {std::pair(20, 1.05), std::pair(40, 1.00)}) {
    const double h = 1 / (cells * sound);
    Material material(0, 0);
    Bench bench(ground(5), material, steps_of(h), Vec2::Zero());
    Body<2> block = square({.cells = cells}, h, {0, 0.5});
    block.v = {0, -1};
    bench.add(std::move(block));
    double greatest = 0;
    for (int n = 0; n < 6 * cells; ++n) {
      bench.world.step(h, false);
      const Deformation<2>& own = bench.world.bodies[0].deformation;
      greatest = std::max(greatest, stress_share(own.block->model, own.u, std::nullopt).tension);
    }
    CHECK(greatest / (density * sound) == Approx(expected).epsilon(0.02));
  }
}

}  // namespace deformable_test
