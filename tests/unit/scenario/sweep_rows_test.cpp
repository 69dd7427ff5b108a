// Points of a sweep that set several paths at once, and designs of trials.

#include "scenario/sweep_rows.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <set>

#include "batch/trial.h"
#include "load/load.h"
#include "results/statistics/statistics.h"
#include "scenario/trial_design.h"

using namespace flyrock;

namespace sweep_rows_test {

namespace {

const std::string blast =
    "flyrock: 1\ndimension: 2\nmethod: ballistic\ntrials: 32\n"
    "terrain: { type: profile, points: [[-20, 0], [1500, 0]] }\n"
    "blast: { explosive: ANFO, hole: { diameter: 102 mm, stemming: 2.4 m, charge_length: 6 m }, burden: 2.7 "
    "m, "
    "spacing: { uniform: [2.8 m, 3.0 m] }, rock_density: 2700 kg/m3, breakout_angle: 90 deg }\n"
    "rocks: [{ name: face, density: 2700, shape: { type: disk, radius: { uniform: [0.1 m, 0.2 m] } }, "
    "release: { position: [0, 1] }, launch: { type: richards_moore, k: { uniform: [13, 15] } } }]\n"
    "stop: { time: 60 s }\n";

struct Loaded {
  std::optional<LoadedScenario> scenario;
  std::string messages;
};

Loaded load(const std::string& text, const std::string& table = "") {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("flyrock_rows_" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  std::ofstream(folder / "s.yaml") << text;
  std::ofstream(folder / "points.csv") << table;
  Diagnostics diagnostics;
  Loaded loaded{load_scenario((folder / "s.yaml").string(), {}, diagnostics), ""};
  loaded.messages = diagnostics.to_text();
  std::filesystem::remove_all(folder);
  return loaded;
}

/// With the session that owns its plugins.
LoadedScenario whole(const std::string& text, const std::string& table = "") {
  Loaded loaded = load(text, table);
  INFO(loaded.messages);
  REQUIRE(loaded.scenario);
  return std::move(*loaded.scenario);
}

const std::string rows =
    "sweep:\n  rows:\n    - { label: tight, blast.burden: 2.4 m, rocks.face.launch.k: 13 }\n"
    "    - { label: wide, blast.burden: 3 m, rocks.face.launch.k: 15 }\n"
    "    - { label: both, blast.burden: 2.4 m, rocks.face.launch.k: 15 }\n";

}  // namespace

TEST_CASE("a row of a sweep is a point that sets several paths") {
  const LoadedScenario plan_of = whole(blast + rows);
  const Plan& plan = plan_of.plan;
  REQUIRE(plan.points.size() == 3);
  CHECK(plan.points[1].blast->typical[BlastField::burden] == 3);
  CHECK(plan.points[2].blast->typical[BlastField::burden] == 2.4);
  CHECK(plan.points[2].rocks[0].launch->slots.size() == plan.points[0].rocks[0].launch->slots.size());
  REQUIRE(plan.axes.size() == 3);
  CHECK(plan.axes[0].name == "blast.burden");
  CHECK(plan.axes[1].name == "rocks.face.launch.k");
  CHECK(plan.at[2] == std::vector<double>{2.4, 15, 2});
  CHECK(plan.axes[2].label(plan.at[1][2]) == "wide");
}

TEST_CASE("a table of points says what the same rows say") {
  const LoadedScenario plan_of =
      whole(blast + "sweep: { table: points.csv }\n",
            "# points\nlabel;blast.burden [m];rocks.face.launch.k\ntight;2.4;13\nwide;3;15\nboth;2.4;15\n");
  const Plan& plan = plan_of.plan;
  const LoadedScenario listed_of = whole(blast + rows);
  const Plan& listed = listed_of.plan;
  CHECK(plan.at == listed.at);
  CHECK(plan.points[1].blast->typical[BlastField::burden] == 3);
  CHECK(plan.files.contains("points.csv"));
}

TEST_CASE("rows stand beside a grid only as its product") {
  const std::string swept = "gravity: { sweep: [9.8, 9.82] }\n";
  CHECK(load(blast + swept + rows).messages.find("gravity: is swept beside the rows of `sweep`") !=
        std::string::npos);
  const LoadedScenario plan_of = whole(blast + swept + rows + "  product: true\n");
  const Plan& plan = plan_of.plan;
  REQUIRE(plan.points.size() == 6);
  CHECK(plan.axes[2].name == "gravity");
  CHECK(plan.at[3] == std::vector<double>{3, 15, 9.82, 1});
}

TEST_CASE("rows that fit nowhere are errors at their place") {
  const auto said = [](const std::string& list) {
    return load(blast + "sweep: { rows: " + list + " }\n").messages;
  };
  CHECK(said("[{ blast.burden: 2 m }, { gravity: 9 }]").find("the first row does not set `gravity`") !=
        std::string::npos);
  CHECK(said("[{ blast.burden: 2 m, gravity: 9 }, { gravity: 9 }]").find("does not set `blast.burden`") !=
        std::string::npos);
  CHECK(said("[{ title: a }]").find("`title` takes no sweep") != std::string::npos);
  CHECK(said("[]").find("has 0 rows") != std::string::npos);
  CHECK(said("[{ blast.burden: { sweep: [1, 2] } }]").find("stands inside a row of a sweep") !=
        std::string::npos);
  CHECK(load(blast + "sweep: { table: none.csv }\n").messages.find("cannot read the file") !=
        std::string::npos);
  CHECK(load(blast + "sweep: { table: points.csv }\n", "blast.burden,gravity\n2\n")
            .messages.find("points.csv:2:1: error: sweep.table: has 1 values, expected 2") !=
        std::string::npos);
  const std::string two =
      load(blast + "sweep: { table: points.csv }\n", "blast.burden,gravity\n2\n3,9.8\n4\n").messages;
  CHECK(two.find("points.csv:2:1: error") != std::string::npos);  // a line each
  CHECK(two.find("points.csv:4:1: error") != std::string::npos);
  CHECK(load(blast + "sweep: { design: grid }\n").messages.find("design") != std::string::npos);
}

TEST_CASE("a design covers the draws of which a trial has one, and refuses what needs independent trials") {
  const LoadedScenario plan_of = whole(blast + "sampling: latin_hypercube\n");
  const Plan& plan = plan_of.plan;
  const Scenario& scenario = plan.points.front();
  for (const Draw& draw : scenario.draws) {
    INFO(draw.stream);
    CHECK(draw.dimension >= 0);  // one rock a trial, one hole
    std::set<int> parts;
    for (std::uint64_t t = 0; t < 2; ++t) {
      const double value = draw.value(scenario.streams, {.trial = t, .hole = 1, .rock = 1});
      parts.insert(value < draw.quantile(0.5) ? 0 : 1);
    }
    CHECK(parts.size() == 2);  // the two trials of the first replicate
  }
  CHECK(trials_of_unit(scenario) == 2);
  const auto said = [](const std::string& more) { return load(blast + more).messages; };
  CHECK(
      said("sampling: sobol\nclearance: [{ name: people, probability: 0.5 }]\n").find("has no `clearance`") !=
      std::string::npos);
  std::string odd = blast;
  odd.replace(odd.find("trials: 32"), 10, "trials: 48");
  CHECK(load(odd + "sampling: sobol\n").messages.find("16 times a power of two") != std::string::npos);
  CHECK(load(odd + "sampling: latin_hypercube\n").scenario.has_value());
  CHECK(said("sampling: halton\n").find("halton") != std::string::npos);
}

TEST_CASE("the interval of a mean is that of the replicates of its design") {
  GroupTally plain("", 1), designed("", 4);
  // 64 trials; in each replicate of 4 the same numbers 1, 2, 3, 4 and a small number of its own.
  for (GroupTally* tally : {&plain, &designed}) do {
      for (std::uint64_t t = 0; t < 64; ++t) {
        RockRecord rock;
        rock.trial = t;
        rock.reason = StopReason::stopped;
        rock.runout = static_cast<double>(1 + t % 4) + 0.01 * static_cast<double>(t / 4);
        tally->add(rock);
      }
    } while (tally->needs_another_pass());
  const std::size_t runout = rock_statistic("runout");
  const Interval independent = plain.summary().interval(runout, Statistic::mean),
                 replicated = designed.summary().interval(runout, Statistic::mean);
  // Means of 2.5, 2.51, ..., 2.65: their standard deviation is 0.0476, with 15 degrees of freedom.
  CHECK(replicated.upper - replicated.lower == Approx(2 * 2.131 * 0.04761 / 4).epsilon(1e-3));
  CHECK(independent.upper - independent.lower > 5 * (replicated.upper - replicated.lower));
}

}  // namespace sweep_rows_test
