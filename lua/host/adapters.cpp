#include "host/adapters.h"

#include <fmt/format.h>

#include <lua.hpp>

#include "host/adapter_kinds.h"
#include "host/manifest.h"

namespace flyrock {

Factory lua_factory(std::shared_ptr<LuaState> state, lua_State* lua, const PluginSpec& spec, int function) {
  auto plugin = std::make_shared<LuaPlugin>();
  plugin->state = std::move(state);
  plugin->spec = spec;
  plugin->function = function;
  plugin->entry = entry_point(spec.kind);
  lua_rawgeti(lua, LUA_REGISTRYINDEX, function);
  lua_Debug info;
  lua_getinfo(lua, ">Su", &info);
  const bool in_lua = info.linedefined >= 0;  // a library function has no place
  plugin->origin = in_lua ? fmt::format("{}, {}:{}", spec.name, info.source + 1, info.linedefined)
                          : fmt::format("{}, {}", spec.name, spec.file);
  plugin->only_parameters = info.nparams <= 1 && !info.isvararg;
  return is_law(spec.kind) ? law_factory(plugin) : model_factory(plugin);
}

}  // namespace flyrock
