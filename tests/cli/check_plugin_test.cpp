// `flyrock check PLUGIN` calls a plugin sound only if it has called it.

#include <catch2/catch.hpp>

#include "program.h"

using namespace flyrock::test;

namespace check_plugin_test {

namespace {

struct Refused {
  const char* name;
  const char* text;   ///< of the plugin
  const char* error;  ///< in the message
};

constexpr Refused refused[] = {
    {"law with a coroutine", R"(local fr = require "flyrock"
local co = coroutine.create(function() local n = 0 while true do n = n + 0.001 coroutine.yield(n) end end)
return fr.plugin { kind = "restitution", name = "x", doc = "d", params = {},
  impact = function(p, c) local _, v = coroutine.resume(co) return v, 0 end })",
     "restitution/x: it cannot be made with parameters within their limits: plugin x, x.lua:4: impact() "
     "reaches the coroutine `co`"},
    {"shape with a coroutine", R"(local fr = require "flyrock"
local sizes = coroutine.wrap(function() while true do coroutine.yield(1) end end)
return fr.plugin { kind = "shape", name = "x", doc = "d", params = {},
  build = function(p, rng) return { radius = sizes() } end })",
     "shape/x: it cannot be made: plugin x, x.lua:4: build() reaches the coroutine `"},
    {"terrain in 3D with the answer of 2D", R"(local fr = require "flyrock"
return fr.plugin { kind = "terrain", name = "x", doc = "d", params = {}, dimension = 3,
  build = function(p, rng) return { points = { { 0, 0 }, { 1, 1 } } } end })",
     "terrain/x: it cannot be made: plugin x, x.lua:3: build() returned `points`, a terrain of dimension 2"},
    {"terrain in 2D with the answer of 3D", R"(local fr = require "flyrock"
return fr.plugin { kind = "terrain", name = "x", doc = "d", params = {}, dimension = 2,
  build = function(p, rng) return { heights = { { 0, 0 }, { 1, 1 } }, cell = 1 } end })",
     "terrain/x: it cannot be made: plugin x, x.lua:3: build() returned `heights`, a terrain of dimension 3"},
};

}  // namespace

TEST_CASE("check refuses a plugin that nobody can call, with the reason that a run gives") {
  const Folder folder;
  for (const Refused& plugin : refused) {
    folder.write("x.lua", plugin.text);
    const Output check = call(folder, "check x.lua");
    INFO(plugin.name << "\n" << check.err << check.out);
    CHECK(check.code == 2);
    CHECK(check.out.empty());
    CHECK(check.err.find(plugin.error) != std::string::npos);
  }
}

TEST_CASE("check says which calls of a plugin it could not make") {
  const Folder folder;
  folder.write("x.lua", R"(local fr = require "flyrock"
return fr.plugin { kind = "friction", name = "x", doc = "d",
  params = { table = fr.file { doc = "d" }, mu = fr.number { default = 0.5, min = 0, doc = "d" } },
  friction = function(p, c) return p.mu end }
)");
  const Output check = call(folder, "check x.lua");
  INFO(check.err << check.out);
  CHECK(check.code == 0);
  CHECK(check.out == "x.lua: no fault in what was called\n");
  CHECK(check.err.find("warning: friction/x: it was never called, because no value can be made up for "
                       "`table` (type file): check a scenario that uses it\n") != std::string::npos);

  folder.write("y.lua", R"(local fr = require "flyrock"
return fr.plugin { kind = "friction", name = "y", doc = "d",
  params = { mu = fr.number { default = 0.5, min = 0, doc = "d" } },
  friction = function(p, c) return p.mu end }
)");
  CHECK(call(folder, "check y.lua").out == "y.lua: a sound plugin\n");
}

TEST_CASE("check calls a plugin with the parameters of --set, and refuses those that it has not") {
  const Folder folder;
  folder.write("x.lua", R"(local fr = require "flyrock"
return fr.plugin { kind = "friction", name = "x", doc = "d",
  params = { mu = fr.number { default = 0.5, min = 0, max = 2, doc = "d" } },
  friction = function(p, c) if p.mu == 1.25 then error("here") end return p.mu end }
)");
  CHECK(call(folder, "check x.lua").code == 0);
  CHECK(call(folder, "check x.lua --set mu=1.5").out == "x.lua: a sound plugin\n");
  const Output here = call(folder, "check x.lua --set mu=1.25");
  CHECK(here.code == 2);
  CHECK(here.err.find("parameters: mu = 1.25") != std::string::npos);
  CHECK(call(folder, "check x.lua --set mu=3").err.find("mu: is `3`, must be at most 2") !=
        std::string::npos);
  CHECK(call(folder, "check x.lua --set nu=3").err.find("nu: unknown key") != std::string::npos);
  CHECK(call(folder, "check x.lua --trials 3").code == 2);
}

