// A deformable disk between two driven plates: the Brazilian test, and the contact of Hertz.

#include <catch2/catch.hpp>

#include "analytic/lab.h"
#include "elastic/elastic_block.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace pressed_disk_test {

namespace {

constexpr double radius = 0.5, young = 1e9, poisson = 0.25, density = 2700;
constexpr int rings = 40;
constexpr double modulus = young / (1 - poisson * poisson);  // Pa, in plane strain
constexpr double spacing = 2 * pi * radius / (6 * rings);    // m, of the surface nodes
constexpr double h = 1e-3, theta = 0.6;

/// What a disk bears at rest between two plates.
struct Pressed {
  double load = 0;                                ///< N, of a plate, for a thickness of 1 m
  double tension = 0, compression = 0;            ///< Pa, in the middle, across and along the load
  std::vector<std::pair<double, double>> forces;  ///< m, N: of the nodes at a plate: place before it closed
};

/// It may not turn: between plates without friction it would roll off its strip of contact.
Body<2> disk_of_cells() {
  std::vector<Vec2> corners;
  for (int i = 0; i < 6 * rings; ++i) {
    const double angle = 2 * pi * i / (6 * rings);
    corners.emplace_back(radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  Body<2> body = make_body({Contactor2::polygon(std::move(corners))}, density, 0, 1);
  const ElasticMaterial material{.young = young, .poisson = poisson, .density = density, .beta = 2e-3};
  make_deformable<2>(body,
                     std::make_shared<const ElasticBlock<2>>(ringed_disk(radius, rings), material, h, theta),
                     std::nullopt);
  body.move_to({0, 0}, 0);
  body.inertia *= 1e9;
  return body;
}

/// Two plates close on a disk by `approach` each, slower and slower, and stand until it has come to rest.
Pressed press(double approach) {
  constexpr int closing = 800, standing = 100;  // steps
  WorldSettings settings;
  settings.time_step = h;
  settings.theta = theta;
  settings.tolerance = 1e-11;
  Profile far = ground(1);
  for (Vec2& point : far.points) point.y() -= 10;
  Material material(0, 0);
  Bench bench(std::move(far), material, settings, Vec2::Zero());
  bench.add(disk_of_cells());
  for (const double side : {-1.0, 1.0}) {
    Body<2> plate = box(1, 0.2, 1, {0, side * (radius + 0.1)});
    plate.kind = BodyKind::driven;
    plate.v = {0, -side * 2 * approach / (closing * h)};
    plate.push = -plate.v / (closing * h);
    bench.add(std::move(plate));
  }
  World<2>& world = bench.world;
  for (int n = 0; n < closing; ++n) world.step(h, false);
  for (const int plate : {1, 2}) {
    world.bodies[plate].v.setZero();
    world.bodies[plate].push.setZero();
  }
  for (int n = 0; n < standing; ++n) world.step(h, false);

  const Deformation<2>& own = world.bodies[0].deformation;
  Pressed pressed;
  for (const auto& contact : world.contacts()) {
    if (contact.antagonist != 2) continue;
    pressed.load += contact.impulse[0] / h;
    const int node = own.node_of(contactor_of(contact.at.feature));
    pressed.forces.emplace_back(own.block->model.mesh().nodes[static_cast<std::size_t>(node)].x(),
                                contact.impulse[0] / h);
  }
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (int cell = 0; cell < 6; ++cell) middle += own.block->model.stress(cell, own.u) / 6;
  pressed.tension = middle[0];
  pressed.compression = -middle[1];
  return pressed;
}

/// The pressure p0 of p0 sqrt(1 - x^2/b^2) that fits nodal forces best [Pa].
double fitted_pressure(const Pressed& pressed, double half_width) {
  double product = 0, square = 0;
  for (const auto& [x, force] : pressed.forces) {
    if (std::abs(x) >= half_width) continue;
    const double share = std::sqrt(1 - x * x / (half_width * half_width));
    product += share * force;
    square += share * share * spacing;
  }
  return product / square;
}

}  // namespace

TEST_CASE("a disk between two plates bears the stress of the Brazilian test and the contact of Hertz",
          "[slow]") {
  struct Expected {
    double width, tension, compression, pressure;  // b/R; of 2P/(pi D t), of 6P/(pi D t), of Hertz
  };
  for (const auto& [width, tension, compression, pressure] :
       {Expected{0.1, 0.993, 0.997, 1.011}, Expected{0.2, 0.960, 0.983, 1.008}}) {
    const Pressed pressed = press(0.25 * width * width * (2 * std::log(4 / width) - 1) * radius);
    const double unit = 2 * pressed.load / (pi * 2 * radius);
    const double half_width = std::sqrt(4 * pressed.load * radius / (pi * modulus));
    INFO("b/R " << width);
    CHECK(half_width / radius == Approx(width).epsilon(0.01));
    CHECK(pressed.tension / unit == Approx(tension).epsilon(0.005));
    CHECK(pressed.compression / (3 * unit) == Approx(compression).epsilon(0.005));
    CHECK(fitted_pressure(pressed, half_width) / (2 * pressed.load / (pi * half_width)) ==
          Approx(pressure).epsilon(0.01));
    double outermost = 0;
    for (const auto& [x, force] : pressed.forces)
      if (force > 0.01 * pressed.load / 10) outermost = std::max(outermost, std::abs(x));
    CHECK(outermost == Approx(half_width).margin(spacing));
  }
}

}  // namespace pressed_disk_test
