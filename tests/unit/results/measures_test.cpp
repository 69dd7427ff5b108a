#include <catch2/catch.hpp>

#include "record/rows.h"
#include "results/compare/expectations.h"
#include "scenario/plan.h"

using namespace flyrock;

namespace {

Scenario of_rocks() {
  Scenario scenario;
  scenario.rocks.resize(2);
  scenario.rocks[0].name = "blocks";
  scenario.rocks[1].name = "loose";
  return scenario;
}

Scenario of_bodies() {
  Scenario scenario;
  scenario.bodies.resize(1);
  scenario.bodies[0].name = "ball";
  return scenario;
}

PointResult result_of(const Scenario& scenario, std::vector<RockRecord> rocks) {
  RockTally tally(group_names(scenario));
  TrialRecords records;
  records.rocks = std::move(rocks);
  read_in_passes(rows_of(records), tally);
  PointResult result;
  result.groups = tally.summaries();
  return result;
}

Expectation expecting(ExpectKind kind, double value, double high = 0, double tolerance = 0) {
  Expectation expectation;
  expectation.measure = "rocks.runout.mean";
  expectation.kind = kind;
  expectation.value = value;
  expectation.high = high;
  expectation.tolerance = tolerance;
  return expectation;
}

/// The order of an error over runs whose step halves, with these mean runouts.
Verdict judge_order(const std::vector<double>& runouts, const Expectation& expectation) {
  Plan plan;
  plan.axes.push_back({"solver.time_step", {}});
  std::vector<PointResult> results;
  double step = 1;
  for (const double runout : runouts) {
    Scenario scenario = of_rocks();
    scenario.expect = {expectation};
    RockRecord rock;
    rock.runout = runout;
    rock.reason = StopReason::stopped;
    results.push_back(result_of(scenario, {rock}));
    plan.points.push_back(std::move(scenario));
    plan.at.push_back({step});
    step /= 2;
  }
  return judge(plan, results, true).front();
}

Verdict judge_one(const Expectation& expectation, Scenario scenario, PointResult result, bool full = true) {
  scenario.expect = {expectation};
  Plan plan;
  plan.points = {scenario};
  plan.at = {{}};
  return judge(plan, {std::move(result)}, full).at(0);
}

}  // namespace

TEST_CASE("Measures of rocks, of all and of a group") {
  const Scenario scenario = of_rocks();
  std::vector<RockRecord> rocks(4);
  for (int i = 0; i < 4; ++i) {
    rocks[i].group = i / 2;
    rocks[i].runout = 10 * i;
    rocks[i].max_energy = 1000 * i;
    rocks[i].reason = StopReason::stopped;
  }
  rocks[3].reason = StopReason::timed_out;
  rocks[3].censored = true;
  const PointResult result = result_of(scenario, rocks);
  const auto value = [&](const char* name) { return Measure(name, scenario).value(result); };
  CHECK(value("rocks.runout.mean").value == 15);
  CHECK(value("rocks.runout.mean").censored);
  CHECK(value("rocks.blocks.runout.max").value == 10);
  CHECK_FALSE(value("rocks.blocks.runout.max").censored);
  CHECK(value("rocks.loose.energy.min").value == 2000);
  CHECK(value("rocks.count").value == 4);
  CHECK(value("rocks.loose.censored").value == 0.5);
}

TEST_CASE("Measures of bodies, of the solver and of the energy") {
  const Scenario scenario = of_bodies();
  PointResult result;
  BodyHistory body;
  body.reason = StopReason::stopped;
  body.last.velocity = {3, -4, 0};
  body.last.spin.z() = 7;
  body.max.position.y() = 12;
  body.max_speed = 9;
  body.contact_time = 0.25;
  body.impacts.resize(2);
  body.impacts[1].vn_after = 1.5;
  body.apexes = {{0.5, 2.25}};
  result.totals.bodies = {body};
  result.totals.quality.max_residual = 1e-7;
  result.totals.quality.energy_relative_change = -0.5;
  const auto value = [&](const char* name) { return Measure(name, scenario).value(result); };
  CHECK(value("body.ball.final.vy").value == -4);
  CHECK(value("body.ball.final.speed").value == 5);
  CHECK(value("body.ball.final.spin").value == 7);
  CHECK(value("body.ball.max.y").value == 12);
  CHECK(value("body.ball.max.speed").value == 9);
  CHECK(value("body.ball.contact_time").value == 0.25);
  CHECK(value("body.ball.impact[2].vn_after").value == 1.5);
  CHECK(value("body.ball.impact[3].pn").fault == "the body had 2 impacts");
  CHECK(value("body.ball.apex[1].height").value == 2.25);
  CHECK(value("body.ball.stop_time").fault == "the body never came to rest");
  CHECK(value("solver.max_residual").value == 1e-7);
  CHECK(value("energy.total.relative_change").value == -0.5);
}

