// Oblique impact of a disk without spin (field.md 5.9): stick iff mu >= k/(1+k) |v_t| / ((1+e) v_n).
#include <catch2/catch.hpp>

#include "analytic/lab.h"

using namespace flyrock;
using namespace flyrock::lab;

TEST_CASE("an oblique impact of a disk sticks or slips") {
  const double mu = GENERATE(0.2, 0.3, 0.4);
  const double e = 0.5;
  Material material(e, mu);
  WorldSettings settings;
  settings.tolerance = 1e-12;
  Bench bench(ground(10), material, settings);
  bench.add(disk(1, 1, {0, 1}, {3, -2}));
  bench.world.impact();
  const Body<2>& body = bench.world.bodies[0];
  CHECK(body.v.y() == Approx(1).epsilon(1e-10));
  if (mu >= 0.5 / 1.5 * 3 / (1.5 * 2)) {
    CHECK(body.v.x() == Approx(2).epsilon(1e-10));
    CHECK(body.w == Approx(-2).epsilon(1e-10));
  } else {
    CHECK(body.v.x() == Approx(3 - mu * 1.5 * 2).epsilon(1e-10));
    CHECK(body.w == Approx(-mu * 3 / 0.5).epsilon(1e-10));
  }
  const Impact& impact = bench.world.impacts().at(0);
  CHECK(impact.pn == Approx(3).epsilon(1e-10));
  CHECK(impact.vt_before == Approx(3));
  const double energy = body.kinetic_energy() - 6.5;
  CHECK(impact.energy_change == Approx(energy).epsilon(1e-10));
}

TEST_CASE("an impact of two bodies is a row of each, which names the other") {
  Material material(1, 0);
  Bench bench(ground(10), material, {}, Vec2::Zero());
  bench.add(disk(0.5, 1, {-2, 3}, {1, 0}));
  bench.add(disk(0.5, 1, {0, 3}, {0, 0}));
  bench.run(1.5);
  REQUIRE(bench.histories[0].impacts.size() == 1);
  REQUIRE(bench.histories[1].impacts.size() == 1);
  CHECK(bench.histories[0].impacts[0].other == 1);
  CHECK(bench.histories[1].impacts[0].other == 0);
}
