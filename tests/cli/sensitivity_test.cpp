// Which input explains how much, as a user asks it: functions with known indices as launch models in Lua.

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <vector>

#include "cli/program.h"

namespace flyrock::sensitivity_test {

namespace {

using namespace flyrock::test;
using Json = nlohmann::json;

/// A rock that lands at the distance of Ishigami's function of three numbers, and 100 m.
const std::string ishigami_plugin = R"(local fr = require "flyrock"
return fr.plugin {
  kind = "velocity", name = "ishigami", doc = "A distance.",
  params = { x1 = fr.number { doc = "first" }, x2 = fr.number { doc = "second" }, x3 = fr.number { doc = "third" } },
  reads = {},
  launch = function(p, rock, blast, rng)
    local x = { math.pi * (2 * p.x1 - 1), math.pi * (2 * p.x2 - 1), math.pi * (2 * p.x3 - 1) }
    local f = math.sin(x[1]) + 7 * math.sin(x[2]) ^ 2 + 0.1 * x[3] ^ 4 * math.sin(x[1])
    local v = math.sqrt(9.81 * (100 + f) / 2)
    return { velocity = { v, v } }
  end,
}
)";

const std::string ishigami_scenario =
    "flyrock: 1\ntitle: Ishigami\ndimension: 2\nmethod: ballistic\ntrials: 1024\nplugins: [ishigami.lua]\n"
    "terrain: { type: profile, points: [[-50, 0], [500, 0]] }\n"
    "rocks:\n  - name: stones\n    density: 2700\n    shape: { type: disk, radius: 0.1 m }\n"
    "    release: { position: [0, 0] }\n"
    "    launch: { type: ishigami, x1: { uniform: [0, 1] }, x2: { uniform: [0, 1] }, x3: { uniform: [0, 1] } "
    "}\n"
    "stop: { time: 60 s }\n";

/// Three launch models of the same blast, on level ground.
const std::string blast_scenario =
    "flyrock: 1\ntitle: Models\ndimension: 2\nmethod: ballistic\ntrials: 256\nseed: 6\n"
    "terrain: { type: profile, points: [[-20, 0], [2000, 0]] }\n"
    "blast:\n  explosive: ANFO\n  hole: { diameter: 102 mm, length: 10.6 m, subdrilling: 0.6 m, "
    "stemming: { uniform: [2.1 m, 2.7 m] } }\n  burden: { uniform: [2.4 m, 3.0 m] }\n"
    "  spacing: { uniform: [2.6 m, 3.2 m] }\n  rock_density: 2700 kg/m3\n  breakout_angle: 90 deg\n"
    "rocks:\n"
    "  - { name: face, density: 2700, shape: { type: disk, radius: 0.1 m }, release: { position: [0, 1] }, "
    "launch: { type: richards_moore, k: 14 } }\n"
    "  - { name: collar, density: 2700, shape: { type: disk, radius: 0.1 m }, release: { position: [0, 1] }, "
    "launch: { type: richards_moore, mode: cratering, k: 14 } }\n"
    "stop: { time: 60 s }\n";

Json result_of(const Folder& folder, const std::string& out) {
  return Json::parse(read(folder.path() / out / "sensitivity.json"));
}

const Json& input(const Json& number, const std::string& stream) {
  for (const Json& line : number["inputs"])
    if (line["stream"] == stream) return line;
  throw std::runtime_error("no input " + stream);
}

bool holds(const Json& interval, double value) {
  return interval[0].get<double>() <= value && value <= interval[1].get<double>();
}

}  // namespace

TEST_CASE(
    "Ishigami's function as a launch model has its indices, the same bytes for any number of threads and "
    "shards") {
  const Folder folder;
  folder.write("ishigami.lua", ishigami_plugin);
  folder.write("s.yaml", ishigami_scenario);
  const Output said = call_well(folder, "sensitivity s.yaml -j 2 -o out");
  CHECK(said.out.find("4 inputs: 6144 trials, 1024 at each of 6 runs") != std::string::npos);
  const Json found = result_of(folder, "out");
  CHECK(found["of"] == "rocks.stones.runout.max");
  CHECK(found["evaluations"] == 6 * 1024);
  CHECK(found["left_out"] == 0);
  const std::vector<double> first{0.3139, 0.4424, 0}, total{0.5576, 0.4424, 0.2437};
  for (int i = 0; i < 3; ++i) {
    const Json& line = input(found, "rocks.stones.launch.x" + std::to_string(i + 1));
    INFO(line.dump());
    CHECK(holds(line["first_interval"], first[static_cast<std::size_t>(i)]));
    CHECK(holds(line["total_interval"], total[static_cast<std::size_t>(i)]));
  }
  CHECK(input(found, "everything else")["total"] == 0);
  CHECK(input(found, "rocks.stones.launch.x1")["p10"].get<double>() == Approx(0.1).margin(0.02));

  call_well(folder, "sensitivity s.yaml -j 1 --quiet -o one");
  for (const char* shard : {"1", "2", "3"})
    call_well(folder, std::string("sensitivity s.yaml --quiet --shard ") + shard + "/3 -o shard" + shard);
  CHECK(call_well(folder, "status shard2").out.find("sensitivity") != std::string::npos);
  const Output partial = call(folder, "merge shard1 shard2 --quiet -o partial");
  CHECK(partial.code == 3);
  CHECK(partial.err.find("shard 3 of 3 is missing: flyrock sensitivity s.yaml --shard 3/3") !=
        std::string::npos);
  call_well(folder, "merge shard3 shard1 shard2 --quiet -o merged");
  for (const char* other : {"one", "merged"})
    for (const char* file : {"sensitivity.json", "sensitivity.html"}) {
      INFO(other);
      CHECK(read(folder.path() / "out" / file) == read(folder.path() / other / file));
    }
}

