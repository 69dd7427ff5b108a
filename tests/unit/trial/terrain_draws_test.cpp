// When a terrain is built: once, or once a trial where it draws.

#include <catch2/catch.hpp>

#include "load/load.h"
#include "trial/build_trial.h"
#include "unit/lua_fixture.h"

using namespace flyrock;

namespace {

/// A scenario whose terrain is level at a height: `height` of the plugin's parameter, `height + draw` of what
/// it draws.
class Level {
 public:
  Level(const std::string& height, const std::string& draw) {
    files_.write(
        "level.lua",
        "local fr = require 'flyrock'\nreturn fr.plugin { kind = 'terrain', name = 'level', doc = 'd',\n"
        "params = { height = fr.number { doc = 'd' } }, build = function(p, rng)\n"
        "  local y = p.height + " +
            draw + "\n  return { points = { { -10, y }, { 10, y } } }\nend }");
    files_.write(
        "s.yaml",
        "flyrock: 1\ndimension: 2\nmethod: nscd\ntrials: 10\nplugins: [level.lua]\n"
        "terrain: { type: level, height: " +
            height +
            ", material: rock }\n"
            "materials: { rock: { restitution: { type: newton, en: 0.5 }, friction: { type: coulomb, mu: 0.5 "
            "} } }\n"
            "bodies: [{ name: ball, shape: { type: disk, radius: 0.1 }, mass: 1, position: [0, 5] }]\n"
            "stop: { time: 1 }\n");
    Diagnostics diagnostics;
    loaded_ = load_scenario((files_.folder / "s.yaml").string(), {}, diagnostics);
    INFO(diagnostics.to_text());
    REQUIRE(loaded_);
  }
  TrialBuilder<2> builder() const { return TrialBuilder<2>(loaded_->plan.points.front()); }

 private:
  LuaFixture files_;
  std::optional<LoadedScenario> loaded_;
};

double height(TrialBuilder<2>& builder, int trial) {
  return builder.terrain_of(trial)->profile().points.front().y();
}

}  // namespace

TEST_CASE("a terrain that draws from rng is another one in each trial, whichever trials were built before") {
  const Level level("1", "rng:uniform()");
  TrialBuilder<2> forwards = level.builder(), backwards = level.builder();
  std::vector<double> heights, again;
  for (int trial = 0; trial < 10; ++trial) heights.push_back(height(forwards, trial));
  for (int trial = 9; trial >= 0; --trial) again.insert(again.begin(), height(backwards, trial));
  CHECK(heights == again);
  std::sort(heights.begin(), heights.end());
  CHECK(std::adjacent_find(heights.begin(), heights.end()) == heights.end());
}

TEST_CASE(
    "a terrain with a distribution is another one in each trial, and one that draws nothing is built once") {
  const Level drawn("{ uniform: [1, 2] }", "0"), of_run("{ uniform: [1, 2], per: run }", "0"),
      constant("1", "0");
  TrialBuilder<2> of_trials = drawn.builder(), once_drawn = of_run.builder(), once = constant.builder();
  CHECK(height(of_trials, 0) != height(of_trials, 1));
  CHECK(once_drawn.terrain_of(0) == once_drawn.terrain_of(7));
  CHECK(once.terrain_of(0) == once.terrain_of(7));
}

TEST_CASE("the files of a terrain are read and hashed when the scenario is loaded, and never again") {
  LuaFixture files;
  files.write("level.asc", "ncols 3\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 1 1\n1 1 1\n1 1 1\n");
  files.write(
      "s.yaml",
      "flyrock: 1\ndimension: 3\nmethod: nscd\nterrain: { type: raster, file: level.asc, material: rock }\n"
      "materials: { rock: { restitution: { type: newton, en: 0.5 }, friction: { type: coulomb, mu: 0.5 } } "
      "}\n"
      "bodies: [{ name: ball, shape: { type: sphere, radius: 0.1 }, mass: 1, position: [1, 1, 5] }]\n"
      "stop: { time: 1 }\n");
  Diagnostics diagnostics;
  const std::string path = (files.folder / "s.yaml").string();
  const auto first = load_scenario(path, {}, diagnostics);
  REQUIRE(first);
  files.write("level.asc", "no raster any more");
  const auto again = load_scenario(path, {}, diagnostics, Prints::shown, &*first);
  INFO(diagnostics.to_text());
  REQUIRE(again);
  CHECK(again->hash == first->hash);
  TrialBuilder<3> one(first->plan.points.front()), other(again->plan.points.front());
  CHECK(one.terrain_of(0) == other.terrain_of(0));
}
