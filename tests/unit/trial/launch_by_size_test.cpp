// The launch speed by the size of a rock.
#include <catch2/catch.hpp>
#include <cmath>

#include "load.h"
#include "unit/lua_fixture.h"

using namespace flyrock;

namespace launch_by_size_test {

constexpr double speed = 20, reference = 0.4;

std::string scenario_text(int dimension, const std::string& by_size, const std::string& shape = "") {
  const std::string drawn = dimension == 2
                                ? "{ type: disk, radius: { uniform: [4 cm, 40 cm] } }"
                                : "{ type: box, size: [20 cm, 30 cm, { uniform: [4 cm, 90 cm] }] }";
  return fmt::format(R"(flyrock: 1
dimension: {}
method: ballistic
terrain: {{ type: plane }}
rocks:
  - name: r
    per_trial: 20
    density: 2700 kg/m3
    release: {{ position: {} }}
    launch: {{ type: fixed, speed: {} m/s, elevation: 30 deg }}
    launch_by_size: {}
    shape: {}
stop: {{ time: 60 s }}
)",
                     dimension, dimension == 2 ? "[0, 5]" : "[0, 0, 5]", speed, by_size,
                     shape.empty() ? drawn : shape);
}

std::vector<RockRecord> rocks(const std::string& text) {
  const LuaFixture folder;
  folder.write("s.yaml", text);
  Diagnostics diagnostics;
  const auto scenario = load_scenario((folder.folder / "s.yaml").string(), {}, diagnostics);
  INFO(diagnostics.to_text());
  REQUIRE(scenario);
  return first_trial(*scenario).rocks;
}

/// Of the sphere of equal volume.
double diameter(const RockRecord& rock) { return std::cbrt(6 / pi * rock.mass / 2700); }

std::string errors(const std::string& text) {
  const LuaFixture folder;
  folder.write("s.yaml", text);
  Diagnostics diagnostics;
  load_scenario((folder.folder / "s.yaml").string(), {}, diagnostics);
  return diagnostics.to_text();
}

TEST_CASE("small rocks start faster, as a power of their size, and none beyond the limit") {
  for (const int dimension : {2, 3})
    for (const double exponent : {0.0, 0.5, 1.0, 2.3}) {
      INFO(dimension << "D, exponent " << exponent);
      bool some_limited = false, some_free = false;
      for (const RockRecord& rock :
           rocks(scenario_text(dimension, fmt::format("{{ reference: {} m, exponent: {}, at_most: 45 m/s }}",
                                                      reference, exponent)))) {
        const double free = speed * std::pow(reference / diameter(rock), exponent);
        CHECK(rock.launch_speed == Approx(std::min(free, 45.0)).epsilon(1e-9));
        CHECK(rock.launch_elevation == Approx(pi / 6));
        (free > 45 ? some_limited : some_free) = true;
      }
      CHECK(some_free);
      if (exponent > 2) CHECK(some_limited);
    }
}

TEST_CASE("without an exponent, speed times size is the same for all rocks") {
  for (const RockRecord& rock : rocks(scenario_text(2, fmt::format("{{ reference: {} m }}", reference))))
    CHECK(rock.launch_speed * diameter(rock) == Approx(speed * reference).epsilon(1e-9));
}

TEST_CASE("a launch by size needs a launch and a size") {
  std::string text = scenario_text(2, "{ reference: 0.4 m }");
  text.erase(text.find("    launch: "), text.find("    launch_by") - text.find("    launch: "));
  CHECK(errors(text).find("launch_by_size: changes the speed of `launch`, the group has none") !=
        std::string::npos);
  CHECK(errors(scenario_text(2, "{ exponent: 1 }")).find("`reference` is missing") != std::string::npos);
  CHECK(errors(scenario_text(2, "{ reference: 0 m }")).find("reference") != std::string::npos);
}

}  // namespace launch_by_size_test
