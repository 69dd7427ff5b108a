// Loading plugins: the built-in ones, users' own, and what is wrong with a manifest.

#include <catch2/catch.hpp>

#include "host/session.h"
#include "unit/lua_fixture.h"

using namespace flyrock;

TEST_CASE("every built-in plugin is registered with its documentation") {
  LuaSession session(FLYROCK_SHARE_DIR);
  for (int k = 0; k < plugin_kinds; ++k) {
    const auto plugins = session.registry().of_kind(static_cast<PluginKind>(k));
    CHECK_FALSE(plugins.empty());
    for (const Plugin* plugin : plugins) {
      INFO(plugin->spec.file);
      CHECK_FALSE(plugin->spec.doc.empty());
      for (const ParamSpec& param : plugin->spec.params) CHECK_FALSE(param.doc.empty());
    }
  }
  CHECK(session.registry().find(PluginKind::restitution, "newton"));
  CHECK(session.registry().find(PluginKind::restitution, "pfeiffer_bowen"));
  CHECK_FALSE(session.sources().empty());
}

TEST_CASE("a broken installation names the file") {
  CHECK_THROWS_WITH(LuaSession("/nowhere"), Catch::Contains("the folder /nowhere is missing"));
}

TEST_CASE("limits and defaults are converted from the declared unit") {
  LuaFixture lua;
  lua.write("law.lua", R"(local fr = require "flyrock"
return fr.plugin {
  kind = "friction", name = "angle", doc = "by angle",
  params = {
    angle = fr.number { default = 30, min = 0, below = 90, unit = "deg", doc = "friction angle" },
    speed = fr.vector { default = { 36, 0 }, unit = "km/h", doc = "a speed" },
    count = fr.integer { default = 3, doc = "a count" },
    wet = fr.boolean { default = true, doc = "rain" },
    mode = fr.choice { choices = { "a", "b" }, default = "b", doc = "which" },
  },
  friction = function(p) return math.tan(p.angle) end,
})");
  CHECK(lua.load("law.lua") == "");
  const Plugin* plugin = lua.session.registry().find(PluginKind::friction, "angle");
  REQUIRE(plugin);
  const PluginSpec& spec = plugin->spec;
  REQUIRE(spec.params.size() == 5);
  const ParamSpec& angle = spec.params[spec.find("angle")];
  CHECK(*angle.default_number == Approx(pi / 6));
  CHECK(*angle.below == Approx(pi / 2));
  CHECK(angle.dimension == dimension::angle);
  CHECK(spec.params[spec.find("speed")].default_vector->at(0) == Approx(10));
  CHECK(*spec.params[spec.find("wet")].default_number == 1);
  CHECK(*spec.params[spec.find("mode")].default_text == "b");
  CHECK(spec.file == "law.lua");
}

TEST_CASE("all faults of a manifest are told at once, each at its place") {
  LuaFixture lua;
  lua.write("bad.lua", R"(local fr = require "flyrock"
return fr.plugin {
  kind = "restitutoin", name = "Bad Name",
  sorce = "me",
  reads = { "contact.aproach_speed" },
  params = {
    en = fr.number { default = 2, max = 1, doc = "too much" },
    v = fr.number { unit = "m/sec", doc = "a speed" },
    mode = fr.choice { doc = "which" },
    raw = 5,
    x = fr.number { defualt = 1 },
    way = fr.vector { default = { 1 }, doc = "where to" },
  },
})");
  CHECK(lua.load("bad.lua") ==
        "bad.lua:2:1: doc: missing, expected text\n"
        "bad.lua:3:10: kind: unknown kind `restitutoin`, did you mean `restitution`?\n"
        "bad.lua:3:32: name: `Bad Name`, expected small letters, digits and _, a letter first\n"
        "bad.lua:4:3: sorce: unknown key, did you mean `source`?\n"
        "bad.lua:5:11: reads: unknown field `contact.aproach_speed`, did you mean `contact.approach_speed`?\n"
        "bad.lua:7:32: params.en.default: 2, expected a number of at most 1\n"
        "bad.lua:8:28: params.v.unit: unknown unit `sec`\n"
        "bad.lua:9:12: params.mode.choices: missing, expected a list of texts: choices = { \"a\", \"b\" }\n"
        "bad.lua:10:11: params.raw: a number, expected a table of named fields\n"
        "bad.lua:11:21: params.x.defualt: unknown key, did you mean `default`?\n"
        "bad.lua:12:33: params.way.default: has 1 components, expected 2 (a default in 2D) or 3 (in 3D)\n");
}

