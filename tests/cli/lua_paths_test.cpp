// A Lua scenario is the same one wherever the program runs: its hash has no path.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.h"

using namespace flyrock::test;

namespace {

const std::string with_law_and_module = R"(local fr = require "flyrock"
local size = require("parts").size
fr.plugin {
  kind = "restitution", name = "half", doc = "One number.", params = {},
  impact = function(p, contact) return 0.5, 0 end,
}
return fr.scenario {
  flyrock = 1, dimension = 2, method = "nscd",
  terrain = { type = "profile", points = { { -5, 0 }, { 50, 0 } }, material = "floor" },
  materials = { floor = { restitution = { type = "half" } } },
  bodies = { { name = "disk", shape = { type = "disk", radius = size }, mass = 1, position = { 0, 0.5 } } },
  stop = { time = 0.1 },
}
)";

std::string hash_of_result(const Folder& folder) {
  return nlohmann::json::parse(read(folder.path() / "r/manifest.json")).at("scenario_sha256");
}

}  // namespace

TEST_CASE("A Lua scenario with laws and modules is the same one by every path, and its shards merge") {
  const Folder folder;
  fs::create_directories(folder.path() / "deep");
  folder.write("deep/parts.lua", "return { size = 0.1 }");
  folder.write("deep/row.lua", with_law_and_module);
  const std::string program = "'" FLYROCK_BINARY "' ", rest = " -o ../r --force --quiet";
  REQUIRE(shell(folder, "cd deep && " + program + "run row.lua" + rest).code == 0);
  const std::string here = hash_of_result(folder);
  for (const std::string& path :
       {std::string("../deep/row.lua"), (folder.path() / "deep/row.lua").string()}) {
    INFO(path);
    REQUIRE(shell(folder, "cd deep && " + program + "run '" + path + "'" + rest).code == 0);
    CHECK(hash_of_result(folder) == here);
  }
  for (const char* shard : {"1/2 -o a", "2/2 -o b"})
    REQUIRE(call(folder, std::string("run deep/row.lua --trials 4 --quiet --shard ") + shard).code == 0);
  const Output merged = call(folder, "merge a b -o merged --quiet");
  INFO(merged.err);
  CHECK(merged.code == 0);
}
