#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.h"

using namespace flyrock::test;

TEST_CASE("The command line explains itself") {
  const Folder folder;
  CHECK(call(folder, "--version").out.starts_with("flyrock 0."));
  CHECK(call(folder, "--help").code == 0);
  for (const char* command : {"run", "check", "show", "plugins"}) {
    const Output help = call(folder, std::string(command) + " --help");
    CHECK(help.code == 0);
    CHECK(help.out.find(std::string("flyrock ") + command) == 0);
  }
}

TEST_CASE("A wrong command line is exit code 2 with the nearest word") {
  const Folder folder;
  const auto error = [&](const std::string& line) {
    const Output output = call(folder, line);
    CHECK(output.code == 2);
    return output.err;
  };
  CHECK(error("rn x.yaml").find("unknown command `rn`, did you mean `run`?") != std::string::npos);
  CHECK(error("run x.yaml --forse").find("unknown option `--forse`, did you mean `--force`?") !=
        std::string::npos);
  CHECK(error("run").find("expected: flyrock run SCENARIO") != std::string::npos);
  CHECK(error("run a.yaml b.yaml").find("`b.yaml` is one word too many") != std::string::npos);
  CHECK(error("run x.yaml --trials 0").find("--trials: `0` is not a whole number of at least 1") !=
        std::string::npos);
  CHECK(error("run x.yaml --seed -1").find("--seed: `-1` is not a whole number") != std::string::npos);
  CHECK(error("run x.yaml --only trial=1").find("--only: `trial=1`, expected point=P,trial=T") !=
        std::string::npos);
  CHECK(error("run x.yaml --shard 0/2").find("--shard i: `0` is not a whole number of at least 1") !=
        std::string::npos);
  CHECK(error("run x.yaml --shard 3/2").find("--shard: `3/2`, expected i from 1 to n") != std::string::npos);
  CHECK(error("run x.yaml -j 1e3").find("-j: `1e3` is not a whole number of at least 1") !=
        std::string::npos);
  CHECK(error("run x.yaml --trials 99999999999999999999").find("is too large") != std::string::npos);
  CHECK(error("plugins restitutoin").find("did you mean `restitution`?") != std::string::npos);
  CHECK(error("plugins restitution/newtn").find("did you mean `newton`?") != std::string::npos);
  folder.write("bench.yaml", bench);
  CHECK(error("run bench.yaml --only point=1,trial=0")
            .find("point 1 does not exist, the scenario has 1 (from 0)") != std::string::npos);
  CHECK(error("run bench.yaml --only point=0,trial=4")
            .find("trial 4 does not exist, the scenario has 4 (from 0)") != std::string::npos);
  CHECK_FALSE(folder.has("out"));
}

TEST_CASE("What is told of a wrong command line is text in one line, whatever bytes it holds") {
  const Folder folder;
  folder.write("bench.yaml", bench);
  for (const char* words : {"run x.yaml --trials $'a\\nb'", "run x.yaml --seed $'\\xff'",
                            "export $'\\e[31m' --to csv", "$'\\vrun'"}) {
    const Output output = shell(folder, std::string("bash -c \"'" FLYROCK_BINARY "' ") + words + "\"");
    INFO(words << ": " << output.err);
    CHECK(output.code == 2);
    CHECK(output.err.find("error: ") == 0);
    std::string told = output.err.substr(0, output.err.find("\nSee "));
    if (told.ends_with('\n')) told.pop_back();
    CHECK(told.find_first_of("\n\x1b\v\xff") == std::string::npos);
  }
}

TEST_CASE("show prints a scenario that means the same") {
  const Folder folder;
  folder.write("bench.yaml", bench);
  const Output shown = call(folder, "show bench.yaml");
  REQUIRE(shown.code == 0);
  folder.write("shown.yaml", shown.out);
  CHECK(call(folder, "show shown.yaml").out == shown.out);
  REQUIRE(call(folder, "run bench.yaml -o a --quiet").code == 0);
  REQUIRE(call(folder, "run shown.yaml -o b --quiet").code == 0);
  CHECK(read(folder.path() / "a/rocks.csv") == read(folder.path() / "b/rocks.csv"));
  CHECK(nlohmann::json::parse(call(folder, "show bench.yaml --json --set seed=9").out)["seed"] == 9);
}

