// Round rocks on ground with rolling resistance come to rest, and `check` says where they do not.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "program.h"

using namespace flyrock::test;

namespace rolling_test {

/// A surveyed slope of 40 m with bumps of decimetres, which runs out into a floor.
std::string survey() {
  constexpr int columns = 61, rows = 31;
  std::string text = fmt::format("ncols {}\nnrows {}\nxllcorner 0\nyllcorner 0\ncellsize 2\n", columns, rows);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double bump = 0.3 * std::sin(1.7 * column + 0.4 * row) * std::cos(1.1 * row - 0.2 * column);
      text += fmt::format("{:.3f} ", 24 * std::exp(-column / 15.0) + bump);
    }
    text += "\n";
  }
  return text;
}

/// Spheres that roll down this slope, on ground with the given rolling law.
std::string spheres_on(const std::string& rolling) {
  return R"(flyrock: 1
dimension: 3
method: nscd
trials: 20
terrain: { type: raster, file: slope.asc, material: scree }
materials: { scree: { restitution: { type: newton, en: 0.3 }, friction: { type: coulomb, mu: 0.6 })" +
         rolling + R"( } }
rocks:
  - name: boulders
    density: 2700 kg/m3
    shape: { type: sphere, radius: { uniform: [0.3 m, 0.5 m] } }
    release: { inside: [[5, 20], [10, 20], [10, 40], [5, 40]], above_ground: 1 m }
    launch: { type: fixed, velocity: [2 m/s, 0 m/s, 0 m/s] }
stop: { time: 120 s }
)";
}

struct Case {
  const char* rolling;
  const char* warning;  ///< of `check`; empty: a sound scenario
};

}  // namespace rolling_test

TEST_CASE("Round rocks come to rest on surveyed ground, whatever its law of rolling says about their pivot") {
  const Folder folder;
  folder.write("slope.asc", rolling_test::survey());
  for (const char* law :
       {"mu_r: 0.1 m", "share: 0.25", "mu_r: 0.1 m, mu_spin: 0 m", "share: 0.25, mu_spin: 1 m"}) {
    INFO(law);
    folder.write("spheres.yaml",
                 rolling_test::spheres_on(fmt::format(", rolling: {{ type: rolling_resistance, {} }}", law)));
    const Output run = call(folder, "run spheres.yaml --quiet -o out --force");
    INFO(run.out << run.err);
    REQUIRE(run.code == 0);
    const std::string rows = read(folder.path() / "out/rocks.csv");
    CHECK(std::count(rows.begin(), rows.end(), '\n') == 21);
    CHECK(rows.find("timed_out") == std::string::npos);
  }
}

TEST_CASE("`check` warns of ground on which round rocks roll or pivot until stop.time") {
  const Folder folder;
  folder.write("slope.asc", rolling_test::survey());
  const rolling_test::Case cases[] = {
      {", rolling: { type: rolling_resistance, mu_r: 0.1 m }", ""},
      {", rolling: { type: rolling_resistance, share: 0.2 }", ""},
      {", rolling: { type: rolling_resistance, mu_r: 0.1 m, mu_spin: 0 }", ""},
      {"", "materials.scree: has no `rolling`, and `boulders` is round"},
      {", rolling: { type: rolling_resistance, mu_r: 0 }",
       "materials.scree.rolling: its mu_r is 0, and `boulders` is round"},
      {", rolling: { type: rolling_resistance, mu_r: 0.01 mm }",
       "materials.scree.rolling: its mu_r of 1e-05 m stops `boulders`"},
      {", rolling: { type: rolling_resistance, mu_r: 0.1 m, mu_spin: 0.01 mm }",
       "materials.scree.rolling: its mu_spin of 1e-05 m stops a pivot"},
  };
  for (const rolling_test::Case& one : cases) {
    INFO(one.rolling);
    folder.write("spheres.yaml", rolling_test::spheres_on(one.rolling));
    const Output check = call(folder, "check spheres.yaml");
    INFO(check.out << check.err);
    CHECK(check.code == 0);
    if (*one.warning)
      CHECK(check.err.find(one.warning) != std::string::npos);
    else
      CHECK(check.err.empty());
  }
}
