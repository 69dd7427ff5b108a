// When bodies of dense steps are at rest, at a stop speed far below the usual one.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "../dice.h"
#include "program.h"
#include "rows.h"

using namespace flyrock::test;

namespace pile_at_rest {

/// Runs bodies on a profile, with other sections in `more`, into `out`.
void run_bodies(const Folder& folder, const std::string& points, const std::string& rolling,
                const std::string& more, const std::string& bodies) {
  folder.write("bodies.yaml", fmt::format(R"(flyrock: 1
dimension: 2
method: nscd
terrain: {{ type: profile, points: {}, material: rock }}
materials:
  rock:
    restitution: {{ type: newton, en: 0 }}
    friction: {{ type: coulomb, mu: 0.5 }}
    rolling: {{ type: rolling_resistance, mu_r: {} }}
{}
bodies:
{})",
                                          points, rolling, more, bodies));
  const Output run = call(folder, "run bodies.yaml --quiet -o out -j1");
  INFO(run.err);
  REQUIRE(run.code == 0);
}

/// A run with a stop speed of 1 mm/s: what a query finds about its rocks.
std::vector<std::string> ends_of(const std::string& points, const std::string& rolling,
                                 const std::string& steps, const std::string& time, const std::string& bodies,
                                 const std::string& select) {
  const Folder folder;
  run_bodies(folder, points, rolling,
             fmt::format("solver: {{ bodies: {} }}\nstop: {{ time: {}, speed: 1 mm/s }}", steps, time),
             bodies);
  return query(folder.path() / "out" / "results.db", select);
}

constexpr const char* pit = "[[-33, 30], [-4.5, 30], [-3.5, 0], [3.5, 0], [4.5, 30], [33, 30]]";

/// Disks above the pit, of which the last one falls until 1.2 s.
std::string disks(unsigned seed) {
  flyrock::Dice dice(seed);
  std::string bodies;
  for (int k = 0; k < 120; ++k) {
    const int row = k / 11, column = k % 11;
    const double radius = dice(0.15, 0.25), aside = dice(-0.015, 0.015);
    bodies += fmt::format(
        "  - {{ name: d{}, shape: {{ type: disk, radius: {:.4f} m }}, density: 2700 kg/m3, material: rock, "
        "position: [{:.4f}, {:.4f}] }}\n",
        k, radius, 0.54 * (column - 5) + 0.2 * (row % 2) + aside, 0.3 + 0.55 * row);
  }
  return bodies;
}

TEST_CASE("a settled pile of 120 disks is at rest soon at a stop speed of 1 mm/s", "[slow]") {
  for (const unsigned seed : {5u, 10u}) {
    INFO("seed " << seed);  // from 6.2 s on, all that has been slow for 5 s would count as at rest
    CHECK(ends_of(pit, "1 mm", "auto", "4.5 s", disks(seed),
                  "select stop_reason, count(*) from rocks group by stop_reason") ==
          std::vector<std::string>{"stopped|120"});
  }
}

TEST_CASE("a pile has settled soon below 1 mm/s", "[slow]") {
  const Folder folder;
  run_bodies(folder, pit, "1 mm", "settle: { until: 1 mm/s, at_most: 10 s }\nstop: { time: 10 ms, speed: 0 }",
             disks(5));
  const nlohmann::json summary = nlohmann::json::parse(read(folder.path() / "out" / "summary.json"));
  CHECK(summary["points"][0]["solver"]["dense_steps"].get<int>() < 4.5 / 4e-3);  // of 4 ms
}

TEST_CASE("a block that topples slower than the stop speed at first ends on its side, in dense steps too") {
  for (const double tilt : {1e-4, 3e-4, 1e-3})
    for (const char* steps : {"exact", "dense"}) {
      const std::string body = fmt::format(
          "  - {{ name: block, shape: {{ type: polygon, vertices: [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], "
          "[-0.5, 0.5]] }}, density: 2700 kg/m3, material: rock, position: [0, {:.9f}], "
          "orientation: {} rad }}\n",
          std::sqrt(0.5) * std::cos(tilt) + 1e-9, flyrock::pi / 4 - tilt);
      INFO(tilt << " rad, " << steps);
      CHECK(ends_of("[[-10, 0], [10, 0]]", "0 mm", steps, "30 s", body,
                    "select stop_reason, round(stop_y_m, 3) from rocks") ==
            std::vector<std::string>{"stopped|0.5"});
    }
}

}  // namespace pile_at_rest
