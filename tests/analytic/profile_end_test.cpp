// The ground goes on level beyond the ends of a profile: a body whose centre is over the profile does not tip
// over.
#include <catch2/catch.hpp>

#include "analytic/lab.h"

using namespace flyrock;
using namespace flyrock::lab;

TEST_CASE("a long box that reaches beyond the end of the profile lies still") {
  Material material(0.3, 0.5);
  Bench bench(ground(5), material);
  bench.add(box(4, 0.5, 100, {4.9, 0.3}));
  const BodyHistory& history = bench.run(3);
  CHECK(history.reason == StopReason::stopped);
  CHECK(history.last.position.y() == Approx(0.25).margin(1e-9));
  CHECK(std::abs(history.last.angle) < 1e-9);
  CHECK(bench.world.quality().max_penetration < 1e-6);
}

TEST_CASE("a disk that falls at the very end of the profile comes to rest there") {
  Material material(0.3, 0.5);
  for (const double end : {-5.0, 5.0}) {
    Bench bench(ground(5), material);
    bench.add(disk(0.5, 100, {end, 3}));
    CHECK(bench.run(20).reason == StopReason::stopped);
  }
}
