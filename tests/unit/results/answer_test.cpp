// The answer in words: shares with their intervals, what barriers did, where censored rocks were.

#include "results/say/answer.h"

#include <catch2/catch.hpp>

#include "results/say/answer_shares.h"
#include "unit/results/fake_results.h"

using namespace flyrock;

namespace {

/// Rocks that came to rest, of which some met a barrier.
TrialRecords resting(std::uint64_t trials) {
  TrialRecords records = fake::records(trials);
  for (RockRecord& rock : records.rocks) {
    rock.reason = StopReason::stopped;
    rock.censored = false;
  }
  return records;
}

std::string answer_of(const Plan& plan, const TrialRecords& records) {
  Results results = make_results(plan, {rows_of(records)}, {{plan.points[0].trials}, true, "", {}});
  results.points[0].terrain = fake::bench();
  return answer(plan, results);
}

bool says(const std::string& text, const std::string& what) { return text.find(what) != std::string::npos; }

}  // namespace

TEST_CASE("the answer says what a barrier catches, what goes over it and what goes through it") {
  Plan plan = fake::plan(100);
  plan.points[0].barriers = {{"fence", 20, 2, 2000}};
  TrialRecords records = resting(100);
  for (std::uint64_t trial = 0; trial < 100; trial += 2) {
    const BarrierOutcome outcome = trial < 60   ? BarrierOutcome::caught
                                   : trial < 80 ? BarrierOutcome::over_top
                                                : BarrierOutcome::over_energy;
    records.barriers.push_back({trial, 0, {{}, 0, outcome}});
    if (outcome == BarrierOutcome::caught) records.rocks[2 * trial].reason = StopReason::caught;
  }
  const std::string text = answer_of(plan, records);
  INFO(text);
  // The blocks, one a trial: 30, 10 and 10 of 50, 50 and 20 of 100. R: binom.test(30, 50) and so on.
  CHECK(
      text.starts_with("Barrier fence, blocks: it catches 60 % (95 % interval 45.2 to 73.6 %) of the rocks "
                       "that reach it; 20 % (95 % "
                       "interval 10 to 33.7 %) go over the top, 20 % (95 % interval 10 to 33.7 %) go through "
                       "it; 50 % (95 % interval "
                       "39.8 to 60.2 %) of all rocks reach it. In 20 % (95 % interval 12.7 to 29.2 %) of the "
                       "trials at least one gets "
                       "past. Distances hold only while the barriers stand. The runout "));
}

TEST_CASE("a barrier that no rock reaches has an upper bound, and no distance rests on it") {
  Plan plan = fake::plan(100);
  plan.points[0].barriers = {{"fence", 20, 2, 2000}};
  const std::string text = answer_of(plan, resting(100));
  INFO(text);
  CHECK(text.starts_with(
      "Barrier fence: in 0 % (95 % interval up to 3.62 %) of the trials a rock reaches it. The runout "));
  CHECK_FALSE(says(text, "while the barriers stand"));
}

TEST_CASE("rocks that were lost before a barrier make the share that does not reach it an upper bound") {
  Plan plan = fake::plan(100);
  plan.points[0].barriers = {{"fence", 20, 2, 2000}};
  TrialRecords records = resting(100);
  for (int k = 0; k < 20; ++k)
    records.barriers.push_back({records.rocks[k].trial, records.rocks[k].rock, {}});
  records.rocks[50].reason = StopReason::timed_out;
  records.rocks[50].censored = true;
  const std::string text = answer_of(plan, records);
  INFO(text);
  CHECK(says(text, "; >= 10 % ("));
}