TEST_CASE("Measures of a deformable body are over its series") {
  Scenario scenario;
  scenario.dimension = 2;
  scenario.bodies.resize(1);
  scenario.bodies[0].name = "block";
  PointResult result;
  for (const double tension : {2e6, 5e6, 3e6})
    result.series.stresses.push_back({.body = "block", .touch = 1e-6 * tension, .tension_1pct = tension});
  result.series.stresses.push_back({.body = "other", .tension_1pct = 9e6});
  const auto value = [&](const char* name) { return Measure(name, scenario).value(result); };
  CHECK(value("body.block.tension_1pct.max").value == 5e6);
  CHECK(value("body.block.tension_1pct.min").value == 2e6);
  CHECK(value("body.block.touch.final").value == 3);
  CHECK(value("body.block.share_above_strength.max").fault == "the body has no tensile_strength");
  result.series.stresses.clear();
  CHECK(value("body.block.strain.max").fault == "the body is rigid");
}

TEST_CASE("Expectations compare as they are written") {
  const Scenario scenario = of_rocks();
  RockRecord rock;
  rock.runout = 100;
  rock.reason = StopReason::stopped;
  const PointResult result = result_of(scenario, {rock});
  const auto judged = [&](const Expectation& expectation) {
    return judge_one(expectation, scenario, result).judgement;
  };
  CHECK(judged(expecting(ExpectKind::equals, 101, 0, 1)) == Judgement::passed);
  CHECK(judged(expecting(ExpectKind::equals, 101.1, 0, 1)) == Judgement::failed);
  Expectation relative = expecting(ExpectKind::equals, 110);
  relative.relative = 0.1;
  CHECK(judged(relative) == Judgement::passed);
  CHECK(judged(expecting(ExpectKind::below, 100)) == Judgement::failed);
  CHECK(judged(expecting(ExpectKind::above, 99)) == Judgement::passed);
  CHECK(judged(expecting(ExpectKind::between, 100, 120)) == Judgement::passed);
}

TEST_CASE("An order is the slope of the error over the step, on logarithmic axes") {
  Expectation order = expecting(ExpectKind::between, 1.99, 2.01);
  order.order = Expectation::Order{100, "solver.time_step"};
  const Verdict second = judge_order({104, 101, 100.25}, order);
  CHECK(second.judgement == Judgement::passed);
  CHECK(second.computed == Approx(2));
  CHECK(compared_text(second.expectation) == "order of rocks.runout.mean in solver.time_step");
  CHECK(judge_order({104, 102, 101}, order).computed == Approx(1));
  CHECK(judge_order({104, 102, 101}, order).judgement == Judgement::failed);
  CHECK(judge_order({96, 102, 99}, order).computed == Approx(1));  // errors of either sign
  CHECK(judge_order({104, 100}, order).reason == "the error at point 1 is 0, so that there is no order");
  CHECK(judge_order({104}, order).reason ==
        "an order needs points with different values of `solver.time_step`");
}

TEST_CASE("What cannot be judged soundly fails or is not judged, with the reason") {
  RockRecord lost;
  lost.runout = 100;
  lost.reason = StopReason::left_domain;
  lost.censored = true;
  const Scenario scenario = of_rocks();
  const PointResult result = result_of(scenario, {lost});
  const Expectation far = expecting(ExpectKind::above, 10);
  const Verdict censored = judge_one(far, scenario, result);
  CHECK(censored.judgement == Judgement::failed);
  CHECK(censored.reason == "censored rocks fall into it: the computed value is only a lower bound");

  const Verdict few = judge_one(far, scenario, result, false);
  CHECK(few.judgement == Judgement::not_judged);
  CHECK(few.reason == "fewer trials ran than the scenario asks for");

  Expectation nowhere = far;
  nowhere.at = {{"slope", 3}};
  CHECK(judge_one(nowhere, scenario, result).judgement == Judgement::failed);
  CHECK(judge_one(nowhere, scenario, result).reason == "`at` names no point of the sweep");
}
