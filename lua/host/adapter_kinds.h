#pragma once
// The factories of pure Lua plugins, one for each kind.

#include <memory>

#include "host/lua_call.h"
#include "plugin/registry.h"

namespace flyrock {

/// A factory whose products are Adapters: they let the plugin act as the interface Kind.
template <class Kind, class Adapter>
Factory adapter_factory(std::shared_ptr<const LuaPlugin> plugin) {
  return FactoryOf<Kind>([plugin = std::move(plugin)](Params& params) -> std::unique_ptr<Kind> {
    return std::make_unique<Adapter>(plugin, params);
  });
}

Factory restitution_factory(std::shared_ptr<const LuaPlugin> plugin);
Factory friction_factory(std::shared_ptr<const LuaPlugin> plugin);
Factory rolling_factory(std::shared_ptr<const LuaPlugin> plugin);
Factory unilateral_factory(std::shared_ptr<const LuaPlugin> plugin);
Factory shape_factory(std::shared_ptr<const LuaPlugin> plugin);
Factory terrain_factory(std::shared_ptr<const LuaPlugin> plugin);
Factory population_factory(std::shared_ptr<const LuaPlugin> plugin);
Factory velocity_factory(std::shared_ptr<const LuaPlugin> plugin);

}  // namespace flyrock
