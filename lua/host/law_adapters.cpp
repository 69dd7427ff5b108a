// The four kinds of contact laws.

#include <fmt/format.h>

#include <lua.hpp>

#include "document/printable.h"
#include "host/adapter_kinds.h"
#include "host/views.h"
#include "plugin/pivoting.h"

namespace flyrock {

namespace {

/// The common part of all laws; `Kind` is the interface of one.
template <class Kind>
class LuaLaw : public Kind {
 public:
  LuaLaw(std::shared_ptr<const LuaPlugin> plugin, Params& params)
      : call_(std::move(plugin), params, contact_views, Budget::law_limit) {}
  bool constant() const override { return call_.plugin().only_parameters; }
  std::string origin() const override { return call_.plugin().origin; }

 protected:
  LuaCall call_;
};

class LuaRestitution : public LuaLaw<RestitutionLaw> {
 public:
  LuaRestitution(std::shared_ptr<const LuaPlugin> plugin, Params& params)
      : LuaLaw(plugin, params), form_(*restitution_form(plugin->spec.form)) {}
  Restitution impact(Values values, const ContactState& contact) const override {
    Restitution answer;
    answer.form = form_;
    call_(values, {&contact}, 3, [&](lua_State* lua) {
      answer.e_n = call_.number(lua, 1, "e_n");
      if (!lua_isnil(lua, 2)) answer.e_t = call_.number(lua, 2, "e_t");
      if (!lua_isnil(lua, 3)) call_.fail("returned a third value, expected e_n, e_t");
    });
    return answer;
  }

 private:
  RestitutionForm form_;
};

class LuaFriction : public LuaLaw<FrictionLaw> {
 public:
  using LuaLaw::LuaLaw;
  Friction friction(Values values, const ContactState& contact) const override {
    Friction answer;
    call_(values, {&contact}, 5, [&](lua_State* lua) {
      answer.mu_s = call_.number(lua, 1, "mu_s");
      answer.mu_d = lua_isnil(lua, 2) ? answer.mu_s : call_.number(lua, 2, "mu_d");
      if (!lua_isnil(lua, 3)) answer.c_n = call_.number(lua, 3, "c_n");
      if (!lua_isnil(lua, 4)) answer.c_t = call_.number(lua, 4, "c_t");
      if (!lua_isnil(lua, 5)) call_.fail("returned a fifth value, expected mu_s, mu_d, c_n, c_t");
    });
    return answer;
  }
};

class LuaRolling : public LuaLaw<RollingLaw> {
 public:
  using LuaLaw::LuaLaw;
  Rolling rolling(Values values, const ContactState& contact) const override {
    Rolling answer;
    call_(values, {&contact}, 3, [&](lua_State* lua) {
      answer.mu_r = call_.number(lua, 1, "mu_r");
      answer.mu_spin = lua_isnil(lua, 2) ? usual_mu_spin(answer.mu_r) : call_.number(lua, 2, "mu_spin");
      if (!lua_isnil(lua, 3)) call_.fail("returned a third value, expected mu_r, mu_spin");
    });
    return answer;
  }
};

class LuaUnilateral : public LuaLaw<UnilateralLaw> {
 public:
  using LuaLaw::LuaLaw;
  Unilateral condition(Values values, const ContactState& contact) const override {
    Unilateral answer;
    call_(values, {&contact}, 5, [&](lua_State* lua) {
      const char* name = lua_type(lua, 1) == LUA_TSTRING ? lua_tostring(lua, 1) : nullptr;
      const auto condition = normal_condition(name ? name : "");
      if (!condition)
        call_.fail(
            fmt::format("returned {}, expected \"signorini\", \"quasi_shock\", \"cohesive\" with the pull "
                        "that it bears, or \"penalty\" "
                        "with its stiffness",
                        name ? fmt::format("\"{}\"", printable(name)) : luaL_typename(lua, 1)));
      answer.condition = *condition;
      if (*condition == NormalCondition::penalty)
        read_spring(lua, answer.spring);
      else if (*condition == NormalCondition::cohesive)
        answer.pull = call_.number(lua, 2, "the pull");
      else if (!lua_isnil(lua, 2))
        call_.fail(fmt::format("returned a second value with \"{}\", which has none", name));
    });
    return answer;
  }

 private:
  /// "penalty", stiffness, damping, exponent, tangential stiffness; those after the stiffness may be nil.
  void read_spring(lua_State* lua, Spring& spring) const {
    spring.stiffness = call_.number(lua, 2, "the stiffness");
    if (!lua_isnil(lua, 3)) spring.damping = call_.number(lua, 3, "the damping");
    if (!lua_isnil(lua, 4)) spring.exponent = call_.number(lua, 4, "the exponent");
    if (!lua_isnil(lua, 5)) spring.tangential_stiffness = call_.number(lua, 5, "the tangential stiffness");
  }
};

}  // namespace

Factory law_factory(std::shared_ptr<const LuaPlugin> plugin) {
  switch (plugin->spec.kind) {
    case PluginKind::restitution:
      return adapter_factory<RestitutionLaw, LuaRestitution>(std::move(plugin));
    case PluginKind::friction:
      return adapter_factory<FrictionLaw, LuaFriction>(std::move(plugin));
    case PluginKind::rolling:
      return adapter_factory<RollingLaw, LuaRolling>(std::move(plugin));
    default:
      return adapter_factory<UnilateralLaw, LuaUnilateral>(std::move(plugin));
  }
}

}  // namespace flyrock
