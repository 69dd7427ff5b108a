// Several runs of a scenario (`outer`), each with its own draws `per: run`.
#include "results/measured/outer.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "load.h"
#include "results/results.h"
#include "unit/lua_fixture.h"

using namespace flyrock;

namespace outer_test {

/// Rocks that start from the ground at 45 degrees and land at v^2 / g. The speed is drawn `per: run`, and in
/// addition `turn` may be drawn.
std::string scenario_text(const std::string& head, const std::string& elevation = "45 deg",
                          const std::string& tail = "") {
  return fmt::format(R"(flyrock: 1
dimension: 2
method: ballistic
{}
terrain: {{ type: profile, points: [[-10, 0], [2000, 0]] }}
rocks:
  - name: r
    density: 2700 kg/m3
    release: {{ position: [0, 0.001] }}
    launch: {{ type: fixed, speed: {{ uniform: [20, 40], per: run }}, elevation: {} }}
    shape: {{ type: disk, radius: 0.001 }}
stop: {{ time: 60 s }}
{}
)",
                     head, elevation, tail);
}

struct Loaded {
  explicit Loaded(const std::string& text) {
    files.write("s.yaml", text);
    Diagnostics diagnostics;
    scenario = load_scenario((files.folder / "s.yaml").string(), {}, diagnostics);
    messages = diagnostics.to_text();
  }
  const Scenario& first() const { return scenario->plan.points.front(); }
  TrialRecords run(std::uint64_t trials) const {
    TrialRunner runner(first());
    TrialRecords records;
    for (std::uint64_t trial = 0; trial < trials; ++trial) runner.run(trial, records);
    return records;
  }
  Results results(std::uint64_t trials) const {
    const RunFacts facts{.trials = {trials}, .full = true, .ended_early = {}, .warnings = {}};
    return make_results(scenario->plan, {rows_of(run(trials))}, facts);
  }

  LuaFixture files;
  std::optional<LoadedScenario> scenario;
  std::string messages;
};

double range(double speed) { return speed * speed / 9.81; }

TEST_CASE("each run of `outer` has its own draw per run, and percentiles are over the runs") {
  const Loaded loaded(scenario_text("trials: 7\nouter: 30"));
  INFO(loaded.messages);
  REQUIRE(loaded.scenario);
  CHECK(loaded.first().trials == 210);
  const TrialRecords records = loaded.run(210);
  const Draw& draw = loaded.first().draws.front();
  std::vector<double> ranges;
  for (std::uint64_t run = 0; run < 30; ++run) {
    // The number of a run is the draw of a scenario of one run at this place of its stream.
    const double speed =
        draw.quantile(uniform_at(loaded.first().streams.seed, draw.stream_hash, {.trial = run}));
    ranges.push_back(range(speed));
    for (std::uint64_t trial = 7 * run; trial < 7 * (run + 1); ++trial)
      CHECK(records.rocks[trial].launch_speed == Approx(speed).epsilon(1e-12));
  }
  const Results results = loaded.results(210);
  REQUIRE(results.points.front().outer);
  const OuterSummary& outer = *results.points.front().outer;
  CHECK(outer.runs == 30);
  CHECK(outer.trials == 7);
  std::sort(ranges.begin(), ranges.end());
  const auto quantile = [&](double p) {  // linear between the order statistics
    const double h = p * 29;
    const auto low = static_cast<std::size_t>(h);
    return ranges[low] + (h - std::floor(h)) * (ranges[std::min<std::size_t>(low + 1, 29)] - ranges[low]);
  };
  // Within a run all rocks land at the same place, so that each percentile of a run is that place.
  for (const char* measure :
       {"rocks.runout.p50", "rocks.runout.p99", "rocks.runout.mean", "rocks.runout.max"}) {
    INFO(measure);
    const OuterNumber* number = outer.find(measure);
    REQUIRE(number);
    CHECK(number->unit == "m");
    CHECK(number->runs == 30);
    CHECK(number->min.value == Approx(ranges.front()).epsilon(2e-4));
    CHECK(number->p5.value == Approx(quantile(0.05)).epsilon(2e-4));
    CHECK(number->p50.value == Approx(quantile(0.5)).epsilon(2e-4));
    CHECK(number->p95.value == Approx(quantile(0.95)).epsilon(2e-4));
    CHECK(number->max.value == Approx(ranges.back()).epsilon(2e-4));
  }
  CHECK(results.points.front().groups.front().count == 210);  // all runs together
}

