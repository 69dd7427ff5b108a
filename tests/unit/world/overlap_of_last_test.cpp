// A body that is added is compared with the ground and with all others, and these not among each other.
#include <catch2/catch.hpp>

#include "analytic/lab.h"
#include "random/stream.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace overlap_of_last_test {

using lab::ground;
using lab::Material;

TEST_CASE(
    "the overlap of the body that was added last is the deepest one of all while the others have none") {
  Material material(0, 0);
  WorldSettings settings;
  settings.body_contacts = true;
  RandomStream rng(3, "overlap", {});
  Bench bench(ground(100), material, settings, {0, -9.81});
  int refused = 0;
  for (int i = 0; i < 200; ++i) {
    const double radius = 0.1 + 0.4 * rng.uniform();
    bench.add(disk(radius, 1, {20 * rng.uniform(), 0.3 + 8 * rng.uniform()}, {0, 0}));
    const auto of_last = bench.world.overlap_of_last();
    const auto of_all = bench.world.deepest_overlap();
    CHECK(of_last.depth == of_all.depth);
    if (of_all.depth == 0) continue;
    CHECK(of_last.body == of_all.body);
    CHECK(of_last.other == of_all.other);
    bench.world.remove_last();
    ++refused;
  }
  CHECK(refused > 20);
  CHECK(refused < 180);
}

}  // namespace overlap_of_last_test
