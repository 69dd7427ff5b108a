// The inputs of a sensitivity analysis, and what their exchange does to the trials of a scenario.

#include "batch/exchanged_inputs.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "batch/trial.h"
#include "load.h"

using namespace flyrock;

namespace exchanged_inputs_test {

namespace {

std::vector<std::string> names_of(const ExchangedInputs& inputs) {
  std::vector<std::string> names;
  for (const ExchangedInput& input : inputs.inputs) names.push_back(input.name);
  return names;
}

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

TEST_CASE("the inputs of a scenario are what is drawn and read, and everything else") {
  const LoadedScenario benches = loaded("scenarios/ninh_dan/benches_2d.yaml");
  const ExchangedInputs found = exchanged_inputs(benches.plan, {});
  const std::vector<std::string> names = names_of(found);
  for (const char* name :
       {"blast.burden", "materials.broken_rock.restitution.en", "rocks.fly_rock.shape.diameter",
        "rocks.fly_rock.release", "rocks.loose.orientation", "rocks.loose.launch.speed"}) {
    INFO(name);
    CHECK(has(names, name));
  }
  CHECK(names.back() == everything_else);
  CHECK_FALSE(has(names, "blast.hole.stemming"));
  CHECK(std::any_of(found.not_read.begin(), found.not_read.end(), [](const NoInput& input) {
    return input.stream == "blast.hole.stemming" && input.why.find("bench_fit") != std::string::npos;
  }));

  const LoadedScenario pattern = loaded("scenarios/ninh_dan/pattern.yaml");
  const std::vector<std::string> of_pattern = names_of(exchanged_inputs(pattern.plan, {}));
  for (const char* name : {"branches", "blast.scatter.burden", "rocks.face.launch.azimuth"}) {
    INFO(name);
    CHECK(has(of_pattern, name));
  }
  const LoadedScenario constant = loaded("scenarios/quarry/site_constant.yaml", {.set = {"outer=1"}});
  const ExchangedInputs with_constant = exchanged_inputs(constant.plan, {});
  CHECK(has(with_constant.once_a_run, "rocks.collar.launch.k"));
  CHECK_FALSE(has(names_of(with_constant), "rocks.collar.launch.k"));
}

TEST_CASE("a name stands for the streams below it, and two inputs share none") {
  const LoadedScenario benches = loaded("scenarios/ninh_dan/benches_2d.yaml");
  const ExchangedInputs found = exchanged_inputs(
      benches.plan, {.inputs = {"blast.burden"}, .groups = {{"loose rock", {"rocks.loose"}}}});
  CHECK(names_of(found) == std::vector<std::string>{"loose rock", "blast.burden", everything_else});
  CHECK(has(found.inputs[0].streams, "rocks.loose.release"));
  CHECK(has(found.inputs[0].streams, "rocks.loose.launch.speed"));
  const ExchangedInputs apart = exchanged_inputs(
      benches.plan, {.inputs = {"rocks.loose.launch", "rocks.loose.launch.speed"}, .groups = {}});
  CHECK(has(apart.inputs[0].streams, "rocks.loose.launch"));
  CHECK(has(apart.inputs[0].streams, "rocks.loose.launch.elevation"));
  CHECK_FALSE(has(apart.inputs[0].streams, "rocks.loose.launch.speed"));
  const auto refused = [&](const InputChoice& choice, const std::string& text) {
    try {
      exchanged_inputs(benches.plan, choice);
      FAIL("is not refused");
    } catch (const std::invalid_argument& fault) {
      CHECK(std::string(fault.what()).find(text) != std::string::npos);
    }
  };
  refused({.inputs = {"blast.burdn"}, .groups = {}}, "did you mean `blast.burden`?");
  refused({.inputs = {"blast.burden"}, .groups = {{"hole", {"blast.burden"}}}}, "stands in two inputs");
  refused({.inputs = {"rocks.loose", "rocks.loose"}, .groups = {}}, "two inputs are called `rocks.loose`");
}

TEST_CASE("an exchanged input has the numbers of the second base, and all others keep theirs") {
  LoadedScenario benches = loaded("scenarios/ninh_dan/pattern.yaml");
  Scenario& scenario = benches.plan.points.front();
  const ExchangedInputs inputs =
      exchanged_inputs(benches.plan, {.inputs = {"blast.scatter.burden", "branches"}, .groups = {}});
  const std::vector<Exchange> tables = exchanges(inputs, scenario.streams.seed);
  REQUIRE(tables.size() == 5);
  Exchange current;
  ask_for_exchanges(scenario, &current);
  TrialRunner runner(scenario);
  const auto run = [&](std::size_t point) {
    current = tables[point];
    TrialRecords records;
    for (std::uint64_t trial = 0; trial < 4; ++trial) runner.run(trial, records);
    return records;
  };
  const std::vector<TrialRecords> of{run(0), run(1), run(2), run(3), run(4)};
  const auto same = [&](auto number, std::size_t a, std::size_t b) {
    return std::equal(
        of[a].rocks.begin(), of[a].rocks.end(), of[b].rocks.begin(),
        [&](const RockRecord& one, const RockRecord& other) { return number(one) == number(other); });
  };
  const auto mass = [](const RockRecord& rock) { return rock.mass; };
  // Of the velocity, so rounded.
  const auto elevation = [](const RockRecord& rock) { return std::round(1e9 * rock.launch_elevation); };
  const auto speed = [](const RockRecord& rock) { return rock.launch_speed; };
  const auto branch = [](const RockRecord& rock) { return rock.branch; };
  CHECK(same(mass, 0, 2));
  CHECK(same(elevation, 0, 2));
  CHECK(same(branch, 0, 2));
  CHECK_FALSE(same(speed, 0, 2));  // of the burden
  CHECK(same(mass, 0, 3));
  CHECK(same(mass, 1, 4));  // all but burden and branches
  CHECK(same(elevation, 1, 4));
  CHECK_FALSE(same(mass, 0, 1));
  CHECK_FALSE(same(mass, 0, 4));
}

}  // namespace exchanged_inputs_test
