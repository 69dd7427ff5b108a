#pragma once
// The factories of the kinds of pure Lua plugins.

#include <memory>

#include "host/lua_call.h"
#include "plugin/registry.h"

namespace flyrock {

Factory restitution_factory(std::shared_ptr<const LuaPlugin> plugin);
Factory friction_factory(std::shared_ptr<const LuaPlugin> plugin);
Factory rolling_factory(std::shared_ptr<const LuaPlugin> plugin);
Factory unilateral_factory(std::shared_ptr<const LuaPlugin> plugin);
Factory shape_factory(std::shared_ptr<const LuaPlugin> plugin);
Factory terrain_factory(std::shared_ptr<const LuaPlugin> plugin);
Factory population_factory(std::shared_ptr<const LuaPlugin> plugin);
Factory velocity_factory(std::shared_ptr<const LuaPlugin> plugin);

}  // namespace flyrock
