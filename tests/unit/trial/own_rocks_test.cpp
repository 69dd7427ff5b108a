// Lua in 3D in scenarios: rocks of a population with values of their own, places that laws see, and a slope
// far from 0.
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "load.h"
#include "trial/build_trial.h"
#include "unit/lua_fixture.h"

using namespace flyrock;

TEST_CASE("rocks of a population in 3D bring mass, shape, attitude, velocity and spin of their own") {
  const LoadedScenario scenario = loaded("tests/unit/trial/own_rocks.yaml");
  const Scenario& point = scenario.plan.points.front();
  const auto trial = TrialBuilder<3>(point).build(0);
  REQUIRE(trial.worlds.size() == 4);
  const auto rock = [&](int i) -> const Body<3>& { return trial.worlds[i].bodies.front(); };
  const double sphere = pi / 6;
  CHECK(rock(0).x == Vec3(10, 20, -5 + 3));
  CHECK(rock(0).v == Vec3(1, 2, 3));
  CHECK(rock(0).w == Vec3(4, 5, 6));
  CHECK(rock(0).mass == Approx(2700 * sphere));
  CHECK(trial.rocks[0].launch_speed == Approx(std::sqrt(14.0)));
  CHECK(trial.rocks[0].note.find("rock_contacts") != std::string::npos);
  CHECK((rock(1).v - Vec3(3, 0, 0)).norm() < 1e-9);  // launched by its group
  CHECK(rock(1).w == Vec3(0, 0, 7));
  CHECK(rock(1).mass == 100);
  CHECK(rock(2).mass == Approx(8000 / 6.0));
  CHECK(rock(2).contactors.front().points.size() == 4);
  CHECK(rock(3).contactors.size() == 2);
  CHECK(rock(3).volume == Approx(2 * sphere));
}

TEST_CASE("laws see the place of a contact in the coordinates of the scenario, its normal and its slip") {
  const TrialRecords records = first_trial(loaded("tests/unit/trial/own_rocks.yaml"));
  REQUIRE(records.rocks.size() == 4);
  for (const RockRecord& rock : records.rocks) {
    INFO(rock.fault);
    CHECK(rock.reason != StopReason::plugin_error);
    CHECK(rock.reason != StopReason::not_started);
    CHECK(rock.impacts > 0);
  }
}

TEST_CASE("a rock without a shape of its own, in a group without one, is refused") {
  const LuaFixture folder;
  folder.write("bare.lua",
               "local fr = require 'flyrock'\nfr.plugin { kind = 'population', name = 'bare', doc = "
               "'d', rocks = function(p) return { {} } end }");
  folder.write("bare.yaml", R"(flyrock: 1
dimension: 3
method: nscd
plugins: [bare.lua]
terrain: { type: plane, material: rock }
materials: { rock: { friction: { type: coulomb, mu: 0.5 } } }
rocks: [{ name: r, type: bare, density: 2700, release: { position: [0, 0, 1] } }]
stop: { time: 1 s }
)");
  Diagnostics diagnostics;
  const auto scenario = load_scenario((folder.folder / "bare.yaml").string(), {}, diagnostics);
  REQUIRE(scenario);
  const auto trial = TrialBuilder<3>(scenario->plan.points.front()).build(0);
  CHECK(trial.rocks.at(0).fault == "neither the population nor `shape` says what shape a rock has");
  CHECK(trial.rocks[0].fault_path == "rocks.0.shape");
}

TEST_CASE("the natural slope gives the same rocks in national coordinates and at (0, 0, 0), to 1e-6 m") {
  std::ifstream file(FLYROCK_SOURCE_DIR "/scenarios/rockfall/natural_slope.lua");
  std::ostringstream content;
  content << file.rdbuf();
  const std::string text = content.str(), place = "local east, north, level = 2600000, 1200000, 500";
  REQUIRE(text.find(place) != std::string::npos);
  const LuaFixture folder;
  const auto rocks_at = [&](const std::string& name, const std::string& own_place) {
    std::string moved = text;
    folder.write(name, moved.replace(moved.find(place), place.size(), own_place));
    Diagnostics diagnostics;
    // The first 6 s: down the cliff and over the scree.
    const auto scenario =
        load_scenario((folder.folder / name).string(), {.set = {"stop.time=6s"}}, diagnostics);
    INFO(diagnostics.to_text());
    REQUIRE(scenario);
    return first_trial(*scenario).rocks;
  };
  const auto far = rocks_at("far.lua", place);
  const auto near = rocks_at("near.lua", "local east, north, level = 0, 0, 0");
  REQUIRE((far.size() == 2 && near.size() == 2));
  for (std::size_t i = 0; i < far.size(); ++i) {
    CHECK(far[i].impacts > 10);
    CHECK(far[i].impacts == near[i].impacts);
    CHECK(std::abs(far[i].stop_x - 2600000 - near[i].stop_x) < 1e-6);
    CHECK(std::abs(far[i].stop_y - 1200000 - near[i].stop_y) < 1e-6);
    CHECK(std::abs(far[i].stop_z - 500 - near[i].stop_z) < 1e-6);
    CHECK(std::abs(far[i].runout - near[i].runout) < 1e-6);
    CHECK(std::abs(far[i].max_speed - near[i].max_speed) < 1e-6);
  }
}
