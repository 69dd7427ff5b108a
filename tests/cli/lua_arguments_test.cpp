// --arg: the arguments of Lua scenarios, in all commands that read one.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.h"

using namespace flyrock::test;

namespace {

/// A row of disks at rest, and a law that keeps an argument.
const std::string row_of_disks = R"(local fr = require "flyrock"
local count, size, title = fr.argument("count", 2), fr.argument("size", 0.1), fr.argument("title", "disks")
fr.plugin {
  kind = "restitution", name = "kept", doc = "One number.", params = {},
  impact = function(p, contact) return size, 0 end,
}
local bodies = {}
for i = 1, count do
  bodies[i] = { name = "disk_" .. i, shape = { type = "disk", radius = size }, mass = 1, position = { i, size } }
end
return fr.scenario {
  flyrock = 1, title = title, dimension = 2, method = "nscd", bodies = bodies, body_contacts = "off",
  terrain = { type = "profile", points = { { -5, 0 }, { 50, 0 } }, material = "floor" },
  materials = { floor = { restitution = { type = "kept" } } },
  stop = { time = 0.1 },
}
)";

nlohmann::json manifest_in(const Folder& folder, const std::string& result) {
  return nlohmann::json::parse(read(folder.path() / result / "manifest.json"));
}

}  // namespace

TEST_CASE("A Lua scenario takes arguments in all commands that read it, and its manifest records them") {
  const Folder folder;
  folder.write("row.lua", row_of_disks);
  REQUIRE(call(folder, "run row.lua -o usual --quiet").code == 0);
  const nlohmann::json usual = manifest_in(folder, "usual");
  CHECK(usual.at("arguments").dump() == R"({"count":2,"size":0.1,"title":"disks"})");
  CHECK(usual.at("scenario").at("bodies").size() == 2);

  const std::string given = " --arg count=5 --arg size=0.2 --arg title='a b=c'";
  REQUIRE(call(folder, "run row.lua -o more -j 2 --quiet" + given).code == 0);
  const nlohmann::json more = manifest_in(folder, "more");
  CHECK(more.at("arguments").dump() == R"({"count":5,"size":0.2,"title":"a b=c"})");
  CHECK(more.at("scenario").at("bodies").size() == 5);
  CHECK(more.at("scenario").at("title") == "a b=c");

  CHECK(call(folder, "check row.lua" + given).code == 0);
  CHECK(call(folder, "show row.lua" + given).out.find("disk_5") != std::string::npos);
  CHECK(call(folder, "explain row.lua --step 1" + given).code == 0);
}

TEST_CASE("Shards keep their arguments, and a result is not continued with others") {
  const Folder folder;
  folder.write("row.lua", row_of_disks);
  const std::string trials = " --trials 4 --quiet --arg count=3";
  REQUIRE(call(folder, "run row.lua -o whole" + trials).code == 0);
  REQUIRE(call(folder, "run row.lua -o a --shard 1/2" + trials).code == 0);
  REQUIRE(call(folder, "run row.lua -o b --shard 2/2" + trials).code == 0);
  const Output merged = call(folder, "merge a b -o merged --quiet");
  INFO(merged.err);
  REQUIRE(merged.code == 0);
  CHECK((read(folder.path() / "merged/rocks.csv") == read(folder.path() / "whole/rocks.csv")));
  CHECK((read(folder.path() / "merged/manifest.json") == read(folder.path() / "whole/manifest.json")));
  CHECK(call(folder, "run row.lua -o whole --resume --trials 4 --quiet --arg count=4").code == 2);
}