TEST_CASE("the first run of `outer` is the run without it") {
  const std::string elevation = "{ uniform: [20 deg, 60 deg] }";
  const Loaded one(scenario_text("trials: 5", elevation)),
      several(scenario_text("trials: 5\nouter: 3", elevation));
  REQUIRE(one.scenario);
  REQUIRE(several.scenario);
  const TrialRecords alone = one.run(5), all = several.run(15);
  for (std::size_t i = 0; i < 5; ++i) CHECK(all.rocks[i].runout == alone.rocks[i].runout);
  CHECK(all.rocks[5].launch_speed != all.rocks[4].launch_speed);
  CHECK_FALSE(one.results(5).points.front().outer);
  CHECK_FALSE(several.results(9).points.front().outer);  // not all trials ran
}

TEST_CASE("clearances and exposures have a number of each run") {
  const Loaded loaded(scenario_text("trials: 40\nouter: 4", "{ uniform: [20 deg, 60 deg] }",
                                    "clearance: [{ name: people, probability: 0.5, factor: 2 }]\n"
                                    "exposure: [{ name: road, at: 80, spread: 30 deg }]"));
  INFO(loaded.messages);
  REQUIRE(loaded.scenario);
  const Results results = loaded.results(160);
  const OuterSummary& outer = *results.points.front().outer;
  const OuterNumber *distance = outer.find("clearance.people.distance"),
                    *doubled = outer.find("clearance.people.with_factor"),
                    *hit = outer.find("exposure.road.per_blast");
  REQUIRE(distance);
  REQUIRE(doubled);
  REQUIRE(hit);
  CHECK(distance->runs == 4);
  CHECK(doubled->p50.value == Approx(2 * distance->p50.value));
  // All runs have as many trials and the same kernel, so that their mean is that of all.
  CHECK(hit->mean.value == Approx(results.points.front().exposures.front().per_blast.upper));
  CHECK(hit->min.value < hit->max.value);
}

TEST_CASE("`outer` without a draw per run is warned of, and what it needs is said") {
  std::string constant = scenario_text("trials: 5\nouter: 3");
  constant.replace(constant.find("{ uniform: [20, 40], per: run }"), 31, "30");
  const Loaded alike(constant);
  CHECK(alike.scenario);
  CHECK(alike.messages.find("no distribution has `per: run`") != std::string::npos);
  const Loaded without(scenario_text("outer: 3\noutput: { rocks: false }"));
  CHECK_FALSE(without.scenario);
  CHECK(without.messages.find("needs the row of each rock") != std::string::npos);
  const Loaded none(scenario_text("outer: 0"));
  CHECK_FALSE(none.scenario);
}

TEST_CASE("terrain drawn per run is another one in each run of `outer`") {
  std::string text = scenario_text("trials: 2\nouter: 2");
  text.replace(text.find("{ type: profile"), text.find("\nrocks") - text.find("{ type: profile"),
               "{ type: benches, count: 1, height: { uniform: [5 m, 15 m], per: run }, face_angle: 80 deg, "
               "berm: 0 m, floor: 900 m }");
  text.replace(text.find("[0, 0.001]"), 10, "[0, 0]");
  text.replace(text.find("position: [0, 0]"), 16, "x: -1, above_ground: 1");
  const Loaded loaded(text);
  INFO(loaded.messages);
  REQUIRE(loaded.scenario);
  const TrialRecords records = loaded.run(4);
  CHECK(records.rocks[0].start_y == records.rocks[1].start_y);
  CHECK(records.rocks[2].start_y == records.rocks[3].start_y);
  CHECK(records.rocks[1].start_y != records.rocks[2].start_y);
}

}  // namespace outer_test
