// What a law in Lua sees of a contact only if its manifest names it in `reads`.

#include <catch2/catch.hpp>

#include "plugin/contact_law.h"
#include "plugin/registry.h"
#include "unit/lua_fixture.h"

using namespace flyrock;

namespace lua_contact_test {

namespace {

/// The coefficient that a friction law with this body answers to a contact; its message if it fails.
std::string answer(const std::string& reads, const std::string& body, ContactState contact = {}) {
  LuaFixture lua;
  lua.write("f.lua",
            "local fr = require 'flyrock'\nreturn fr.plugin { kind = 'friction', name = 'f', doc = 'd', " +
                reads + "\n  friction = function(p, contact)\n    " + body + "\n  end }\n");
  if (const std::string faults = lua.load("f.lua"); !faults.empty()) return faults;
  double memory[1] = {};
  contact.history = memory;
  PluginUse use;
  use.plugin = lua.session.registry().find(PluginKind::friction, "f");
  try {
    return std::to_string(make_instance<FrictionLaw>(use, 2)->friction({}, contact).mu_s).substr(0, 4);
  } catch (const PluginError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("a law in Lua reads force, slip, shape and partner, and nil where there is none") {
  ContactState contact;
  contact.normal_force = 50;
  contact.slip_length = 0.25;
  contact.shape_corners = 6;
  contact.partner_moves = true;
  contact.partner_mass = 3;
  CHECK(answer("reads = { 'contact.normal_force' },", "return contact.normal_force / 100", contact) ==
        "0.50");
  CHECK(answer("reads = { 'contact.slip_length' },", "return contact.slip_length", contact) == "0.25");
  CHECK(answer("reads = { 'contact.shape' }, history = { 'n' },",
               "contact.history.n = 1 return contact.shape.type == 'disk' and contact.shape.corners or 0",
               contact) == "6.00");
  CHECK(answer("reads = { 'contact.partner', 'contact.shape' },",
               "return contact.partner.moves and contact.partner.mass or 0", contact) == "3.00");
  CHECK(answer("reads = { 'contact.normal_force' },", "return contact.normal_force and 1 or 2") == "2.00");
  CHECK(answer("reads = { 'contact.shape' },", "return contact.shape.flatness and 1 or 2") == "2.00");
  CHECK(answer("reads = { 'contact.partner' },", "return contact.partner.moves and 1 or 2") == "2.00");
}

TEST_CASE("a law in Lua that reads what its manifest does not name is told to name it") {
  CHECK(answer("", "return contact.normal_force") ==
        "plugin f, f.lua:4: `contact.normal_force` is not declared: add \"contact.normal_force\" to `reads` "
        "of the "
        "manifest");
  CHECK(
      answer("reads = { 'contact.points' },", "return contact.shape.corners") ==
      "plugin f, f.lua:4: `contact.shape` is not declared: add \"contact.shape\" to `reads` of the manifest");
  CHECK(answer("reads = { 'contact.shape' },", "return contact.shape.edges")
            .find("`contact.shape` has no field `edges`") != std::string::npos);
  CHECK(answer("reads = { 'contact.shape' },", "contact.shape.corners = 1 return 0")
            .find("`contact.shape` cannot be changed") != std::string::npos);
  CHECK(answer("reads = { 'contact.shapes' },", "return 0").find("unknown field `contact.shapes`") !=
        std::string::npos);
}

}  // namespace lua_contact_test
