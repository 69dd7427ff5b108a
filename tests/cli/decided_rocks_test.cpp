// Rocks that leave the domain, and the gates at which they can no longer arrive.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.h"

using namespace flyrock::test;

TEST_CASE("A rock that left the domain censors only the gates to which it may still come back") {
  const Folder folder;
  // All leave at x = 25 m, 46.1 m high by their energy. The ground is 41 m high at `near`, 56.25 m at `up`.
  folder.write("cliff.yaml", R"(flyrock: 1
dimension: 2
method: ballistic
trials: 20
terrain: { type: profile, points: [[-50, 60], [-10, 45], [0, 40], [10, 0], [25, 0]] }
rocks:
  - name: face
    density: 2700 kg/m3
    shape: { type: disk, radius: 0.1 m }
    release: { position: [0, 41] }
    launch: { type: fixed, speed: 10 m/s, elevation: { uniform: [0 deg, 1 deg] } }
gates: [{ name: road, x: 20 m }, { name: near, x: -2 m }, { name: up, x: -40 m }]
stop: { time: 60 s }
)");
  for (const char* rows : {"true", "false"}) {
    const Output run =
        call(folder, std::string("run cliff.yaml -o out --force --quiet --set output.rocks=") + rows);
    INFO(run.err);
    REQUIRE(run.code == 0);
    const auto point = nlohmann::json::parse(read(folder.path() / "out/summary.json")).at("points")[0];
    CHECK(point.at("rocks")[0].at("stop_reasons").at("left_domain") == 20);
    const auto& gates = point.at("gates");
    CHECK(gates[0].at("passed") == 1);
    CHECK(gates[0].at("lower_bounds") == false);
    CHECK(gates[1].at("lower_bounds") == true);
    CHECK(gates[2].at("passed") == 0);
    CHECK(gates[2].at("lower_bounds") == false);
  }
}