TEST_CASE("streams that depend on each other are one input, and what is left is everything else") {
  const Folder folder;
  folder.write("ishigami.lua", ishigami_plugin);
  folder.write("s.yaml", ishigami_scenario);
  call_well(folder,
            "sensitivity s.yaml -n 512 --quiet --inputs rocks.stones.launch.x2 "
            "--group pair=rocks.stones.launch.x1,rocks.stones.launch.x3 -o out");
  const Json found = result_of(folder, "out");
  REQUIRE(found["inputs"].size() == 3);
  // The function is the sum of a part of x2 and one of x1 and x3.
  CHECK(holds(input(found, "pair")["first_interval"], 0.5576));
  CHECK(holds(input(found, "pair")["total_interval"], 0.5576));
  CHECK(input(found, "pair")["streams"].size() == 2);
  CHECK(input(found, "pair")["p10"].is_null());
  CHECK(input(found, "everything else")["total"] == 0);
  // All that is not named is one input.
  call_well(folder, "sensitivity s.yaml -n 512 --quiet --inputs rocks.stones.launch.x2 -o rest");
  CHECK(holds(input(result_of(folder, "rest"), "everything else")["first_interval"], 0.5576));
}

TEST_CASE("the page says of each launch model what drives it, and what no model reads") {
  const Folder folder;
  folder.write("s.yaml", blast_scenario);
  const Output said = call_well(folder, "sensitivity s.yaml -o out");
  const Json found = result_of(folder, "out");
  REQUIRE(found["also"].size() == 1);
  CHECK(found["inputs"][0]["stream"] == "blast.burden");
  CHECK(found["also"][0]["inputs"][0]["stream"] == "blast.hole.stemming");
  CHECK(found["inputs"].size() == 3);  // burden, stemming, everything else
  const std::string page = read(folder.path() / "out/sensitivity.html");
  for (const std::string& words : {std::string("blast.spacing moves nothing: no model here reads it"),
                                   std::string("derived.stemming_to_burden is made of blast.hole.stemming, "
                                               "blast.burden and is no further cause."),
                                   std::string("blast.burden from its p10 (2.4"),
                                   std::string("No effect at all in 256 trials: blast.burden")}) {
    INFO(words);
    CHECK(page.find(words) != std::string::npos);
  }
  const std::string plain = std::regex_replace(page, std::regex("</?code>"), "`");
  for (const char* words :
       {"blast\\.burden explains (9\\d|100) % \\(95 % interval \\d+ to 100 %\\) of the variance of "
        "the greatest runout of `face`\\.",
        "blast\\.hole\\.stemming explains (9\\d|100) % .* of the greatest runout of `collar`\\."}) {
    INFO(words);
    CHECK(std::regex_search(said.out, std::regex(words)));
    CHECK(std::regex_search(plain, std::regex(words)));
  }
  // A smaller burden throws farther, and the mean crosses 20 m where the closed form does.
  const Json& burden = found["inputs"][0];
  CHECK(burden["f_p10"].get<double>() > burden["f_p90"].get<double>());
  call_well(folder, "sensitivity s.yaml --quiet --line '20 m' -o line");
  const Json crossing = result_of(folder, "line")["inputs"][0]["crossing"];
  // x = v^2 / g at 45 degrees, from 1 m above the ground: v = k (sqrt(m) / B)^1.3.
  const double m = M_PI / 4 * 0.102 * 0.102 * 850, v2 = 20 * 20 * 9.81 / 21;
  CHECK(crossing["rising"] == false);
  CHECK(crossing["at"].get<double>() ==
        Approx(std::sqrt(m) / std::pow(std::sqrt(v2) / 14, 1 / 1.3)).epsilon(0.01));
}

