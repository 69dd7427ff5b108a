#include "load/pile_cost.h"

#include <catch2/catch.hpp>

using namespace flyrock;

TEST_CASE("check says what piles of many bodies may cost, by bodies and steps") {
  Scenario scenario;
  scenario.dimension = 3;
  scenario.trials = 30;
  scenario.stop.time = 40;
  CHECK(pile_cost_note(scenario, 19).empty());
  // 300 bodies x 10,000 steps x 0.13 ms = 390 s
  CHECK(pile_cost_note(scenario, 300) ==
        "300 bodies that may meet: if they pile up and move until stop.time, a trial takes about 7 min of "
        "processor "
        "time, 3.2 h for all 30");
  scenario.trials = 1;
  scenario.dimension = 2;
  CHECK(pile_cost_note(scenario, 300).find("about 2 min of processor time") != std::string::npos);
  CHECK(!pile_cost_note(scenario, 300).ends_with("all 1"));
  scenario.solver.dense.time_step = 0.04;
  CHECK(pile_cost_note(scenario, 300).empty());
  scenario.solver.dense.bodies = "exact";
  CHECK(pile_cost_note(scenario, 300).find("each touch of two cuts the step of all") != std::string::npos);
}