TEST_CASE("show of a Lua scenario with plugins of its own prints one that check accepts beside it") {
  const Folder folder;
  folder.write("own.lua", R"(local fr = require "flyrock"
fr.plugin {
  kind = "restitution", name = "fading", doc = "d",
  params = { en = fr.number { default = 0.5, min = 0, doc = "d" } },
  impact = function(p, contact) return p.en / (1 + contact.approach_speed) end,
}
return fr.scenario {
  flyrock = 1, dimension = 2, method = "nscd",
  terrain = { type = "profile", points = { { -5, 0 }, { 5, 0 } }, material = "rock" },
  materials = { rock = { restitution = { type = "fading" }, friction = { type = "coulomb", mu = 0.5 } } },
  bodies = { { name = "ball", shape = { type = "disk", radius = 0.1 }, mass = 1, position = { 0, 1 } } },
  stop = { time = 5 },
})");
  const Output shown = call(folder, "show own.lua");
  REQUIRE(shown.code == 0);
  CHECK(shown.out.find("# Its plugins are functions in own.lua") == 0);
  folder.write("shown.yaml", shown.out);
  CHECK(call(folder, "check shown.yaml").code == 0);
  REQUIRE(call(folder, "run own.lua -o a --quiet").code == 0);
  REQUIRE(call(folder, "run shown.yaml -o b --quiet").code == 0);
  CHECK(read(folder.path() / "a/rocks.csv") == read(folder.path() / "b/rocks.csv"));
  CHECK(nlohmann::json::parse(call(folder, "show own.lua --json").out)["plugins"][0] == "own.lua");
}

TEST_CASE("check validates and runs nothing") {
  const Folder folder;
  folder.write("bench.yaml", bench);
  const Output good = call(folder, "check bench.yaml");
  CHECK(good.code == 0);
  CHECK(good.out.find("bench.yaml: a sound scenario, 4 trials\n") != std::string::npos);
  folder.write("bad.yaml", bench_with("mu: 0.6", "mu: 0.6 m"));
  CHECK(call(folder, "check bad.yaml").code == 2);
  folder.write("blast.yaml", std::string(bench) + "blast: { burden: 3 m }\n");
  const Output unused = call(folder, "check blast.yaml");
  CHECK(unused.code == 0);
  CHECK(unused.out.find("not used: blast.burden (fixed does not read it)\n") != std::string::npos);
  CHECK(call(folder, "check blast.yaml --strict").code == 2);
  folder.write("gurney.yaml", bench_with("{ type: fixed, speed: { uniform: [5, 15] }, elevation: 20 deg }",
                                         "{ type: gurney }") +
                                  R"(blast:
  explosive: { density: 850, detonation_velocity: 4000 m/s }
  hole: { diameter: 102 mm }
  burden: 2.7 m
  rock_density: 2700
  breakout_angle: 90 deg
)");
  CHECK(call(folder, "check gurney.yaml").out.find("not used") ==
        std::string::npos);  // the Gurney constant is D/3
  CHECK(call(folder, "run blast.yaml --strict").code == 2);
  CHECK_FALSE(folder.has("out"));

  folder.write(
      "law.lua",
      "local fr = require \"flyrock\"\nreturn fr.plugin { kind = \"restitution\", name = \"law\" }\n");
  CHECK(call(folder, "check law.lua").code == 2);
  folder.write("law.lua", R"(local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "law", doc = "Does not read its parameter.",
  params = { en = fr.number { default = 0.5, min = 0, max = 1, doc = "restitution" } },
  impact = function(p, contact) return 0.5, 0 end,
}
)");
  const Output idle = call(folder, "check law.lua");
  CHECK(idle.code == 2);
  CHECK(idle.err.find("law.lua:5:3: error: restitution/law: ") == 0);  // its function
}

TEST_CASE("check does not call a scenario sound under a warning") {
  const Folder folder;
  folder.write("bench.yaml", bench_with("stop: { time: 60 s }", "stop: { time: 2 h }"));
  const Output one = call(folder, "check bench.yaml");
  INFO(one.out << one.err);
  CHECK(one.code == 0);
  CHECK(one.err.find("warning: stop.time: 7200 s is unusual") != std::string::npos);
  CHECK(one.out.find("bench.yaml: no error, 1 warning, 4 trials\n") != std::string::npos);
  // So for a warning that is found with the first trials.
  folder.write("fast.yaml", bench_with("speed: { uniform: [5, 15] }", "speed: { uniform: [5, 1500] }"));
  CHECK(call(folder, "check fast.yaml").out.find("fast.yaml: no error, 2 warnings, 4 trials\n") !=
        std::string::npos);
}

