// Which barriers of a sweep hold enough, from counts that are known.

#include "results/compare/barrier_choice.h"

#include <catch2/catch.hpp>

#include "results/say/answer.h"
#include "unit/results/fake_results.h"

using namespace flyrock;

namespace barrier_choice_test {

constexpr std::uint64_t trials = 200;

/// At x 10 and 20 m fences of 1 and 2 m with 20 and 50 kJ. At 10 m none holds, because a rock goes over all
/// of them in a tenth of the trials; at 20 m one of 2 m with any capacity, or 1 m with 50 kJ.
Plan plan_of_fences() {
  Plan plan = fake::plan(trials);
  plan.points[0].rocks.resize(1);
  plan.points[0].barriers = {{"fence", 10, 1, 20e3}};
  const Scenario one = plan.points[0];
  plan.points.clear();
  plan.at.clear();
  plan.axes.clear();
  for (const auto& [path, values, unit] :
       {std::tuple{"barriers.0.x", std::vector<double>{10, 20}, "m"},
        {"barriers.0.height", std::vector<double>{1, 2}, "m"},
        {"barriers.0.capacity", std::vector<double>{20e3, 50e3}, "kg m2/s2"}})
    plan.axes.push_back({.path = path, .values = values, .name = path, .unit = unit});
  for (const double x : {10, 20})
    for (const double height : {1, 2})
      for (const double capacity : {20e3, 50e3}) {
        plan.at.push_back({x, height, capacity});
        plan.points.push_back(one);
      }
  return plan;
}

TrialRecords records_at(const std::vector<double>& at) {
  const bool holds = at[0] == 20 && (at[1] == 2 || at[2] == 50e3);
  TrialRecords records;
  records.totals.materials.resize(2);
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    RockRecord& rock = records.rocks.emplace_back();
    rock.trial = trial;
    rock.runout = 30;
    const bool over = !holds && trial % 10 == 0;
    rock.reason = over ? StopReason::stopped : StopReason::caught;
    records.barriers.push_back(
        {trial, 0, {{.kinetic_energy = 1000}, 0, over ? BarrierOutcome::over_top : BarrierOutcome::caught}});
  }
  return records;
}

}  // namespace barrier_choice_test

TEST_CASE("a sweep of fences answers with the smallest that holds at each place, in its first sentence") {
  using namespace barrier_choice_test;
  const Plan plan = plan_of_fences();
  std::vector<Rows> rows;
  for (const std::vector<double>& at : plan.at) rows.push_back(rows_of(records_at(at)));
  const Results results =
      make_results(plan, rows, {std::vector<std::uint64_t>(plan.points.size(), trials), true, "", {}});
  const BarrierChoice choice =
      choose_barrier(plan, results.points, 0, 0, HeldSense::per_trial, usual_held_share);
  CHECK(choice.holding == std::vector<std::size_t>{5, 6, 7});
  CHECK(choice.smallest == std::vector<std::size_t>{5, 6});
  CHECK(choice.text == "x 10 m: none of the sweep. x 20 m: 1 m high with 50 kJ, or 2 m high with 20 kJ");
  // No fence lets a rock pass in 0 of 200 trials with less than 1 - 0.025^(1/200) = 1.8 %.
  CHECK(choose_barrier(plan, results.points, 0, 0, HeldSense::per_trial, 0.99).holding.empty());
  // At 10 m a tenth of the rocks passes: with 95 % confidence up to 15 %.
  CHECK(choose_barrier(plan, results.points, 0, 0, HeldSense::of_arriving, 0.8).holding.size() == 8);
  CHECK(
      answer(plan, results)
          .starts_with("Smallest fence of the sweep that no rock gets past in 95 % of the trials, with 95 % "
                       "confidence: x 10 m: none of the sweep. x 20 m: 1 m high"));
  CHECK(barrier_choices(plan, results.points).size() == 15);  // 3 senses, 5 shares
}
