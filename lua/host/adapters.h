#pragma once
// Pure Lua plugins behind the interfaces of the engine.

#include <memory>

#include "plugin/registry.h"
#include "sandbox/state.h"

namespace flyrock {

/// The factory of a plugin whose entry point is the Lua function kept under `function`. What it makes
/// shares the state and belongs to the state's thread. To be called within a run of the state.
Factory lua_factory(std::shared_ptr<LuaState> state, lua_State* lua, const PluginSpec& spec, int function);

}  // namespace flyrock