TEST_CASE("a limit may be another parameter of the same unit") {
  LuaFixture lua;
  const auto message = [&](const std::string& params) {
    static int count = 0;
    const std::string name = "p" + std::to_string(++count);
    lua.write("p.lua", "local fr = require 'flyrock'\nreturn fr.plugin { kind = 'friction', name = '" + name +
                           "', doc = 'd', friction = function(p) return p.mu_s, p.mu_d end, params = {\n" +
                           params + " } }");
    return lua.load("p.lua");
  };
  CHECK(message("mu_s = fr.number { min = 0 }, mu_d = fr.number { min = 0, max = 'mu_s' }") == "");
  const PluginSpec& spec = lua.session.registry().find(PluginKind::friction, "p1")->spec;
  const ParamSpec& mu_d = spec.params[spec.find("mu_d")];
  REQUIRE(mu_d.bounds.size() == 1);
  CHECK((mu_d.bounds[0].other == "mu_s" && mu_d.bounds[0].relation == BoundRelation::at_most &&
         mu_d.min == 0.0));
  CHECK(message("mu_s = fr.number {}, mu_d = fr.number { max = 'mu_a' }") ==
        "p.lua:3:47: params.mu_d.max: `mu_a`, expected a number, or the name of another parameter that is a "
        "number, did you mean "
        "`mu_s`?\n");
  CHECK(message("mu_s = fr.number {}, mu_d = fr.number { below = 'mu_d' }") ==
        "p.lua:3:49: params.mu_d.below: `mu_d`, expected a number, or the name of another parameter that is "
        "a number, did you mean "
        "`mu_s`?\n");
  CHECK(message("mu_s = fr.number { unit = 'm' }, mu_d = fr.number { max = 'mu_s' }") ==
        "p.lua:3:59: params.mu_d.max: `mu_s` has other units than `mu_d`\n");
  CHECK(message("mu_s = fr.number { default = 0.2 }, mu_d = fr.number { default = 0.3, max = 'mu_s' }") ==
        "p.lua:3:77: params.mu_d.max: the default must be at most that of `mu_s`\n");
  CHECK(message("mu_s = fr.number {}, mu_d = fr.number { max = { 1 } }") ==
        "p.lua:3:47: params.mu_d.max: a list, expected a number, or the name of another parameter\n");
  CHECK(message("mu_s = fr.number {}, mu_d = fr.vector { max = 'mu_s' }") ==
        "p.lua:3:47: params.mu_d.max: text, expected a number\n");
}

TEST_CASE("a plugin is native or Lua, with the function of its kind") {
  LuaFixture lua;
  const auto message = [&](const std::string& fields) {
    lua.write(
        "p.lua",
        "local fr = require 'flyrock'\nreturn fr.plugin { kind = 'restitution', name = 'p', doc = 'd',\n" +
            fields + " }");
    return lua.load("p.lua");
  };
  CHECK(message("") ==
        "p.lua:2:1: impact: missing: a restitution needs the function `impact`, or `native`\n");
  CHECK(message("impact = function(p) return 0 end, native = 'newton'") ==
        "p.lua:3:45: native: both `native` and the function `impact`, expected one of the two\n");
  CHECK(message("native = 'newton'") ==
        "p.lua:3:10: native: no shared object `newton.so` beside the manifest\n");
  CHECK(message("friction = function(p) return 0 end, impact = function(p) return 0 end") ==
        "p.lua:3:1: friction: a restitution has no function `friction`, expected `impact`\n");
  CHECK(message("form = 'elastic', impact = function(p) return 0 end") ==
        "p.lua:3:8: form: `elastic`, expected `newton`, `newton_mean`, `poisson`, `energy` or `velocity`\n");
  CHECK(message("impact = 0.5") == "p.lua:3:10: impact: a number, expected a function\n");
}

