// What the page is given to draw.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "batch/inputs.h"
#include "load/load.h"
#include "report/page/convergence.h"
#include "report/page/rounded.h"
#include "report/page/sensitivity.h"
#include "report/page/tracks.h"
#include "results/measured/material_graphs.h"

using namespace flyrock;

namespace {

/// Rocks whose runout grows with draw 0, falls a little with draw 1; draw 2 is the same for all of them.
TrialRecords rocks_with_inputs(int count) {
  TrialRecords chunk;
  for (int i = 0; i < count; ++i) {
    const auto trial = static_cast<std::uint64_t>(i);
    const double a = uniform_at(5, 1, {.trial = trial}), b = uniform_at(5, 2, {.trial = trial});
    RockRecord rock;
    rock.trial = trial;
    rock.reason = i % 50 == 7 ? StopReason::diverged : StopReason::stopped;
    rock.runout = 10 * a * a - 2 * b;
    chunk.rocks.push_back(rock);
    for (const auto& [draw, value] : {std::pair(0, a), std::pair(1, b), std::pair(2, 4.0)})
      chunk.inputs.push_back({trial, 0, draw, 0, value});
  }
  return chunk;
}

Scenario with_draws() {
  Scenario scenario;
  scenario.rocks.resize(1);
  scenario.draws.resize(3);
  for (std::size_t i = 0; i < 3; ++i) scenario.draws[i].stream = "input " + std::to_string(i);
  return scenario;
}

}  // namespace

