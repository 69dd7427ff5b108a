// Several runs of a scenario, and the map of hits, as the program writes them.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "program.h"

using namespace flyrock::test;

namespace outer_cli_test {

const char* const scenario = R"(flyrock: 1
dimension: 3
method: ballistic
trials: 30
outer: 5
terrain: { type: benches, count: 1, height: 12 m, face_angle: 75 deg, berm: 0 m, floor: 300 m, length: 300 m }
rocks:
  - name: thrown
    per_trial: 4
    density: 2700 kg/m3
    shape: { type: sphere, radius: 0.1 m }
    release: { from: face, bench: 1 }
    launch: { type: fixed, speed: { uniform: [15 m/s, 30 m/s], per: run }, elevation: 30 deg, azimuth: { uniform: [-20 deg, 20 deg] } }
stop: { time: 60 s }
)";

nlohmann::json summary_of(const Folder& folder, const std::string& result) {
  return nlohmann::json::parse(read(folder.path() / result / "summary.json"));
}

TEST_CASE("runs of `outer` have the same bytes over threads and shards, and a sentence in the answer",
          "[slow]") {
  const Folder folder;
  folder.write("s.yaml", scenario);
  call_well(folder, "run s.yaml -o one -j 1 --quiet");
  call_well(folder, "run s.yaml -o two -j 2 --quiet");
  for (const char* shard : {"1/2", "2/2"})
    call_well(folder, std::string("run s.yaml --quiet -o shard") + shard[0] + " --shard " + shard);
  call_well(folder, "merge shard1 shard2 -o merged --quiet");
  for (const char* other : {"two", "merged"})
    for (const char* file : {"summary.json", "rocks.csv"}) {
      INFO(other << "/" << file);
      CHECK(read(folder.path() / "one" / file) == read(folder.path() / other / file));
    }

  const nlohmann::json summary = summary_of(folder, "one"), outer = summary.at("points").at(0).at("outer");
  CHECK(summary.at("trials") == 150);
  CHECK(outer.at("runs") == 5);
  CHECK(outer.at("trials") == 30);
  const nlohmann::json& speed = outer.at("numbers").at("rocks.launch_speed.mean");
  CHECK(speed.at("min") >= 15);
  CHECK(speed.at("max") <= 30);
  CHECK(speed.at("min") < speed.at("max"));
  CHECK(summary.at("answer").get<std::string>().find("Between 5 runs of 30 trials") != std::string::npos);
  CHECK(read(folder.path() / "one/report.html").find("outer_section") != std::string::npos);
}

TEST_CASE("the map of hits gives the landings of a blast, and other methods have none", "[slow]") {
  const Folder folder;
  folder.write("s.yaml", scenario);
  call_well(folder, "run s.yaml -o r --quiet");
  const Output done = call_well(folder, "export r --to asc");
  CHECK(done.out.find("Hit_density-p0.asc") != std::string::npos);
  std::istringstream text(read(folder.path() / "r/asc/Hit_density-p0.asc"));
  std::string word;
  double cell = 0, hits = 0;
  for (int line = 0; line < 6; ++line) {
    std::string name;
    text >> name >> word;
    if (name == "cellsize") cell = std::stod(word);
  }
  for (double value = 0; text >> value;)
    if (value > 0) hits += value * cell * cell;
  const nlohmann::json all = summary_of(folder, "r").at("points").at(0).at("rocks").at(0);
  CHECK(hits == Approx(all.at("stop_reasons").at("stopped").get<double>() / 150));

  std::string bounce = scenario;
  bounce.replace(bounce.find("ballistic"), 9, "lumped_mass");
  bounce.replace(bounce.find("length: 300 m }"), 15,
                 "length: 300 m, materials: { face: rock, berm: rock, floor: rock } }\n"
                 "materials: { rock: { restitution: { type: newton, en: 0.3 }, friction: { type: coulomb, "
                 "mu: 0.6 } } }");
  folder.write("b.yaml", bounce);
  call_well(folder, "run b.yaml -o b --quiet");
  const Output exported = call(folder, "export b --to asc");
  CHECK(exported.out.find("Nr_deposited-p0.asc") != std::string::npos);
  CHECK(exported.out.find("Hit_density") == std::string::npos);
}

TEST_CASE("the report lists all inputs with their units and where they are from") {
  const Folder folder;
  folder.write("s.yaml", scenario);
  call_well(folder, "run s.yaml -o r --quiet");
  const std::string page = read(folder.path() / "r/report.html");
  for (const char* input : {R"({"path":"terrain.height","value":"12 m","from":"line 6"})",
                            R"({"path":"rocks.thrown.density","value":"2700 kg/m3","from":"line 10"})",
                            R"({"path":"gravity","value":"9.81 m/s2","from":null})",
                            R"("value":"{ uniform: [15 m/s, 30 m/s], per: run }")"}) {
    INFO(input);
    CHECK(page.find(input) != std::string::npos);
  }
}

}  // namespace outer_cli_test