TEST_CASE(
    "the answer names material, part and place of the rocks that time ran out for, and where others left") {
  Plan plan = fake::plan(100);
  plan.points[0].terrain.material_of_part = {{"berm", 1}, {"floor", 0}};
  TrialRecords records = resting(100);
  const auto cut = [&](std::size_t rock, StopReason reason, int part, double x) {
    records.rocks[rock].reason = reason;
    records.rocks[rock].censored = true;
    records.rocks[rock].end_part = part;
    records.rocks[rock].stop_x = x;
  };
  cut(0, StopReason::timed_out, 2, 180);
  cut(1, StopReason::timed_out, 2, 120);
  cut(2, StopReason::timed_out, 2, 150);
  cut(3, StopReason::timed_out, -1, 30);
  cut(4, StopReason::left_domain, -1, 300);
  cut(5, StopReason::left_domain, -1, 300);
  std::string text = answer_of(plan, records);
  INFO(text);
  CHECK(says(text,
             " 3 % (too few trials for an interval: about 334) of the rocks are censored: 3 ran out of time "
             "(60 s) on "
             "rock (part floor), x from 120 to 180 m; "
             "2 left the domain at x = 300 m; 1 ran out of time (60 s) in the air, x = 30 m. Their distances "
             "are lower bounds."));
  plan.points[0].rock_contacts = true;
  CHECK(says(answer_of(plan, records), "1 ran out of time (60 s) in the air or on other rocks, x = 30 m."));
  plan.points[0].rock_contacts = false;
  cut(6, StopReason::left_domain, -1, -40);  // at the other end
  text = answer_of(plan, records);
  INFO(text);
  CHECK(says(text, "; 1 elsewhere. "));
}

TEST_CASE("bodies that stand are said to have stood, at most three of them by name") {
  Plan plan = fake::plan(1);
  plan.points[0].rocks.clear();
  plan.points[0].stop.speed = 0;
  TrialRecords records = fake::records(1);
  const RockRecord one = records.rocks[0];
  records.rocks.clear();
  const auto add = [&](const std::string& name, double speed, int impacts, StopReason reason) {
    plan.points[0].bodies.emplace_back().name = name;
    RockRecord& body = records.rocks.emplace_back(one);
    body.rock = body.group = static_cast<int>(records.rocks.size()) - 1;
    body.mass = 2;
    body.max_speed = speed;
    body.max_energy = speed * speed;
    body.impacts = impacts;
    body.reason = reason;
    body.time = 0.5;
    body.runout = speed;
  };
  const auto answered = [&] { return answer_of(plan, records); };
  add("base", 1e-8, 0, StopReason::timed_out);
  add("top", 1e-7, 0, StopReason::stopped);
  CHECK(answered() == "base, top stood for 0.5 s.");
  for (RockRecord& body : records.rocks) body.time = 0;
  CHECK(answered() == "base, top stood from the start on.");
  for (RockRecord& body : records.rocks) body.time = 0.5;
  add("ball", 3, 2, StopReason::timed_out);
  CHECK(answered() ==
        "base, top stood for 0.5 s. ball was 3 m from where it began after 0.5 s, with 2 impacts.");
  plan.points[0].stop.speed = 0.05;
  CHECK(says(answered(), "ball was still moving after 0.5 s"));
  for (const char* name : {"a", "b", "c"}) add(name, 0, 0, StopReason::timed_out);
  CHECK(says(answered(), "base, top, a and 2 more bodies stood for 0.5 s. ball was"));
  for (const char* name : {"d", "e"}) add(name, 1, 0, StopReason::stopped);
  CHECK_FALSE(says(answered(), "more body"));
  add("spinning", 0, 0, StopReason::timed_out);
  records.rocks.back().max_energy = 1;
  CHECK(says(answered(), "with 0 impacts. 1 more body moved."));
  add("fallen", 1, 0, StopReason::left_domain);
  CHECK(says(answered(), "with 0 impacts. 2 more bodies moved."));
}

TEST_CASE("in the method ballistic a path ends at the first landing, and is called so") {
  Plan plan = fake::plan(100);
  const Results results = make_results(plan, {rows_of(resting(100))}, {{100}, true, "", {}});
  plan.points[0].method = Method::ballistic;
  const std::string text = answer(plan, results);
  INFO(text);
  CHECK(says(text, "The distance of the first landing that 95 % of the rocks do not exceed is "));
  CHECK_FALSE(says(text, "runout"));
  CHECK(ended(StopReason::stopped, plan.points[0]) == "first landed");
  CHECK(ended(StopReason::stopped, fake::scenario(1)) == "stopped");
}
