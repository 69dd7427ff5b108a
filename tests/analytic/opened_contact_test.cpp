// Contacts that an impact opens while another contact holds the body.
#include <catch2/catch.hpp>

#include "analytic/lab.h"
#include "dice.h"

using namespace flyrock;
using namespace flyrock::lab;

// A corner that an impact has opened faster than the speed of rest comes back in a flight of milliseconds. If
// it is found only after it has closed, its velocity jumps within a step, and no length of the step is short
// enough: a quarter of all steps was refused.
TEST_CASE("a polygon that rattles from corner to corner comes to rest with few refused steps") {
  Dice dice(4);
  SolverQuality all;
  for (int i = 0; i < 20; ++i) {
    Material material(0.35, 0.6);
    WorldSettings settings;
    settings.step_tolerance = 1e-3;
    Bench bench(ground(100), material, settings);
    Body<2> rock = make_body({Contactor2::polygon({{0.60, 0.01},
                                                   {0.40, 0.35},
                                                   {-0.04, 0.47},
                                                   {-0.46, 0.29},
                                                   {-0.59, -0.03},
                                                   {-0.38, -0.36},
                                                   {-0.06, -0.46},
                                                   {0.42, -0.33}})},
                             2700, 0, 0);
    rock.move_to({0, 2}, dice(0, 2 * pi));
    rock.v = {2, -1};
    bench.add(rock);
    CHECK(bench.run(15).reason == StopReason::stopped);
    all.steps += bench.world.quality().steps;
    all.refused_steps += bench.world.quality().refused_steps;
    all.max_penetration = std::max(all.max_penetration, bench.world.quality().max_penetration);
  }
  CAPTURE(all.steps, all.refused_steps);
  CHECK(all.refused_steps < 0.08 * static_cast<double>(all.steps));
  CHECK(all.max_penetration < 2e-5);
}
