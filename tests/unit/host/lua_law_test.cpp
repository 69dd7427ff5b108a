// Contact laws written in Lua: what they get, what they may answer, how their errors read.

#include <malloc.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "plugin/contact_law.h"
#include "plugin/registry.h"
#include "unit/lua_fixture.h"

using namespace flyrock;

namespace lua_law_test {

namespace {

/// A use of a plugin with constant numbers, in the order of its manifest.
PluginUse use_of(const LuaSession& session, PluginKind kind, const std::string& name,
                 const std::vector<std::optional<double>>& numbers) {
  PluginUse use;
  use.plugin = session.registry().find(kind, name);
  REQUIRE(use.plugin);
  for (std::size_t i = 0; i < use.plugin->spec.params.size(); ++i) {
    const auto& number = i < numbers.size() ? numbers[i] : std::nullopt;
    const auto& text = use.plugin->spec.params[i].default_text;
    ParamValue value;
    value.given = number || text;
    if (number) value.numbers = {Number{*number, -1}};
    if (text) value.text = *text;
    use.values.push_back(value);
  }
  use.slots = dense_slots(use.values);
  return use;
}

std::vector<double> values_of(const PluginUse& use) {
  std::vector<double> values;
  for (const Number& slot : use.slots) values.push_back(slot.constant);
  return values;
}

std::string restitution(const std::string& params, const std::string& function) {
  return "local fr = require 'flyrock'\nreturn fr.plugin {\n  kind = 'restitution', name = 'my_law', doc = "
         "'d',\n  params = {" +
         params + "},\n  impact = " + function + "\n}\n";
}

/// The message of one call of a law without parameters.
std::string failure(const std::string& function) {
  LuaFixture lua;
  lua.write("my_law.lua", restitution("", function));
  REQUIRE(lua.load("my_law.lua") == "");
  const auto use = use_of(lua.session, PluginKind::restitution, "my_law", {});
  const auto law = make_instance<RestitutionLaw>(use, 2);
  try {
    check_answer(*law, law->impact({}, ContactState{}));
  } catch (const PluginError& error) {
    return error.what();
  }
  return "";
}

ContactState sampled_contact(RandomStream& rng) {
  ContactState contact;
  for (const ContactField& field : contact_fields())
    if (field.number) contact.*field.number = rng.uniform(0, 20);
  contact.dimension = 3;
  contact.normal = Vec3(0.48, 0.6, 0.64);
  contact.place = Vec3(1, 2, 3);
  contact.slip = Vec3(4, 5, 6);
  contact.group_a = "blocks";
  contact.group_b = "terrain.face";
  contact.material = "face_rock";
  return contact;
}

}  // namespace

TEST_CASE("the vectors of a contact cannot be changed, and can be read in every way") {
  for (const char* field : {"normal", "place", "slip"})
    for (const std::string write :
         {"contact.FIELD[1] = 5", "contact.FIELD[4] = 5", "local v = contact.FIELD v[2] = v[2] + 1",
          "contact.FIELD.x = 1", "table.sort(contact.FIELD)", "table.insert(contact.FIELD, 1)"}) {
      const std::size_t at = write.find("FIELD");
      const std::string code = std::string(write).replace(at, 5, field);
      INFO(code);
      CHECK(failure("function(p, contact) " + code + " return 0.3 end") ==
            "plugin my_law, my_law.lua:5: `contact." + std::string(field) + "` cannot be changed");
    }
  LuaFixture lua;
  const std::string text = restitution("", R"(function(p, contact)
    local n, again = contact.normal, contact.normal
    assert(#n == contact_dimension(n) and rawlen(n) == #n and n == again)
    local sum, count = 0, 0
    for i, component in ipairs(n) do sum, count = sum + component * component, i end
    for i, component in pairs(contact.slip) do assert(contact.slip[i] == component) end
    assert(count == #n and math.abs(sum - 1) < 1e-12)
    local copy = { table.unpack(n) }
    copy[1] = 7
    assert(copy[1] == 7 and contact.normal[1] ~= 7 and contact.place[1] == 1)
    return contact.slip[2] / 10
  end)");
  lua.write("my_law.lua", "local function contact_dimension(v) return v[3] and 3 or 2 end\n" + text);
  REQUIRE(lua.load("my_law.lua") == "");
  const auto use = use_of(lua.session, PluginKind::restitution, "my_law", {});
  RandomStream rng(1, "test", {});
  for (const int dimension : {3, 2, 3}) {
    const auto law = make_instance<RestitutionLaw>(use, dimension);
    ContactState contact = sampled_contact(rng);
    contact.dimension = dimension;
    if (dimension == 2) contact.normal = Vec3(0.6, 0.8, 0);
    CHECK(law->impact({}, contact).e_n == 0.5);
    contact.slip[1] = 7;
    CHECK(law->impact({}, contact).e_n == 0.7);
  }
}

TEST_CASE("a law in Lua reads its parameters and its contact") {
  LuaSession session(FLYROCK_SHARE_DIR);
  const auto use = use_of(session, PluginKind::restitution, "pfeiffer_bowen", {0.35, 0.1, 9.144});
  const auto law = make_instance<RestitutionLaw>(use, 2);
  CHECK_FALSE(law->constant());
  CHECK(law->origin() == "pfeiffer_bowen, plugins/restitution/pfeiffer_bowen/plugin.lua:16");
  ContactState contact;
  contact.approach_speed = 9.144;
  const auto answer = law->impact(values_of(use), contact);
  CHECK(answer.e_n == 0.175);
  CHECK(answer.e_t == 0.1);
  const std::vector<double> drawn{0.5, 0.2, 9.144};  // a draw has changed
  CHECK(law->impact(drawn, contact).e_n == 0.25);
}

TEST_CASE("every field of a contact reaches Lua unchanged") {
  LuaFixture lua;
  for (const ContactField& field : contact_fields()) {
    const std::string name(field.name);
    std::string plugin = "f_" + name;
    std::replace(plugin.begin(), plugin.end(), '.', '_');
    lua.write(plugin + ".lua",
              "local fr = require 'flyrock'\nreturn fr.plugin { kind = 'restitution', name = '" + plugin +
                  "', doc = 'd', may_gain = true, reads = { '" + field.read_name() +
                  "' }, impact = function(p, contact) return " +
                  (field.number   ? "contact." + name
                   : field.flag   ? "contact." + name + " and 1 or 0"
                   : field.vector ? "contact." + name + "[2] + #contact." + name
                                  : "#contact." + name) +
                  " end }");
    REQUIRE(lua.load(plugin + ".lua") == "");
    const auto use = use_of(lua.session, PluginKind::restitution, plugin, {});
    const auto law = make_instance<RestitutionLaw>(use, 2);
    RandomStream rng(1, "test", {});
    ContactState contact = sampled_contact(rng);
    contact.normal_force = 70;
    contact.shape_flatness = 0.5;
    contact.partner_mass = 3;
    contact.partner_radius = 2;
    contact.partner_moves = true;
    const double expected = field.number   ? contact.*field.number
                            : field.flag   ? (contact.*field.flag ? 1 : 0)
                            : field.vector ? (contact.*field.vector).y() + 3
                                           : static_cast<double>((contact.*field.text).size());
    CHECK(law->impact({}, contact).e_n == expected);
  }
}

TEST_CASE("the same law in Lua and native gives the same bytes") {
  LuaFixture lua;
  lua.write("lua_newton.lua", R"(local fr = require "flyrock"
fr.plugin {
  kind = "restitution", name = "lua_newton", doc = "newton in Lua", form = "newton",
  params = { en = fr.number { min = 0 }, et = fr.number { default = 0, min = -1, max = 1 } },
  impact = function(p) return p.en, p.et end,
}
fr.plugin {
  kind = "friction", name = "lua_coulomb", doc = "coulomb in Lua",
  params = { mu = fr.number { optional = true, min = 0 }, angle = fr.number { optional = true, unit = "deg" } },
  friction = function(p) return p.mu or math.tan(p.angle) end,
})");
  REQUIRE(lua.load("lua_newton.lua") == "");
  RandomStream rng(7, "test", {});
  for (int i = 0; i < 100; ++i) {
    const ContactState contact = sampled_contact(rng);
    const double en = rng.uniform(), et = rng.uniform(-1, 1);
    const auto with = [&](const std::string& name) {
      const PluginSpec& spec = lua.session.registry().find(PluginKind::restitution, name)->spec;
      std::vector<std::optional<double>> numbers(spec.params.size());
      numbers[spec.find("en")] = en;
      numbers[spec.find("et")] = et;
      return use_of(lua.session, PluginKind::restitution, name, numbers);
    };
    const auto native = with("newton"), scripted = with("lua_newton");
    const auto a = make_instance<RestitutionLaw>(native, 2)->impact(values_of(native), contact);
    const auto b = make_instance<RestitutionLaw>(scripted, 2)->impact(values_of(scripted), contact);
    CHECK(a.e_n == b.e_n);
    CHECK(a.e_t == b.e_t);
    for (const bool by_angle : {false, true}) {
      const double value = rng.uniform(0, 1.4);
      const auto friction = [&](const std::string& name) {
        const auto& spec = lua.session.registry().find(PluginKind::friction, name)->spec;
        std::vector<std::optional<double>> numbers(2);
        numbers[spec.find(by_angle ? "angle" : "mu")] = value;
        const auto use = use_of(lua.session, PluginKind::friction, name, numbers);
        return make_instance<FrictionLaw>(use, 2)->friction(values_of(use), contact);
      };
      CHECK(friction("coulomb").mu_s == friction("lua_coulomb").mu_s);
      CHECK(friction("coulomb").mu_d == friction("lua_coulomb").mu_d);
    }
  }
}

TEST_CASE("a law that takes its parameters alone is constant") {
  LuaFixture lua;
  lua.write("a.lua", restitution("en = fr.number { default = 1 }", "function(p) return p.en end"));
  REQUIRE(lua.load("a.lua") == "");
  CHECK(make_instance<RestitutionLaw>(use_of(lua.session, PluginKind::restitution, "my_law", {1.0}), 2)
            ->constant());
}

TEST_CASE("wrong answers of a law name the plugin, the place and what was expected") {
  CHECK(failure("function(p, c) return -0.2 end") ==
        "plugin my_law, my_law.lua:5: impact() returned e_n = -0.2, must be at least 0");
  CHECK(failure("function(p, c) end") ==
        "plugin my_law, my_law.lua:5: impact() returned nil for e_n, expected a number");
  CHECK(failure("function(p, c) return '0.5' end") ==
        "plugin my_law, my_law.lua:5: impact() returned string for e_n, expected a number");
  CHECK(failure("function(p, c) return 0.5, true end") ==
        "plugin my_law, my_law.lua:5: impact() returned boolean for e_t, expected a number");
  CHECK(failure("function(p, c) return 0/0 end") ==
        "plugin my_law, my_law.lua:5: impact() returned e_n = nan, must be finite");
  CHECK(failure("function(p, c) return 1.5 end") ==
        "plugin my_law, my_law.lua:5: impact() returned e_n = 1.5, must be at most 1: the impact would gain "
        "energy, "
        "which `allow_gain: true` among the law's parameters permits");
  CHECK(failure("function(p, c) return 0.5, -1.5 end") ==
        "plugin my_law, my_law.lua:5: impact() returned e_t = -1.5, must be from -1 to 1: the impact would "
        "gain "
        "energy, which `allow_gain: true` among the law's parameters permits");
  CHECK(failure("function(p, c) return 1, 0, 3 end") ==
        "plugin my_law, my_law.lua:5: impact() returned a third value, expected e_n, e_t");
}

TEST_CASE("errors while a law runs name the line") {
  CHECK(
      failure("function(p, c)\n    return c.aproach_speed\n  end") ==
      "plugin my_law, my_law.lua:6: `contact` has no field `aproach_speed`, did you mean `approach_speed`?");
  CHECK(failure("function(p, c)\n    return p.em\n  end") ==
        "plugin my_law, my_law.lua:6: `p` has no field `em`");
  CHECK(failure("function(p, c)\n    return nil + 1\n  end") ==
        "plugin my_law, my_law.lua:6: attempt to perform arithmetic on a nil value");
  CHECK(failure("function(p, c)\n    c.gap = 1\n    return 1\n  end") ==
        "plugin my_law, my_law.lua:6: `contact` cannot be changed");
  CHECK(failure("function(p, c)\n    p.en = 1\n    return 1\n  end") ==
        "plugin my_law, my_law.lua:6: `p` cannot be changed");
  CHECK(failure("function(p, c) error({}) end") ==
        "plugin my_law, my_law.lua:5: raised an error that is not a text but a table");
  CHECK(failure("function(p, c)\n    counter = 1\n  end") ==
        "plugin my_law, my_law.lua:6: globals are frozen after loading: `counter` cannot be set, use a local "
        "variable");
}

TEST_CASE("what stands outside of a law is put back after each call") {
  LuaFixture lua;
  lua.write("wear.lua", R"(local fr = require "flyrock"
local worn, nan, kept = 0, 0 / 0, nil
return fr.plugin { kind = "restitution", name = "my_law", doc = "d", impact = function(p, contact)
  local before = worn
  assert(nan ~= nan)
  if contact.gap == 1 then worn = worn + 1 end
  if contact.gap == 2 then kept = contact end
  if contact.gap == 3 then worn = 5; error("worn out") end
  return before
end })");
  REQUIRE(lua.load("wear.lua") == "");
  const auto use = use_of(lua.session, PluginKind::restitution, "my_law", {});
  const auto law = make_instance<RestitutionLaw>(use, 2);
  const auto at_gap = [&](double gap) {
    ContactState contact;
    contact.gap = gap;
    return law->impact({}, contact).e_n;
  };
  const std::string changed =
      "plugin my_law, wear.lua:3: impact() changed `{}`, a local variable outside of it: a "
      "plugin keeps nothing from call to call, so that every run is the same";
  CHECK(at_gap(0) == 0);
  CHECK_THROWS_WITH(at_gap(1), fmt::format(fmt::runtime(changed), "worn"));
  CHECK_THROWS_WITH(at_gap(2), fmt::format(fmt::runtime(changed), "kept"));
  CHECK_THROWS_WITH(at_gap(3), "plugin my_law, wear.lua:8: worn out");
  CHECK(at_gap(0) == 0);
}

TEST_CASE("tables outside of a law are frozen and work as before") {
  LuaFixture lua;
  lua.write("class.lua", R"(local fr = require "flyrock"
local Law = { half = 0.5 }
Law.__index = Law
Law.__add = function(a, b) return a.en + b.en end
function Law.new(en) return setmetatable({ en = en }, Law) end
function Law:at(speed) return self.en * self.half ^ speed end
local one = Law.new(1)
local strict = setmetatable({ known = 1 }, { __index = function(t, key) return key .. "?" end })
local list = { 7, 8, 9 }
return fr.plugin { kind = "restitution", name = "my_law", doc = "d", may_gain = true, impact = function(p, contact)
  local two = Law.new(2)
  assert(getmetatable(one) == Law and getmetatable(two) == Law)
  assert(one + two == 3 and one:at(1) == 0.5 and two:at(0) == 2)
  assert(strict.known == 1 and strict.other == "other?")
  assert(#list == 3 and next(list) == 1 and rawlen(list) == 3 and rawget(list, 3) == 9)
  assert(table.concat(list, ",") == "7,8,9" and select(2, table.unpack(list)) == 8)
  local sum = 0
  for _, x in ipairs(list) do sum = sum + x end
  for _, x in pairs(list) do sum = sum + x end
  for _, change in ipairs {
    function() list[1] = 0 end, function() table.insert(list, 1) end, function() table.remove(list) end,
    function() Law.half = 1 end, function() one.en = 1 end, function() setmetatable(list, {}) end,
    function() getmetatable(two).__index = nil end, function() strict.new = 1 end,
  } do
    assert(not pcall(change))
  end
  return sum
end })");
  REQUIRE(lua.load("class.lua") == "");
  const auto use = use_of(lua.session, PluginKind::restitution, "my_law", {});
  const auto law = make_instance<RestitutionLaw>(use, 2);
  for (int call = 0; call < 2; ++call) CHECK(law->impact({}, {}).e_n == 48);
  CHECK(make_instance<RestitutionLaw>(use, 2)->impact({}, {}).e_n == 48);  // frozen once more
}

TEST_CASE("a call of a law makes no garbage") {
  LuaSession session(FLYROCK_SHARE_DIR);
  const auto use = use_of(session, PluginKind::restitution, "pfeiffer_bowen", {0.35, 0.1, 9.144});
  const auto law = make_instance<RestitutionLaw>(use, 2);
  auto values = values_of(use);
  ContactState contact;
  const auto call = [&](int i) {
    contact.approach_speed = 0.1 * i;
    values[0] = 0.3 + 1e-3 * i;  // a draw that changes
    law->impact(values, contact);
  };
  call(0);
  const std::size_t before = mallinfo2().uordblks;
  for (int i = 1; i <= 100; ++i) call(i);
  CHECK(mallinfo2().uordblks == before);
}

TEST_CASE("friction, rolling and the normal condition") {
  LuaFixture lua;
  lua.write("laws.lua", R"(local fr = require "flyrock"
fr.plugin { kind = "friction", name = "two", doc = "d", friction = function(p, c) return 0.6, 0.4 end }
fr.plugin { kind = "friction", name = "one", doc = "d", friction = function(p) return 0.6 end }
fr.plugin { kind = "rolling", name = "r", doc = "d", rolling = function(p, c) return 0.1 * c.radius end }
fr.plugin { kind = "unilateral", name = "u", doc = "d", condition = function(p) return "signorini" end }
fr.plugin { kind = "unilateral", name = "v", doc = "d", condition = function(p) return "glue" end }
)");
  REQUIRE(lua.load("laws.lua") == "");
  const auto friction = [&](const std::string& name) {
    return make_instance<FrictionLaw>(use_of(lua.session, PluginKind::friction, name, {}), 2)
        ->friction({}, {});
  };
  CHECK(friction("two").mu_d == 0.4);
  CHECK(friction("one").mu_d == 0.6);
  ContactState contact;
  contact.radius = 0.5;
  const Rolling rolling =
      make_instance<RollingLaw>(use_of(lua.session, PluginKind::rolling, "r", {}), 2)->rolling({}, contact);
  CHECK(rolling.mu_r == 0.05);
  CHECK(rolling.mu_spin == Approx(0.02).epsilon(1e-15));
  const auto condition = [&](const std::string& name) {
    return make_instance<UnilateralLaw>(use_of(lua.session, PluginKind::unilateral, name, {}), 2)
        ->condition({}, {})
        .condition;
  };
  CHECK(condition("u") == NormalCondition::signorini);
  CHECK_THROWS_WITH(
      condition("v"),
      "plugin v, laws.lua:6: condition() returned \"glue\", expected \"signorini\", \"quasi_shock\", "
      "\"cohesive\" with the pull that it bears, or \"penalty\" with its stiffness");
}

}  // namespace lua_law_test