TEST_CASE("run asks what check asks before it starts") {
  const Folder folder;
  // In one trial of a hundred the rock starts in the ground; the first of them is beyond the third trial.
  std::string scenario =
      bench_with("position: [0, 12]", "position: [-5, { normal: { mean: 11, sd: 0.35 } }]");
  scenario.replace(scenario.find("trials: 4"), 9, "trials: 150");
  folder.write("bench.yaml", scenario);
  const Output check = call(folder, "check bench.yaml"), run = call(folder, "run bench.yaml -o r --quiet");
  INFO(check.err << run.err);
  CHECK(check.code == 2);
  CHECK(run.code == 2);
  CHECK(run.err == check.err);
  CHECK(run.err.find("trial 0") == std::string::npos);
  CHECK_FALSE(folder.has("r"));
}

TEST_CASE("check warns of a rock with so many vertices that a trial takes long") {
  const Folder folder;
  folder.write("shape.lua", R"(local fr = require "flyrock"
return fr.plugin { kind = "shape", name = "fine", doc = "A circle of 3000 corners.", build = function(p)
  local vertices = {}
  for i = 1, 3000 do vertices[i] = { 0.2 * math.cos(i * math.pi / 1500), 0.2 * math.sin(i * math.pi / 1500) } end
  return { vertices = vertices }
end }
)");
  folder.write("fine.yaml", "plugins: [shape.lua]\n" +
                                bench_with("{ type: polygon, sides: { integer: [5, 8] }, diameter: 0.5 }",
                                           "{ type: fine }"));
  const Output output = call(folder, "check fine.yaml");
  INFO(output.err);
  CHECK(output.code == 0);
  CHECK(output.err.find("has a part of 3000 vertices: above 500 a trial takes many seconds") !=
        std::string::npos);
}

TEST_CASE("check shows no control characters of what a plugin answers") {
  const Folder folder;
  folder.write("law.lua", R"(local fr = require "flyrock"
return fr.plugin { kind = "unilateral", name = "law", doc = "Names no condition.", condition = function(p) return "x\27[31m" end }
)");
  const Output output = call(folder, "check law.lua");
  INFO(output.err);
  CHECK(output.code == 2);
  CHECK(output.err.find("returned \"x\\x1B[31m\", expected \"signorini\"") != std::string::npos);
}

TEST_CASE("check of a plugin whose calls take long ends after some seconds, and says so", "[slow]") {
  const Folder folder;
  folder.write("law.lua", R"(local fr = require "flyrock"
return fr.plugin { kind = "restitution", name = "law", doc = "Takes long.", impact = function(p)
  for i = 1, 300000 do local x = i * i end
  return 0.3
end }
)");
  const auto start = std::chrono::steady_clock::now();
  const Output output = call(folder, "check law.lua");
  INFO(output.err);
  CHECK(output.code == 0);
  CHECK(output.err ==
        "law.lua:2:77: warning: restitution/law: its calls take so long that only some of the samples were "
        "tried\n");
  CHECK(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < 60);
}

TEST_CASE("plugins lists the plugins and their parameters, as text, Markdown and JSON") {
  const Folder folder;
  CHECK(call(folder, "plugins").out.find("restitution/newton") != std::string::npos);
  CHECK(call(folder, "plugins friction").out.find("restitution/") == std::string::npos);
  const Output one = call(folder, "plugins restitution/pfeiffer_bowen");
  CHECK(one.out.find("half_speed: number [m/s], default 9.144 m/s") != std::string::npos);
  CHECK(call(folder, "plugins --markdown").out.find("## restitution/newton\n") != std::string::npos);
  const auto list = nlohmann::json::parse(call(folder, "plugins --json").out);
  REQUIRE(list.size() > 10);
  for (const auto& plugin : list)
    for (const char* key : {"kind", "name", "doc", "source", "file", "params"}) CHECK(plugin.contains(key));
}

TEST_CASE(
    "show says the origin that was found, and a message of a start has all digits of national coordinates") {
  const Folder folder;
  const std::string scenario = FLYROCK_SOURCE_DIR "/plugins/terrain/raster/example.yaml";
  const Output shown = call(folder, "show --json " + scenario);
  REQUIRE(shown.code == 0);
  CHECK(shown.out.find("\"origin\": [\n      2600000,\n      1200000,\n      0\n    ]") != std::string::npos);
  CHECK(call(folder, "show --json --set terrain.origin=\"[2600000, 1200000, 100]\" " + scenario)
            .out.find("      100\n    ]") != std::string::npos);
  const Output beyond = call(
      folder, "check " + scenario + " --set rocks.0.release=\"{ position: [2600020.125, 1299000.5, 400] }\"");
  CHECK(beyond.code == 2);
  INFO(beyond.err);
  CHECK(beyond.err.find("starts at y = 1299000.5 m, beyond the terrain, which runs from 12000") !=
        std::string::npos);
}
