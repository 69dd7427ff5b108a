#pragma once
// The factories of pure Lua plugins.

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

Factory law_factory(std::shared_ptr<const LuaPlugin> plugin);    ///< of the four kinds of contact laws
Factory model_factory(std::shared_ptr<const LuaPlugin> plugin);  ///< of the other kinds

}  // namespace flyrock