TEST_CASE("A law that keeps an argument makes another scenario with another value") {
  const Folder folder;
  folder.write("law.lua", R"(local fr = require "flyrock"
local en = fr.argument("en", 0.5)
return fr.plugin {
  kind = "restitution", name = "kept", doc = "One number.", params = {},
  impact = function(p, contact) return en, 0 end,
}
)");
  folder.write("drop.yaml", R"(flyrock: 1
dimension: 2
method: nscd
plugins: [law.lua]
terrain: { type: plane, material: floor }
materials: { floor: { restitution: { type: kept } } }
bodies: [{ name: ball, shape: { type: disk, radius: 0.1 m }, mass: 1 kg, position: [0, 1] }]
stop: { time: 0.8 s }
)");
  REQUIRE(call(folder, "run drop.yaml -o half --quiet").code == 0);
  REQUIRE(call(folder, "run drop.yaml -o whole --quiet --arg en=1").code == 0);
  const nlohmann::json half = manifest_in(folder, "half"), whole = manifest_in(folder, "whole");
  CHECK(half.at("scenario") == whole.at("scenario"));
  CHECK(half.at("scenario_sha256") != whole.at("scenario_sha256"));
  CHECK(read(folder.path() / "half/rocks.csv") != read(folder.path() / "whole/rocks.csv"));
  CHECK(call(folder, "check law.lua --arg en=1").code == 0);
  folder.write("late.lua", R"(local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "late", doc = "Asks in a call.", params = {},
  impact = function(p, contact) return fr.argument("en", 0.5), 0 end,
}
)");
  CHECK(call(folder, "check late.lua").err.find("call fr.argument at the top level of the file") !=
        std::string::npos);
  CHECK(call(folder, "check law.lua --arg em=1").err ==
        "--arg em=1: error: unknown argument `em`, did you mean `en`?\n");
}

TEST_CASE("What is shown of a scenario with functions names the arguments that they need") {
  const Folder folder;
  folder.write("row.lua", row_of_disks);
  const std::string shown = call(folder, "show row.lua --arg size=0.2 --arg count=3").out;
  CHECK(
      shown.starts_with("# Its plugins are functions in row.lua: keep this beside row.lua, and run it with "
                        "--arg size=0.2 --arg count=3.\n"));
  folder.write("shown.yaml", shown);
  const std::string run = "run shown.yaml -o shown --quiet --arg size=0.2 --arg count=3";
  REQUIRE(call(folder, run).code == 0);
  REQUIRE(call(folder, "run row.lua -o direct --quiet --arg size=0.2 --arg count=3").code == 0);
  CHECK((read(folder.path() / "shown/rocks.csv") == read(folder.path() / "direct/rocks.csv")));
}

TEST_CASE("An argument that nobody asks for, or that is no number, is an error with what was expected") {
  const Folder folder;
  folder.write("row.lua", row_of_disks);
  folder.write("plain.yaml", R"(flyrock: 1
dimension: 2
method: nscd
terrain: { type: plane, material: floor }
materials: { floor: { friction: { type: coulomb, mu: 0.5 } } }
bodies: [{ name: ball, shape: { type: disk, radius: 0.1 m }, mass: 1 kg, position: [0, 1] }]
stop: { time: 0.1 s }
)");
  const std::pair<const char*, const char*> wrong[] = {
      {"row.lua --arg conut=3", "--arg conut=3: error: unknown argument `conut`, did you mean `count`?\n"},
      {"row.lua --arg x=3", "--arg x=3: error: unknown argument `x`, expected `count`, `size` or `title`\n"},
      {"plain.yaml --arg count=3",
       "--arg count=3: error: unknown argument `count`: no Lua file of this scenario calls fr.argument\n"},
      {"row.lua --arg count", "--arg count: error: expected name=value, as in --arg stones=41\n"},
      {"row.lua --arg =3", "--arg =3: error: expected name=value, as in --arg stones=41\n"},
      {"row.lua --arg count=3 --arg count=4", "--arg count=4: error: `count` is given twice\n"},
      {"row.lua --arg count=many",
       "row.lua:2:1: error: argument `count`: `many` is not a number, as its default 2 is\n"},
      {"row.lua --arg count=",
       "row.lua:2:1: error: argument `count`: `` is not a number, as its default 2 is\n"},
      {"row.lua --arg size=1e999",
       "row.lua:2:1: error: argument `size`: `1e999` is not a number, as its default 0.1 is\n"},
      {"row.lua --arg size=nan",
       "row.lua:2:1: error: argument `size`: `nan` is not a number, as its default 0.1 is\n"},
  };
  for (const char* command : {"check ", "show ", "run -o out ", "explain --step 1 "})
    for (const auto& [arguments, error] : wrong) {
      INFO(command << arguments);
      const Output output = call(folder, command + std::string(arguments));
      INFO(output.err);
      CHECK(output.code == 2);
      CHECK(output.err.find(error) != std::string::npos);
    }
}
