// The impacts that a world tells are those of its last step or impact.
#include <catch2/catch.hpp>

#include "analytic/lab.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace impacts_of_step_test {

using lab::ground;
using lab::Material;

TEST_CASE("a step of zero length, cut by a touch that is due at once, has no impacts") {
  Material material(0, 0);
  WorldSettings settings;
  settings.time_step = 1000;  // so long that 1e-10 s is no time
  Bench bench(ground(100), material, settings, {0, 0});
  bench.add(disk(0.5, 1, {0, 0.5}, {0, -1}));
  bench.add(disk(0.5, 1, {5, 0.5 + 1e-6}, {0, -1e4}));
  bench.world.impact();
  REQUIRE(bench.world.impacts().size() == 1);
  const auto outcome = bench.world.step(1e-3, true);
  REQUIRE(outcome.duration == 0);
  CHECK(outcome.new_touch);
  CHECK(bench.world.impacts().empty());
}

}  // namespace impacts_of_step_test
