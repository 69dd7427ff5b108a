// What a law in Lua remembers, and which forms and answers a manifest may have.

#include <catch2/catch.hpp>

#include "plugin/contact_law.h"
#include "plugin/registry.h"
#include "unit/lua_fixture.h"

using namespace flyrock;

namespace {

PluginUse use_of(const LuaFixture& lua, PluginKind kind, const std::string& name) {
  PluginUse use;
  use.plugin = lua.session.registry().find(kind, name);
  REQUIRE(use.plugin);
  return use;
}

std::string friction(const std::string& fields, const std::string& body) {
  return "local fr = require 'flyrock'\nreturn fr.plugin { kind = 'friction', name = 'f', doc = 'd', " +
         fields + "\n  friction = function(p, contact)\n    " + body + "\n  end }\n";
}

/// The message of one call with a memory of two numbers.
std::string failure(const std::string& body) {
  LuaFixture lua;
  lua.write("f.lua", friction("history = { 'slip', 'age' },", body));
  REQUIRE(lua.load("f.lua") == "");
  double memory[2] = {};
  ContactState contact;
  contact.history = memory;
  try {
    make_instance<FrictionLaw>(use_of(lua, PluginKind::friction, "f"), 2)->friction({}, contact);
  } catch (const PluginError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a law reads and writes its memory, which the engine keeps") {
  LuaFixture lua;
  lua.write("f.lua", friction("history = { 'slip', 'age' }, history_of = 'contact',",
                              "local h = contact.history\n    h.slip = h.slip + contact.slip_speed * "
                              "contact.step\n    return 1 / (1 + h.slip)"));
  REQUIRE(lua.load("f.lua") == "");
  const PluginUse use = use_of(lua, PluginKind::friction, "f");
  CHECK(use.plugin->spec.history == std::vector<std::string>{"slip", "age"});
  CHECK(use.plugin->spec.history_of_contact);
  const auto law = make_instance<FrictionLaw>(use, 2);
  CHECK_FALSE(law->constant());
  double one[2] = {}, other[2] = {3, 0};
  ContactState contact;
  contact.slip_speed = 2;
  contact.step = 0.5;
  contact.history = one;
  CHECK(law->friction({}, contact).mu_s == 0.5);
  CHECK(law->friction({}, contact).mu_s == Approx(1.0 / 3));
  contact.history = other;
  CHECK(law->friction({}, contact).mu_s == 0.2);
  CHECK(one[0] == 2);
  CHECK(other[0] == 4);
}

TEST_CASE("a memory holds finite numbers under its names alone") {
  CHECK(failure("contact.history.slip = 0/0; return 1") ==
        "plugin f, f.lua:4: `contact.history.slip` was set to a number that is not finite, expected a finite "
        "number");
  CHECK(failure("contact.history.slip = 'far'; return 1") ==
        "plugin f, f.lua:4: `contact.history.slip` was set to string, expected a finite number");
  CHECK(failure("contact.history.slop = 1; return 1") ==
        "plugin f, f.lua:4: `contact.history` has no field `slop`, did you mean `slip`?");
}

TEST_CASE("a manifest says what is wrong with its history and its form") {
  const auto fault = [](const std::string& text) {
    LuaFixture lua;
    lua.write("f.lua", text);
    return lua.load("f.lua");
  };
  const auto of = [&](const std::string& fields) { return fault(friction(fields, "return 1")); };
  CHECK(of("history_of = 'pair',").find("there is none: expected `history`") != std::string::npos);
  CHECK(of("history = { 'a' }, history_of = 'body',").find("`body`, expected `pair` or `contact`") !=
        std::string::npos);
  CHECK(of("history = { 'a', 'a' },").find("`a` twice") != std::string::npos);
  CHECK(of("history = { 'a', 'b', 'c', 'd', 'e' },").find("5 names, expected at most 4") !=
        std::string::npos);
  CHECK(fault("local fr = require 'flyrock'\nreturn fr.plugin { kind = 'restitution', name = 'r', doc = 'd', "
              "form = 'poison', "
              "impact = function(p) return 1 end }\n")
            .find("`poison`, expected `newton`, `newton_mean`, `poisson`, `energy` or `velocity`") !=
        std::string::npos);
}

TEST_CASE("e_t is refused where the form has none") {
  LuaFixture lua;
  lua.write("r.lua",
            "local fr = require 'flyrock'\nreturn fr.plugin { kind = 'restitution', name = 'r', doc = 'd', "
            "form = 'poisson',\n"
            "  impact = function(p) return 0.5, 0.1 end }\n");
  REQUIRE(lua.load("r.lua") == "");
  PluginUse use = use_of(lua, PluginKind::restitution, "r");
  use.values.resize(1);  // allow_gain, not given
  const auto law = make_instance<RestitutionLaw>(use, 2);
  const std::vector<double> allow_gain = {0};
  CHECK_THROWS_WITH(check_answer(*law, law->impact(allow_gain, {})),
                    "plugin r, r.lua:3: impact() returned e_t = 0.1, must be 0: the form poisson has no "
                    "tangential restitution");
}