TEST_CASE("a table of e over the speed passes check, because its columns have limits") {
  const Folder folder;
  folder.write("x.lua", R"(local fr = require "flyrock"
return fr.plugin { kind = "restitution", name = "x", doc = "d",
  params = { e = fr.plan_points { min = { 0, 0 }, max = { 100, 1 }, doc = "e over the speed of approach, m/s" } },
  impact = function(p, c)
    local last = p.e[1]
    for i = 2, #p.e do
      local next, v = p.e[i], math.max(c.approach_speed, p.e[1][1])
      if v < next[1] then return last[2] + (next[2] - last[2]) * (v - last[1]) / (next[1] - last[1]) end
      last = next
    end
    return last[2]
  end }
)");
  CHECK(call(folder, "check x.lua").out == "x.lua: a sound plugin\n");
  const Output high = call(folder, "check x.lua --set 'e=[[0, 0.5], [10, 1.2]]'");
  CHECK(high.code == 2);
  CHECK(high.err.find("e.1.1: is `1.2`, must be at most 1") != std::string::npos);
}

TEST_CASE("a law that fails in a run says with which parameters and state, as check does") {
  const Folder folder;
  folder.write("x.lua", R"(local fr = require "flyrock"
return fr.plugin { kind = "friction", name = "x", doc = "d", reads = { "contact.slip_length" },
  params = { mu = fr.number { default = 0.5, min = 0, doc = "d" } },
  friction = function(p, c) return c.slip_length > 1.5 and -p.mu or p.mu end }
)");
  folder.write("x.yaml", R"(flyrock: 1
dimension: 2
method: nscd
plugins: [x.lua]
terrain: { type: plane, material: floor }
materials: { floor: { friction: { type: x, mu: 0.25 } } }
bodies:
  - { name: block, shape: { type: polygon, vertices: [[-1, -0.1], [1, -0.1], [1, 0.1], [-1, 0.1]] }, mass: 1 kg, position: [0, 0.1], velocity: [5, 0] }
stop: { time: 1 s }
)");
  const Output output = call(folder, "run x.yaml -o out --quiet");
  CHECK(output.code == 3);
  INFO(output.err);
  CHECK(output.err.find(
            "friction() returned mu_s = -0.25, must be at least 0 (parameters: mu = 0.25; asked with: "
            "slip_length = 1.5") != std::string::npos);
}

TEST_CASE("a law that calls itself without end is told so") {
  const Folder folder;
  folder.write("x.lua", R"(local fr = require "flyrock"
local function f(x) return f(x) + 1 end
return fr.plugin { kind = "friction", name = "x", doc = "d", params = {}, friction = function(p, c) return f(1) end }
)");
  CHECK(call(folder, "check x.lua")
            .err.find("stack overflow: a function calls itself without end, or too often; give it an end, or "
                      "write a loop") != std::string::npos);
}

TEST_CASE("a native plugin whose file is cut ends flyrock with exit code 2") {
  const Folder folder;
  // flyrock's own law under another name, with the module that has it.
  REQUIRE(shell(folder, "sed 's/name = \"newton\"/name = \"x\"/' " FLYROCK_SHARE_DIR
                        "/plugins/restitution/newton/plugin.lua > x.lua && cp " FLYROCK_MODULE_DIR
                        "/flyrock_plugins.so newton.so && '" FLYROCK_BINARY "' check x.lua")
              .code == 0);
  fs::resize_file(folder.path() / "newton.so", fs::file_size(folder.path() / "newton.so") / 2);
  const Output check = call(folder, "check x.lua");
  INFO(check.err << check.out);
  CHECK(check.code == 2);
  CHECK(check.err.starts_with("x.lua:"));
  CHECK(check.err.find("error: native: cannot open the module ") != std::string::npos);
}

}  // namespace check_plugin_test