TEST_CASE("draws per impact are inputs of bouncing rocks, and all totals together are at least 1", "[slow]") {
  const Folder folder;
  folder.write(
      "s.yaml",
      "flyrock: 1\ndimension: 2\nmethod: nscd\ntrials: 128\n"
      "terrain: { type: profile, points: [[-5, 20], [0, 20], [25, 0], [200, 0]], material: rock }\n"
      "materials: { rock: { restitution: { type: newton, en: { uniform: [0.2, 0.6], per: impact } }, "
      "friction: { type: coulomb, mu: { uniform: [0.3, 0.6] } }, rolling: { type: rolling_resistance, mu_r: "
      "0.05 m } } }\n"
      "rocks: [{ name: blocks, density: 2600, shape: { type: disk, radius: { uniform: [0.2 m, 0.4 m] } }, "
      "release: { position: [2, 24] } }]\nstop: { time: 60 s }\n");
  call_well(folder,
            "sensitivity s.yaml --quiet --of rocks.blocks.runout.mean --of rocks.blocks.energy.max -o out");
  const Json found = result_of(folder, "out");
  CHECK(found["sum_total"].get<double>() >= 1);
  CHECK(input(found, "materials.rock.restitution.en")["total"].get<double>() > 0);
  CHECK(input(found, "materials.rock.restitution.en")["p10"].is_null());  // one a contact, not one a trial
  CHECK(found["also"][0]["unit"] == "J");
}

TEST_CASE("what cannot be asked is an error in one line") {
  const Folder folder;
  folder.write("ishigami.lua", ishigami_plugin);
  folder.write("s.yaml", ishigami_scenario);
  folder.write("swept.yaml", "include: s.yaml\nrocks.0.density: 1\n");
  const auto refused = [&](const std::string& words, const std::string& text) {
    const Output said = call(folder, "sensitivity s.yaml -o out " + words);
    INFO(words);
    CHECK(said.code == 2);
    INFO(said.err);
    CHECK(said.err.find(text) != std::string::npos);
    CHECK_FALSE(folder.has("out"));
  };
  refused("--of rocks.stone.runout.max", "the scenario has no rocks `stone`, did you mean `stones`?");
  refused("--of rocks.stones.runout.p99", "expected rocks.NAME.QUANTITY.mean, .max, .p95 or .beyond[300 m]");
  refused("--of 'rocks.stones.runout.beyond[3 s]'", "expected a limit in m");
  refused("--of rocks.stones.runout.p95", "a trial has 1 such rocks, p95 needs 20");
  refused("--of gate.road.per_trial", "the scenario has no gate `road`");
  refused("--inputs rocks.stones.launch.x4", "the scenario draws from no stream `rocks.stones.launch.x4`");
  refused("--group pair", "expected NAME=STREAM,...");
  refused("--inputs rocks.stones.launch.x1 --group a=rocks.stones.launch.x1", "stands in two inputs");
  refused("--line 3", "expected a number in m");
  refused("--set rocks.stones.density.sweep='[1,2]'", "");
  refused("-n 1", "-n");
  refused("-n 10 --trials 10", "expected one of -n and --trials");
}

TEST_CASE("a run with a design of trials has the same bytes for any number of threads and shards") {
  const Folder folder;
  folder.write("s.yaml", blast_scenario);
  for (const std::string& sampling : {std::string("latin_hypercube"), std::string("sobol")}) {
    const std::string words = "run s.yaml --quiet --force --set sampling=" + sampling;
    call_well(folder, words + " -j 1 -o one");
    call_well(folder, words + " -j 2 -o two");
    call_well(folder, words + " --shard 1/2 -o a");
    call_well(folder, words + " --shard 2/2 -o b");
    call_well(folder, "merge a b --quiet --force -o merged");
    for (const char* other : {"two", "merged"})
      for (const char* file : {"rocks.csv", "summary.json"}) {
        INFO(sampling << " " << other << " " << file);
        CHECK(read(folder.path() / "one" / file) == read(folder.path() / other / file));
      }
  }
}

TEST_CASE("an analysis that was interrupted goes on with what is done") {
  const Folder folder;
  folder.write("ishigami.lua", ishigami_plugin);
  folder.write("s.yaml", ishigami_scenario);
  call_well(folder, "sensitivity s.yaml -n 200 --quiet -o whole");
  call_well(folder, "sensitivity s.yaml -n 200 --quiet --shard 1/2 -o part");  // half of its chunks
  call_well(folder, "sensitivity s.yaml -n 200 --quiet --resume -o part");
  CHECK(read(folder.path() / "part/sensitivity.json") == read(folder.path() / "whole/sensitivity.json"));
  CHECK_FALSE(folder.has("part/chunks"));
  const Output other = call(folder, "sensitivity s.yaml -n 300 --quiet --resume -o part");
  CHECK(other.code == 2);
}

}  // namespace flyrock::sensitivity_test