TEST_CASE("a native plugin comes from the folder of its manifest, and nothing else is opened") {
  LuaFixture lua;
  namespace fs = std::filesystem;
  const auto manifest = [](const std::string& native) {
    return "local fr = require 'flyrock'\nfr.plugin { kind = 'restitution', name = 'p', doc = 'd',\nnative = "
           "'" +
           native + "' }\n";
  };
  const std::string object = (lua.folder / "outside.so").string();
  fs::copy_file(fs::path(FLYROCK_MODULE_DIR) / "flyrock_plugins.so", object);
  fs::create_directories(lua.folder / "in");
  fs::create_symlink("../outside.so", lua.folder / "in/link.so");
  fs::create_symlink("..", lua.folder / "in/up");

  const std::string no_path =
      ", expected the name of a shared object beside the manifest: small letters, digits and _, a letter "
      "first\n";
  for (const std::string& native : {std::string("../outside"), (lua.folder / "outside").string(),
                                    std::string("up/outside"), std::string("../in/link"), std::string("")}) {
    lua.write("in/p.lua", manifest(native));
    CHECK(lua.load("in/p.lua") == "in/p.lua:3:10: native: `" + native + "`" + no_path);
  }
  lua.write("in/p.lua", manifest("link"));
  CHECK(lua.load("in/p.lua") == "in/p.lua:3:10: native: `link.so` leads out of the folder of in/p.lua\n");
  lua.write("in/scenario.lua", manifest("link") + "return fr.scenario {}");
  Diagnostics diagnostics;
  lua.session.read_scenario((lua.folder / "in/scenario.lua").string(), "scenario.lua", diagnostics);
  CHECK(LuaFixture::messages(diagnostics) ==
        "scenario.lua:3:10: native: `link.so` leads out of the folder of scenario.lua\n");

  std::ifstream maps("/proc/self/maps");
  const std::string opened((std::istreambuf_iterator<char>(maps)), {});
  CHECK(opened.find("flyrock_plugins.so") != opened.npos);
  CHECK(opened.find("outside.so") == opened.npos);
  lua.write("in/real.so", "no object");
  fs::create_symlink("real.so", lua.folder / "in/alias.so");
  lua.write("in/p.lua", manifest("alias"));
  CHECK(lua.load("in/p.lua").find("native: cannot open the module") !=
        std::string::npos);  // a link within the folder is followed
}

TEST_CASE("files that are no plugins say so") {
  LuaFixture lua;
  lua.write("empty.lua", "local x = 1\n");
  CHECK(lua.load("empty.lua") == "empty.lua:1:1: registers no plugin, expected `return fr.plugin { ... }`\n");
  lua.write("syntax.lua", "local x = = 1\n");
  CHECK(lua.load("syntax.lua") == "syntax.lua:1:1: unexpected symbol near '='\n");
  CHECK(lua.load("absent.lua") ==
        ":0:0: plugins: cannot read `absent.lua`, expected a Lua file, or a folder with plugin.lua in it\n");
  lua.write("twice.lua", R"(local fr = require "flyrock"
return fr.plugin { kind = "restitution", name = "newton", doc = "again", impact = function(p) return 0 end })");
  CHECK(lua.load("twice.lua") ==
        "twice.lua:2:49: name: the restitution `newton` is already registered by "
        "plugins/restitution/newton/plugin.lua\n");
}

TEST_CASE("a plugin may be a folder, and require modules beside it") {
  LuaFixture lua;
  lua.write("mine/plugin.lua", R"(local fr = require "flyrock"
local constants = require "constants"
return fr.plugin { kind = "rolling", name = "mine", doc = "d", rolling = function(p) return constants.mu_r end })");
  lua.write("mine/constants.lua", "return { mu_r = 0.25 }");
  CHECK(lua.load("mine") == "");
  CHECK(lua.session.registry().find(PluginKind::rolling, "mine"));
  CHECK(lua.session.sources().back().name == "mine/constants.lua");
  lua.write("lost.lua", "local x = require 'nothing'");
  CHECK(lua.load("lost.lua") ==
        "lost.lua:1:1: require: cannot read `nothing.lua`, expected a module in the folder of the file\n");
  const std::string longest(300, 'x');  // no file system takes this name
  lua.write("long.lua", "local x = require '" + longest + "'");
  CHECK(lua.load("long.lua") == "long.lua:1:1: require: cannot read `" + longest +
                                    ".lua`, expected a module in the folder of the file\n");
  lua.write("out.lua", "local x = require '../x'");
  CHECK(lua.load("out.lua") ==
        "out.lua:1:1: require: `../x` is not a module, expected letters, digits and _, with dots for "
        "folders\n");
}

TEST_CASE("require stays in the folder, and files have a size") {
  LuaFixture lua;
  lua.write("mine/plugin.lua", "local x = require 'link'");
  lua.write("outside.lua", "return 1");
  std::filesystem::create_symlink("../outside.lua", lua.folder / "mine/link.lua");
  CHECK(lua.load("mine") ==
        "mine/plugin.lua:1:1: require: `link` leads out of the folder of mine/plugin.lua\n");
  lua.write("huge.lua", std::string(5 << 20, '\n'));
  CHECK(lua.load("huge.lua") ==
        ":0:0: plugins: `huge.lua` is larger than 4 MiB, expected a Lua file, or a folder with plugin.lua in "
        "it\n");
  CHECK(lua.load("/dev/zero").find("cannot read `/dev/zero`") != std::string::npos);
}

TEST_CASE("a byte order mark and a first line for the shell are no Lua") {
  LuaFixture lua;
  lua.write("bom.lua", "\xEF\xBB\xBF#!/usr/bin/lua\nlocal x = = 1\n");
  CHECK(lua.load("bom.lua") == "bom.lua:2:1: unexpected symbol near '='\n");
}
