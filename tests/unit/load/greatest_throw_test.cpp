// Launch models that were fitted to distances, flown otherwise.

#include "load/greatest_throw.h"

#include <fmt/format.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "load/load.h"

using namespace flyrock;

namespace {

namespace fs = std::filesystem;

/// Ninh Dan's hole with a burden of 2.7 m: v = 26.2 m/s for k = 27, 69.8 m by the published formula.
std::string scenario(const std::string& air, const std::string& launch) {
  return "flyrock: 1\ndimension: 2\nmethod: ballistic\ntrials: 3\n" + air +
         "terrain: { type: profile, points: [[-100, 0], [8000, 0]] }\n"
         "blast:\n"
         "  explosive: ANFO\n"
         "  hole: { diameter: 102 mm, stemming: 2.3 m, charge_length: 5 m }\n"
         "  burden: 2.7 m\n"
         "  rock_density: 2700 kg/m3\n"
         "  breakout_angle: 90 deg\n"
         "rocks:\n"
         "  - name: face\n"
         "    density: 2700 kg/m3\n"
         "    shape: { type: disk, radius: 0.1 m }\n"
         "    release: { position: [0, 0] }\n"
         "    launch: { type: " +
         launch +
         " }\n"
         "stop: { time: 60 s }\n";
}

std::vector<std::string> warnings_of(const std::string& text) {
  const fs::path path = fs::temp_directory_path() / fmt::format("flyrock_greatest_throw_{}.yaml", ::getpid());
  std::ofstream(path) << text;
  Diagnostics diagnostics;
  const auto loaded = load_scenario(path.string(), {}, diagnostics);
  fs::remove(path);
  INFO(diagnostics.to_text());
  REQUIRE(loaded);
  return loaded->warnings;
}

const std::string air = "air: { cd: 1 }\n";

}  // namespace

TEST_CASE("A distance model that is flown with drag, or lower, is warned of with what it changes") {
  const std::vector<std::string> drag = warnings_of(scenario(air, "richards_moore, k: 27"));
  REQUIRE(drag.size() == 1);
  CHECK(drag[0] ==
        "rocks.0.launch: richards_moore (k 27, face_burst) was fitted to the greatest throw, in air and at "
        "its best angle. With drag, which "
        "these distances already contain, the farthest rock of `face` lands at 63.9 m on level ground, where "
        "the published formula "
        "gives 69.8 m. Leave out `air` and `elevation`, or take a model of launch speeds "
        "(docs/which-model.md)");
  const std::vector<std::string> low = warnings_of(scenario("", "richards_moore, k: 27, elevation: 20 deg"));
  REQUIRE(low.size() == 1);
  CHECK(low[0].find("At other angles the farthest rock of `face` lands at 44.9 m") != std::string::npos);
  const std::vector<std::string> both = warnings_of(scenario(air, "lundborg, elevation: 20 deg"));
  REQUIRE(both.size() == 1);
  CHECK(both[0].find("With drag, and at other angles,") != std::string::npos);
  CHECK(both[0].find("gives 101 m") != std::string::npos);
}

TEST_CASE("A distance model as it was fitted, and a model of speeds, are not warned of") {
  for (const char* launch :
       {"richards_moore, k: 27", "richards_moore, k: 27, elevation: 45 deg", "mckenzie", "lundborg",
        "richards_moore, k: 27, mode: stemming_ejection, drill_angle: 80 deg"})
    CHECK(warnings_of(scenario("", launch)).empty());
  for (const char* launch : {"gurney, elevation: 20 deg", "fixed, speed: 20, elevation: 20 deg"})
    CHECK(warnings_of(scenario(air, launch)).empty());
}

TEST_CASE("Of a sweep the point that falls shortest is named") {
  const std::vector<std::string> found =
      warnings_of(scenario("air: { cd: { sweep: [0, 0.5, 1] } }\n", "mckenzie"));
  REQUIRE(found.size() == 1);
  CHECK(found[0].find("(point 2)") != std::string::npos);
}

TEST_CASE("The quarry's scenarios have one k a site and fly their distance models as they were fitted",
          "[slow]") {
  int seen = 0;
  for (const auto& entry : fs::directory_iterator(FLYROCK_SOURCE_DIR "/scenarios/quarry")) {
    if (entry.path().extension() == ".csv") continue;  // a table of a scenario
    Diagnostics diagnostics;
    const auto loaded = load_scenario(entry.path().string(), {}, diagnostics);
    INFO(entry.path() << diagnostics.to_text());
    REQUIRE(loaded);
    // A run has one k: what nobody knows of it differs from run to run.
    for (const Draw& draw : loaded->plan.points.front().draws)
      CHECK_FALSE((draw.stream.ends_with(".launch.k") && draw.scope != Scope::run));
    CHECK(diagnostics.to_text().find("published formula") == std::string::npos);
    ++seen;
  }
  CHECK(seen >= 4);
}
