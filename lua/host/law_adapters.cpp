// The four kinds of contact laws.

#include <fmt/format.h>

#include <cstring>
#include <lua.hpp>

#include "host/adapter_kinds.h"
#include "host/views.h"

namespace flyrock {

namespace {

std::vector<View> contact_only(lua_State* lua, const PluginSpec&) { return {contact_view(lua)}; }

/// What all laws share; `Kind` is the interface of one.
template <class Kind>
class LuaLaw : public Kind {
 public:
  LuaLaw(std::shared_ptr<const LuaPlugin> plugin, Params& params)
      : call_(std::move(plugin), params, contact_only) {}
  bool constant() const override { return call_.plugin().only_parameters; }
  std::string origin() const override { return call_.plugin().origin; }

 protected:
  LuaCall call_;
};

class LuaRestitution : public LuaLaw<RestitutionLaw> {
 public:
  using LuaLaw::LuaLaw;
  Restitution impact(Values values, const ContactState& contact) const override {
    Restitution answer;
    call_(values, {&contact}, 3, [&](lua_State* lua) {
      answer.e_n = call_.number(lua, 1, "e_n");
      if (!lua_isnil(lua, 2)) answer.e_t = call_.number(lua, 2, "e_t");
      if (!lua_isnil(lua, 3)) call_.fail("returned a third value, expected e_n, e_t");
    });
    return answer;
  }
};

class LuaFriction : public LuaLaw<FrictionLaw> {
 public:
  using LuaLaw::LuaLaw;
  Friction friction(Values values, const ContactState& contact) const override {
    Friction answer;
    call_(values, {&contact}, 3, [&](lua_State* lua) {
      answer.mu_s = call_.number(lua, 1, "mu_s");
      answer.mu_d = lua_isnil(lua, 2) ? answer.mu_s : call_.number(lua, 2, "mu_d");
      if (!lua_isnil(lua, 3))
        call_.fail("returned a third value, expected mu_s, mu_d (cohesion is not in this version)");
    });
    return answer;
  }
};

class LuaRolling : public LuaLaw<RollingLaw> {
 public:
  using LuaLaw::LuaLaw;
  double rolling(Values values, const ContactState& contact) const override {
    double mu_r = 0;
    call_(values, {&contact}, 2, [&](lua_State* lua) {
      mu_r = call_.number(lua, 1, "mu_r");
      if (!lua_isnil(lua, 2))
        call_.fail("returned a second value, expected mu_r (spinning is not in this version)");
    });
    return mu_r;
  }
};

class LuaUnilateral : public LuaLaw<UnilateralLaw> {
 public:
  using LuaLaw::LuaLaw;
  NormalCondition condition(Values values, const ContactState& contact) const override {
    call_(values, {&contact}, 1, [&](lua_State* lua) {
      const char* name = lua_type(lua, 1) == LUA_TSTRING ? lua_tostring(lua, 1) : nullptr;
      if (!name || std::strcmp(name, "signorini") != 0)
        call_.fail(fmt::format("returned {}, expected \"signorini\"",
                               name ? fmt::format("\"{}\"", name) : luaL_typename(lua, 1)));
    });
    return NormalCondition::signorini;
  }
};

}  // namespace

Factory restitution_factory(std::shared_ptr<const LuaPlugin> plugin) {
  return adapter_factory<RestitutionLaw, LuaRestitution>(std::move(plugin));
}
Factory friction_factory(std::shared_ptr<const LuaPlugin> plugin) {
  return adapter_factory<FrictionLaw, LuaFriction>(std::move(plugin));
}
Factory rolling_factory(std::shared_ptr<const LuaPlugin> plugin) {
  return adapter_factory<RollingLaw, LuaRolling>(std::move(plugin));
}
Factory unilateral_factory(std::shared_ptr<const LuaPlugin> plugin) {
  return adapter_factory<UnilateralLaw, LuaUnilateral>(std::move(plugin));
}

}  // namespace flyrock
