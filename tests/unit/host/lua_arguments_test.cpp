// fr.argument: what it takes, and where it may be called.

#include <catch2/catch.hpp>

#include "unit/lua_fixture.h"

using namespace flyrock;

namespace {

/// The messages of a scenario that reads `arguments`, after some were given.
std::string faults_of_arguments(const std::string& arguments, const std::vector<std::string>& given = {}) {
  LuaFixture lua;
  Diagnostics diagnostics;
  lua.session.arguments().give(given, diagnostics);
  lua.write("x.lua",
            "local fr = require 'flyrock'\n" + arguments + "\nreturn fr.scenario { flyrock = 1, value = v }");
  lua.session.read_scenario((lua.folder / "x.lua").string(), "x.lua", diagnostics);
  lua.session.arguments().refuse_unasked(diagnostics);
  return LuaFixture::messages(diagnostics);
}

/// The value that a scenario gets, as YAML would write it.
LuaArgument answer_to(const std::string& ask, const std::vector<std::string>& given = {}) {
  LuaFixture lua;
  Diagnostics diagnostics;
  lua.session.arguments().give(given, diagnostics);
  lua.write("x.lua", "local fr = require 'flyrock'\nlocal v = " + ask +
                         "\nreturn fr.scenario { flyrock = 1, value = v }");
  lua.session.read_scenario((lua.folder / "x.lua").string(), "x.lua", diagnostics);
  REQUIRE(LuaFixture::messages(diagnostics) == "");
  REQUIRE(lua.session.arguments().asked().size() == 1);
  return lua.session.arguments().asked().front();
}

}  // namespace

TEST_CASE("fr.argument answers the default, or what was given in its type") {
  using Int = std::int64_t;
  CHECK(answer_to("fr.argument('n', 21)") == LuaArgument{"n", Int{21}});
  CHECK(answer_to("fr.argument('n', 21)", {"n=41"}) == LuaArgument{"n", Int{41}});
  CHECK(answer_to("fr.argument('n', 21)", {"n=-3"}) == LuaArgument{"n", Int{-3}});
  CHECK(answer_to("fr.argument('n', 21)", {"n=1.5"}) == LuaArgument{"n", 1.5});
  CHECK(answer_to("fr.argument('n', 0.5)", {"n=1e-3"}) == LuaArgument{"n", 1e-3});
  CHECK(answer_to("fr.argument('n', 'steep')") == LuaArgument{"n", std::string("steep")});
  CHECK(answer_to("fr.argument('n', 'steep')", {"n=12 m"}) == LuaArgument{"n", std::string("12 m")});
  CHECK(answer_to("fr.argument('n', 'steep')", {"n=7"}) == LuaArgument{"n", std::string("7")});
  CHECK(answer_to("fr.argument('n', 'steep')", {"n="}) == LuaArgument{"n", std::string()});
}

TEST_CASE("fr.argument refuses names, defaults and places that it cannot use") {
  const std::string takes =
      "fr.argument takes a name (letters, digits and _) and a default, a number or a text, as "
      "fr.argument(\"stones\", 21)\n";
  for (const char* call :
       {"fr.argument()", "fr.argument('n')", "fr.argument('n', nil)", "fr.argument('n', true)",
        "fr.argument('n', {})", "fr.argument('a b', 1)", "fr.argument('', 1)", "fr.argument(7, 1)",
        "fr.argument('n', 0/0)", "fr.argument('n', math.huge)", "fr.argument('n', 'a\\0b')",
        "fr.argument('n', '\\27')", "fr.argument('n', '\\255')"}) {
    INFO(call);
    CHECK(faults_of_arguments(std::string("local v = ") + call) == "x.lua:2:1: " + takes);
  }
  CHECK(faults_of_arguments("fr.argument('n', 1)\nlocal v = fr.argument('n', 1)") == "");
  CHECK(faults_of_arguments("fr.argument('n', 1)\nlocal v = fr.argument('n', 2)") ==
        "x.lua:3:1: argument `n` is declared with two defaults: 2 and 1\n");
  CHECK(faults_of_arguments("local v = fr.argument('stones', 1)", {"stone=2"}) ==
        "--arg stone=2:0:0: unknown argument `stone`, did you mean `stones`?\n");
  CHECK(faults_of_arguments("local v = fr.argument('n', 'x')", {"n=\x1b"}) ==
        "--arg n=\x1b:0:0: the value holds the control character \\x1B\n");
}

TEST_CASE("A module of a scenario may ask for an argument") {
  LuaFixture lua;
  Diagnostics diagnostics;
  lua.session.arguments().give({"n=5"}, diagnostics);
  lua.write("parts.lua", "local fr = require 'flyrock'\nreturn { n = fr.argument('n', 3) }");
  lua.write("x.lua",
            "local fr, parts = require 'flyrock', require 'parts'\nreturn fr.scenario { flyrock = parts.n }");
  const auto value = lua.session.read_scenario((lua.folder / "x.lua").string(), "x.lua", diagnostics);
  REQUIRE(LuaFixture::messages(diagnostics) == "");
  CHECK(*value->find("flyrock")->number() == 5);
}