TEST_CASE("Inputs are ranked by what they do to the runout") {
  Sensitivity sensitivity(with_draws());
  sensitivity.add(rocks_with_inputs(1000));
  const auto data = sensitivity.data();
  REQUIRE(data.size() == 1);
  CHECK(data[0]["count"] == 980);  // without faults
  const auto& inputs = data[0]["inputs"];
  REQUIRE(inputs.size() == 2);  // one value in all rocks orders nothing
  CHECK(inputs[0]["path"] == "input 0");
  CHECK(inputs[0]["r"] > 0.9);
  CHECK(inputs[0]["lower"] < inputs[0]["r"]);
  CHECK(inputs[0]["upper"] > inputs[0]["r"]);
  CHECK(inputs[1]["path"] == "input 1");
  CHECK(inputs[1]["upper"] < 0);

  const auto& curve = inputs[0]["curve"];
  REQUIRE(curve["x"].size() == 10);  // tenths
  for (std::size_t i = 0; i < 10; ++i) {
    CHECK(curve["low"][i] <= curve["middle"][i]);
    CHECK(curve["middle"][i] <= curve["high"][i]);
    if (i > 0) CHECK(curve["x"][i] > curve["x"][i - 1]);
    if (i > 0) CHECK(curve["middle"][i] > curve["middle"][i - 1]);
  }

  Sensitivity few(with_draws());
  few.add(rocks_with_inputs(20));
  CHECK(few.data()[0]["inputs"].empty());

  Sensitivity many(with_draws());
  for (int i = 0; i < 11; ++i) many.add(rocks_with_inputs(1000));
  CHECK(many.data()[0]["count"] == 10'000);
}

namespace {

/// Rocks of random runout with `inputs` random inputs that have nothing to do with it.
TrialRecords rocks_of_chance(int sample, int count, int inputs) {
  TrialRecords chunk;
  RandomStream rng(3, "chance", {.trial = static_cast<std::uint64_t>(sample)});
  for (int i = 0; i < count; ++i) {
    RockRecord rock;
    rock.trial = static_cast<std::uint64_t>(i);
    rock.reason = StopReason::stopped;
    rock.runout = rng.uniform();
    chunk.rocks.push_back(rock);
    for (int draw = 0; draw < inputs; ++draw) chunk.inputs.push_back({rock.trial, 0, draw, 0, rng.uniform()});
  }
  return chunk;
}

}  // namespace

TEST_CASE("Of many inputs without influence none is told from chance in 19 of 20 runs") {
  constexpr int samples = 400, inputs = 20;
  Scenario scenario;
  scenario.rocks.resize(1);
  scenario.draws.resize(inputs);
  int runs_with_one = 0;
  for (int s = 0; s < samples; ++s) {
    Sensitivity sensitivity(scenario);
    sensitivity.add(rocks_of_chance(s, 60, inputs));
    const auto group = sensitivity.data()[0];
    REQUIRE(group["inputs"].size() == inputs);
    CHECK(group["confidence"] == Approx(1 - 0.05 / inputs));
    runs_with_one += std::any_of(group["inputs"].begin(), group["inputs"].end(),
                                 [](const auto& line) { return line["lower"] > 0 || line["upper"] < 0; });
  }
  CHECK(runs_with_one > 0.01 * samples);
  CHECK(runs_with_one < 0.08 * samples);  // 64 % where each stands for itself
}

TEST_CASE("Only inputs that the rocks of a group depend on are ranked") {
  Diagnostics diagnostics;
  const auto load = [&](const char* file) {
    auto loaded = load_scenario(std::string(FLYROCK_SOURCE_DIR "/scenarios/") + file, {}, diagnostics);
    INFO(diagnostics.to_text());
    REQUIRE(loaded);
    return std::move(*loaded);
  };
  const auto read_by = [](const Scenario& scenario, std::size_t group, const std::string& stream) {
    for (std::size_t d = 0; d < scenario.draws.size(); ++d)
      if (scenario.draws[d].stream == stream) return RankedInputs(scenario).reads(group, static_cast<int>(d));
    FAIL(stream);
    return false;
  };
  const LoadedScenario quarry = load("ninh_dan/benches_2d.yaml");
  const Scenario& benches = quarry.plan.points.front();
  CHECK(read_by(benches, 0, "blast.burden"));  // bench_fit
  CHECK_FALSE(read_by(benches, 0, "blast.hole.stemming"));
  CHECK_FALSE(read_by(benches, 0, "blast.hole.charge_length"));
  CHECK_FALSE(RankedInputs(benches).reads(0, Derived::charge));
  CHECK_FALSE(read_by(benches, 1, "blast.burden"));  // loose rock has a given speed
  CHECK(read_by(benches, 1, "rocks.loose.launch.speed"));

  const LoadedScenario area = load("quarry/blasting_area.yaml");
  const Scenario& plan = area.plan.points.front();
  CHECK(read_by(plan, 0, "blast.burden"));
  CHECK_FALSE(read_by(plan, 1, "blast.burden"));  // stemming is thrown by the stemming
  CHECK(read_by(plan, 1, "blast.hole.stemming"));

  const LoadedScenario models = load("ninh_dan/blast_models.yaml");
  const Scenario& side_by_side = models.plan.points.front();
  const auto mckenzie = std::find_if(side_by_side.rocks.begin(), side_by_side.rocks.end(),
                                     [](const RockGroup& group) { return group.name == "mckenzie"; });
  const auto group = static_cast<std::size_t>(mckenzie - side_by_side.rocks.begin());
  CHECK(RankedInputs(side_by_side).reads(group, Derived::charge));
  CHECK(RankedInputs(side_by_side)
            .reads(group, Derived::powder_factor));  // of the charge, though not of the burden
}

TEST_CASE("The inputs of a law that no contact asked are not ranked") {
  Scenario scenario = with_draws();
  scenario.materials.resize(1);
  scenario.materials[0].friction = PluginUse{};
  scenario.materials[0].friction->slots = {Number{0, 0}};
  const auto ranked_after = [&](std::uint64_t asked) {
    Sensitivity sensitivity(scenario);
    TrialRecords chunk = rocks_with_inputs(100);
    chunk.totals.materials = {{.friction = asked}};
    sensitivity.add(chunk);
    return sensitivity.data()[0]["inputs"];
  };
  CHECK(ranked_after(0).size() == 1);
  CHECK(ranked_after(9).size() == 2);
}

TEST_CASE(
    "Outcomes of what plugins draw are ranked only if the scenario asks, draws per impact by their mean") {
  Scenario scenario = with_draws();
  const auto paths = [&] {
    TrialRecords chunk = rocks_with_inputs(100);
    std::vector<InputRecord> inputs;
    for (const InputRecord& input : chunk.inputs) {
      if (input.input == 1) {                 // not drawn for the rock, but for its impacts
        if (input.trial % 10 == 3) continue;  // this rock had no impact
        inputs.push_back({input.trial, 0, 1, 1, input.value - 0.3});
        inputs.push_back({input.trial, 0, 1, 2, input.value + 0.3});
      } else {
        inputs.push_back(input);
      }
      if (input.input == 2)
        inputs.push_back({input.trial, 0, index_of(Outcome::volume, scenario), 0,
                          std::sqrt(chunk.rocks[input.trial].runout + 2)});
    }
    chunk.inputs = std::move(inputs);
    Sensitivity sensitivity(scenario);
    sensitivity.add(chunk);
    std::vector<std::string> names;
    const auto data = sensitivity.data();
    for (const auto& line : data[0]["inputs"]) names.push_back(line["path"]);
    return names;
  };
  CHECK(paths() == std::vector<std::string>{"input 0", "input 1"});
  scenario.output.rank_outcomes = true;
  CHECK(paths() == std::vector<std::string>{"rock.volume", "input 0", "input 1"});
}

TEST_CASE("Angles are read in degrees") {
  Scenario scenario = with_draws();
  scenario.draws[0].unit = "rad";
  Sensitivity sensitivity(scenario);
  sensitivity.add(rocks_with_inputs(1000));
  const auto first = sensitivity.data()[0]["inputs"][0];
  CHECK(first["unit"] == "deg");
  CHECK(first["curve"]["x"].back() > 50);  // the greatest is 1 rad
  CHECK(first["curve"]["x"].back() < 57.3);
}

TEST_CASE("A percentile converges to that of all rocks") {
  constexpr int count = 2000;
  Convergence convergence(count);
  do {
    for (int i = 0; i < count; ++i)
      convergence.add({static_cast<double>((i * 997) % count), i == 1999}, static_cast<std::uint64_t>(i), 1);
  } while (convergence.needs_another_pass());
  const auto data = convergence.data();
  const auto& n = data["n"];
  CHECK(n.size() == 24);
  CHECK(n.front() == 20);
  CHECK(n.back() == count);
  CHECK(std::is_sorted(n.begin(), n.end()));
  CHECK(data["p50"]["value"].back() == 999.5);
  CHECK(data["p95"]["upper"].front().is_null());  // 20 rocks say nothing of the tail
  CHECK(data["p95"]["lower"].back() < 1899);
  CHECK(data["p95"]["censored"].front() == false);
  CHECK(data["p50"]["upper"].front().is_number());
  CHECK(data["p95"]["censored"].back() == true);  // the last rock, at 1003, is censored
  CHECK(data["p95"]["upper"].back().is_null());
  CHECK(Convergence(0).data()["n"].empty());
  CHECK(Convergence(3).data()["n"].size() == 1);
}

TEST_CASE("The graph of a law is the law") {
  Diagnostics diagnostics;
  const auto loaded =
      load_scenario(FLYROCK_SOURCE_DIR "/scenarios/ninh_dan/benches_2d.yaml", {}, diagnostics);
  REQUIRE(loaded);
  const std::vector<MaterialGraph> graphs = material_graphs(loaded->plan.points.front(), {200, 0.3});
  const auto graph_of = [&](const std::string& material, const std::string& kind) {
    for (const MaterialGraph& graph : graphs)
      if (graph.material == material && graph.kind == kind) return graph;
    return MaterialGraph{};
  };
  const MaterialGraph fading = graph_of("haul_floor", "restitution");
  REQUIRE(fading.law == "pfeiffer_bowen");
  REQUIRE(fading.curves.size() == 2);
  CHECK_FALSE(fading.drawn);
  const double slow = fading.curves[0].middle.front();
  for (std::size_t i = 0; i < fading.speed.size(); ++i) {
    const double v = fading.speed[i] / 9.144, v0 = fading.speed[0] / 9.144;
    CHECK(fading.curves[0].middle[i] == Approx(slow * (1 + v0 * v0) / (1 + v * v)));
    CHECK(fading.curves[0].low[i] == fading.curves[0].high[i]);
  }
  const MaterialGraph drawn = graph_of("broken_rock", "restitution");
  REQUIRE(drawn.drawn);
  CHECK(drawn.curves[0].low[0] < drawn.curves[0].middle[0]);
  CHECK(drawn.curves[0].middle[0] < drawn.curves[0].high[0]);
  CHECK(graph_of("haul_floor", "friction").curves[0].middle[7] == Approx(std::tan(33 * pi / 180)));
  CHECK(graph_of("haul_floor", "friction").fault.empty());
}

TEST_CASE("A thinned path keeps where it changes its mode of travel") {
  TrialRecords chunk;
  chunk.rocks.resize(1);
  for (int i = 0; i <= 20; ++i) {  // a straight line, half of it in the air
    TrajectoryRecord row;
    row.point.state.time = 0.1 * i;
    row.point.state.position = {1.0 * i, 0, 0};
    row.point.mode = i <= 10 ? TravelMode::bounce : TravelMode::slide;
    chunk.trajectories.push_back(row);
  }
  Tracks tracks(1000, 2);
  tracks.add(chunk);
  const auto data = tracks.data();
  REQUIRE(data["list"].size() == 1);
  CHECK(data["list"][0]["x"] == nlohmann::ordered_json::array({0, 10000, 10000}));
  CHECK(data["list"][0]["modes"] == nlohmann::ordered_json::array({2, 1, 1, 2}));
  CHECK(data["cut"] == false);
}

TEST_CASE("A group of short paths keeps their form beside a group of long ones") {
  TrialRecords chunk;
  for (const auto& [group, reach] : {std::pair(0, 1.0), std::pair(1, 5000.0)}) {
    RockRecord rock;
    rock.rock = rock.group = group;
    chunk.rocks.push_back(rock);
    for (int i = 0; i <= 20; ++i) {
      TrajectoryRecord row{0, group, {}};
      const double along = i / 20.0;
      row.point.state.position = {reach * along, reach * along * (1 - along), 0};
      chunk.trajectories.push_back(row);
    }
  }
  Tracks tracks(1000, 2);
  tracks.add(chunk);
  const auto list = tracks.data()["list"];
  REQUIRE(list.size() == 2);
  CHECK(list[0]["y"].size() > 10);
  CHECK(list[0]["y"].size() == list[1]["y"].size());
}

TEST_CASE("Rounded numbers have four digits and no tail") {
  CHECK(rounded(0.1234567).dump() == "0.1235");
  CHECK(rounded(-98765.4).dump() == "-98770.0");
  CHECK(rounded(1e-7 / 3).dump() == "3.333e-08");
  CHECK(rounded(0).dump() == "0");
  CHECK(rounded(std::numeric_limits<double>::quiet_NaN()).is_null());
  CHECK(rounded(-0.123456789, 6).dump() == "-0.123457");
  CHECK(rounded(1234567.8, 6).dump() == "1234570.0");
}

TEST_CASE("The smallest numbers are rounded to 0, the greatest stay finite, at any number of digits") {
  for (const int digits : {4, 6}) {
    for (const double tiny : {5e-324, 1e-310, -2.2e-308, 1e-291}) CHECK(rounded(tiny, digits).dump() == "0");
    for (const double number : {1e-289, 3e-200, -7e-30, 2e200, -1.7e308}) {
      INFO(number);
      CHECK(rounded(number, digits).get<double>() == Approx(number).epsilon(1e-3).margin(0));
    }
  }
}
