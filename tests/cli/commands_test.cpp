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
  CHECK(error("run x.yaml --forse").find("unknown option `--forse`, did you mean `--force`?") != std::string::npos);
  CHECK(error("run").find("expected: flyrock run SCENARIO") != std::string::npos);
  CHECK(error("run a.yaml b.yaml").find("`b.yaml` is one word too many") != std::string::npos);
  CHECK(error("run x.yaml --trials 0").find("--trials: `0` is not a whole number of at least 1") != std::string::npos);
  CHECK(error("run x.yaml --seed -1").find("--seed: `-1` is not a whole number") != std::string::npos);
  CHECK(error("run x.yaml --only trial=1").find("--only: `trial=1`, expected point=P,trial=T") != std::string::npos);
  CHECK(error("plugins restitutoin").find("did you mean `restitution`?") != std::string::npos);
  CHECK(error("plugins restitution/newtn").find("did you mean `newton`?") != std::string::npos);
  folder.write("bench.yaml", bench);
  CHECK(error("run bench.yaml --only point=1,trial=0").find("point 1 does not exist, the scenario has 1 (from 0)") != std::string::npos);
  CHECK(error("run bench.yaml --only point=0,trial=4").find("trial 4 does not exist, the scenario has 4 (from 0)") != std::string::npos);
  CHECK_FALSE(folder.has("out"));
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
  CHECK(unused.out.find("not used: blast.burden") != std::string::npos);
  CHECK(call(folder, "check blast.yaml --strict").code == 2);
  CHECK(call(folder, "run blast.yaml --strict").code == 2);
  CHECK_FALSE(folder.has("out"));

  folder.write("law.lua", "local fr = require \"flyrock\"\nreturn fr.plugin { kind = \"restitution\", name = \"law\" }\n");
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
  CHECK(idle.err.find("law.lua: error: restitution/law: ") == 0);
}

TEST_CASE("plugins lists what is registered, as text, Markdown and JSON") {
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
