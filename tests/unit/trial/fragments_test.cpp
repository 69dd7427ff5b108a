// Populations of fragments: their sizes, and how many real ones each stands for.
#include <catch2/catch.hpp>

#include "load.h"
#include "trial/build_trial.h"
#include "unit/lua_fixture.h"

using namespace flyrock;

namespace {

std::string scenario_text(int dimension, const std::string& rocks) {
  return fmt::format(R"(flyrock: 1
dimension: {}
method: ballistic
terrain: {{ type: plane }}
blast:
  explosive: ANFO
  hole: {{ diameter: 102 mm, stemming: 2.6 m, charge_length: 4.4 m, subdrilling: 0 m }}
  burden: 2.7 m
  spacing: 2.9 m
trials: 1
rocks:
  - {{ name: r, density: 2700 kg/m3, release: {{ position: {} }}, launch: {{ type: fixed, velocity: {} }}, {} }}
stop: {{ time: 60 s }}
)",
                     dimension, dimension == 2 ? "[0, 5]" : "[0, 0, 5]",
                     dimension == 2 ? "[9, 9]" : "[9, 0, 9]", rocks);
}

template <int D>
std::vector<Body<D>> bodies(const std::string& rocks, int trial = 0) {
  const LuaFixture folder;
  folder.write("s.yaml", scenario_text(D, rocks));
  Diagnostics diagnostics;
  const auto scenario = load_scenario((folder.folder / "s.yaml").string(), {}, diagnostics);
  INFO(diagnostics.to_text());
  REQUIRE(scenario);
  const auto built = TrialBuilder<D>(scenario->plan.points.front()).build(static_cast<std::uint64_t>(trial));
  std::vector<Body<D>> result;
  for (const TrialRock& rock : built.rocks) {
    INFO(rock.fault);
    REQUIRE(rock.fault.empty());
    result.push_back(
        built.worlds[static_cast<std::size_t>(rock.world)].bodies[static_cast<std::size_t>(rock.body)]);
  }
  return result;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("fragments have the shape of their group, scaled to sizes of equal shares of the mass",
                       "", ((int D), D), 2, 3) {
  const std::string shape =
      D == 2 ? "{ type: wall, length: 2 m, radius: 0.3 m }" : "{ type: box, size: [1, 2, 3] }";
  const double low = 0.1, high = 0.8, median = 0.22, uniformity = 1.1;
  const auto rocks = bodies<D>(fmt::format(
      "type: fragments, per_trial: 40, volume: 1 m3, share: 1, median: {} m, uniformity: {}, least: {} m, "
      "greatest: {} m, shape: {}",
      median, uniformity, low, high, shape));
  REQUIRE(rocks.size() == 40);
  const auto below = [&](double x) { return 1 - std::pow(2, -std::pow(x / median, uniformity)); };
  for (std::size_t i = 0; i < rocks.size(); ++i) {
    const double size = 2 * rocks[i].radius, part = (below(size) - below(low)) / (below(high) - below(low));
    CHECK(part >= static_cast<double>(i) / 40 - 1e-9);
    CHECK(part <= static_cast<double>(i + 1) / 40 + 1e-9);
    // As slender as the shape of the group, whatever its size
    CHECK(rocks[i].size / size == Approx(rocks[0].size / (2 * rocks[0].radius)));
    CHECK(rocks[i].mass == Approx(2700 * pi / 6 * size * size * size));
  }
}

TEST_CASE("fragments of a blast are sampled from Kuz-Ram, and a shape with a mass of its own is refused") {
  const auto rocks = bodies<3>(
      "type: kuz_ram, per_trial: 1000, share: 0.01, rock_factor: 7, deviation: 0.25 m, least: 1 mm, "
      "shape: { type: sphere, radius: 1 m }");
  // The charge is that of ANFO in the hole; half of the mass is below Kuz-Ram's median.
  const double charge = 0.25 * pi * 0.102 * 0.102 * 4.4 * explosives().front().density;
  const double median =
      0.07 * std::pow(54.81 / charge, 0.8) * std::pow(charge, 1.0 / 6) * std::pow(1.15, 19.0 / 30);
  CHECK(2 * rocks[500].radius == Approx(median).epsilon(5e-3));
}
