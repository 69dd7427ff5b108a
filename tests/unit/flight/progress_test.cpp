// A run whose time stands still or crawls ends, by steps and by counted work.
#include <catch2/catch.hpp>

#include "analytic/lab.h"
#include "flight/jam.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace progress_test {

TEST_CASE("time that stands still for 10,000 steps is no progress, and a step length of it is") {
  lab::Material material(0, 0.5);
  Bench bench(lab::ground(10), material);
  bench.add(disk(0.5, 1, {0, 5}));
  ProgressWatch watch;
  for (const double time : {0.0, 0.5e-3, 2e-3}) {
    bench.world.time = time;
    const bool advances = time > 1e-3;
    for (std::uint64_t k = 1; k < ProgressWatch::most_steps / 2; ++k)
      REQUIRE_FALSE(watch.stands_still(bench.world));
    if (!advances) continue;
    std::uint64_t more = 0;
    while (!watch.stands_still(bench.world)) ++more;
    CHECK(more < ProgressWatch::most_steps);
    CHECK(watch.fault() == "no progress in 10000 steps: the contacts of this rock cannot all hold at once");
  }
}

TEST_CASE("much work in few steps is no progress") {
  lab::Material material(0, 0.5);
  Bench bench(lab::ground(10), material);
  bench.add(disk(0.5, 1, {0, 5}));
  ProgressWatch watch;
  CHECK_FALSE(watch.stands_still(bench.world));
  bench.world.quality().toc_iterations += ProgressWatch::most_work / ProgressWatch::of_search;
  CHECK(watch.stands_still(bench.world));
  CHECK(watch.fault().starts_with("no progress in 2 steps"));
}

TEST_CASE("time that crawls is no progress, and costly steps that time repays are") {
  lab::Material material(0, 0.5);
  constexpr double of_one_body = ProgressWatch::repaid_by_time;
  for (const double share : {0.9, 0.01}) {  // of a step length, by which each step leads time on
    Bench bench(lab::ground(10), material);
    bench.add(disk(0.5, 1, {0, 5}));
    const double step_length = bench.world.settings().time_step;
    ProgressWatch watch;
    int steps = 0;
    for (bool ends = false; !ends && steps < 100'000; ++steps) {
      bench.world.time += share * step_length;
      bench.world.quality().toc_iterations +=
          static_cast<std::uint64_t>(0.9 * of_one_body / ProgressWatch::of_search);
      ends = watch.stands_still(bench.world);
    }
    CAPTURE(share, steps);
    CHECK((steps == 100'000) == (share > 0.5));
    if (share < 0.5) CHECK(watch.fault().find("steps: time crawls") != std::string::npos);
  }
}

}  // namespace progress_test
