// Scenarios written in Lua: their tree of values and the places of what is wrong.

#include <catch2/catch.hpp>

#include "document/yaml_reader.h"
#include "unit/lua_fixture.h"

using namespace flyrock;

namespace {

struct Reading {
  std::optional<Value> value;
  std::string messages;
};

Reading read(LuaFixture& lua, const std::string& text) {
  lua.write("x.lua", text);
  Diagnostics diagnostics;
  Reading reading;
  reading.value = lua.session.read_scenario((lua.folder / "x.lua").string(), "x.lua", diagnostics);
  reading.messages = LuaFixture::messages(diagnostics);
  return reading;
}

std::string messages(const std::string& text) {
  LuaFixture lua;
  return read(lua, text).messages;
}

std::string place(const Value& value) { return fmt::format("{}:{}", value.at.line, value.at.column); }

}  // namespace

TEST_CASE("a scenario in Lua is the same tree as in YAML") {
  LuaFixture lua;
  const auto reading = read(lua, R"(local fr = require "flyrock"
local function rock(name) return { name = name, per_trial = 1 } end
local heights = {}
for i = 1, 3 do heights[i] = i * 2 end
return fr.scenario {
  title = "A \"quoted\" title", flyrock = 1, rock_contacts = false,
  terrain = { type = "benches", face_angle = "70 deg", heights = heights },
  rocks = { rock "a", rock "b" },
  en = { uniform = { 0.3, 0.6 }, per = "impact" },
  gates = {},
})");
  REQUIRE(reading.messages == "");
  REQUIRE(reading.value);
  Diagnostics diagnostics;
  const auto yaml = read_yaml(R"(en: { per: impact, uniform: [0.3, 0.6] }
flyrock: 1
gates: []
rock_contacts: false
rocks: [{ name: a, per_trial: 1 }, { name: b, per_trial: 1 }]
terrain: { face_angle: 70 deg, heights: [2, 4, 6], type: benches }
title: 'A "quoted" title'
)",
                              "x.yaml", diagnostics);
  REQUIRE(yaml);
  CHECK(to_json(*reading.value) == to_json(*yaml));
}

TEST_CASE("values are at their place in the table constructors, else at the call") {
  LuaFixture lua;
  const auto reading = read(lua, R"(-- a comment with fr.scenario {
local fr = require "flyrock"
local slope = { type = "plane" }
return fr.scenario {
  title = "t", -- { not this
  ["dimension"] = 2,
  rocks = {
    { name = "a", density = 1 + (2 * 3), [ "per_trial" ] = 1 },
    --[[ nor this ]] { name = [==[ b ]==] },
  },
  terrain = slope,
})");
  REQUIRE(reading.value);
  const Value& root = *reading.value;
  CHECK(place(root) == "4:1");
  CHECK(place(*root.find("title")) == "5:11");
  CHECK(root.map()->front().at.column == 3);
  CHECK(place(*root.find("dimension")) == "6:19");
  const List& rocks = *root.find("rocks")->list();
  CHECK(place(rocks[0]) == "8:5");
  CHECK(place(*rocks[0].find("density")) == "8:29");
  CHECK(place(*rocks[0].find("per_trial")) == "8:60");
  CHECK(place(*rocks[1].find("name")) == "9:31");
  CHECK(place(*root.find("terrain")) == "11:13");
  CHECK(place(*root.find("terrain")->find("type")) == "4:1");
}

TEST_CASE("a plugin may stand in the scenario that uses it") {
  LuaFixture lua;
  const auto reading = read(lua, R"(local fr = require "flyrock"
fr.plugin { kind = "rolling", name = "mine", doc = "d", rolling = function(p) return 0.1 end }
return fr.scenario { materials = { a = { rolling = { type = "mine" } } } })");
  CHECK(reading.messages == "");
  CHECK(lua.session.registry().find(PluginKind::rolling, "mine"));
  CHECK(lua.session.sources().back().name == "x.lua");
}

TEST_CASE("what is wrong with a scenario in Lua") {
  const std::string head = "local fr = require 'flyrock'\n";
  CHECK(messages(head + "return { title = 't' }") ==
        "x.lua:1:1: returns something else, expected `return fr.scenario { ... }` at its end\n");
  CHECK(messages(head + "local s = fr.scenario {}") ==
        "x.lua:1:1: returns nothing, expected `return fr.scenario { ... }` at its end\n");
  CHECK(messages(head + "return fr.scenario(5)") ==
        "x.lua:2:1: fr.scenario takes a table: fr.scenario { ... }\n");
  CHECK(messages(head + "return fr.scenarios {}") ==
        "x.lua:2:1: `fr` has no field `scenarios`, did you mean `scenario`?\n");
  CHECK(messages(head + "return fr.scenario {\n  title = print, en = 0/0,\n  g = 1/0 }") ==
        "x.lua:3:11: title: a function, expected a value: functions may stand only in fr.plugin\n"
        "x.lua:3:23: en: nan, expected a finite number\n"
        "x.lua:4:7: g: inf, expected a finite number\n");
  CHECK(messages(head + "return fr.scenario { rocks = { { 1 }, name = 'a' } }") ==
        "x.lua:2:30: rocks: a table with both names and positions, expected a map or a list\n");
  CHECK(messages(head + "return fr.scenario { points = { 1, nil, 3 } }") ==
        "x.lua:2:36: points[1]: nothing, expected a value: a list has no gaps\n");
  CHECK(messages(head + "return fr.scenario { [true] = 1 }") ==
        "x.lua:2:1: a key that is a boolean, expected texts, or positions from 1 without gaps\n");
  CHECK(messages(head + "local t = {}\nt.self = t\nreturn fr.scenario { a = t }") ==
        "x.lua:4:1: a.self: a table that holds itself, expected a value\n");
  CHECK(messages(head + "return fr.scenario { seed = 9007199254740993 }") ==
        "x.lua:2:29: seed: 9007199254740993, expected a whole number of at most 2^53\n");
  CHECK(messages(head + "return fr.scenario { type = math }") ==
        "x.lua:2:29: type: a plugin or a library, expected a value: a plugin is used by its name, type = "
        "\"NAME\"\n");
  CHECK(messages(head + "local t = {}\nfor i = 1, 200000 do t[i] = i end\nreturn fr.scenario { a = t }")
            .find("more than 100,000 values") != std::string::npos);
  CHECK(messages("return fr.scenario {}") == "x.lua:1:1: `fr` is not defined\n");
  CHECK(messages("local x = 1 +\n\n)") == "x.lua:3:1: unexpected symbol near ')'\n");
  CHECK(messages(head + "error('my own words')") == "x.lua:2:1: my own words\n");
}
