#pragma once
// Adapts pure Lua plugins to the interfaces of the engine.

#include <memory>

#include "plugin/registry.h"
#include "sandbox/state.h"

namespace flyrock {

/// The factory of a plugin. `function` is the reference of its entry function. Its products share the state
/// and belong to the state's thread. Call it within a run of the state.
Factory lua_factory(std::shared_ptr<LuaState> state, lua_State* lua, const PluginSpec& spec, int function);

}  // namespace flyrock
