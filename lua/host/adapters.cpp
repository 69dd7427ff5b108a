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
  switch (spec.kind) {
    case PluginKind::shape:
      return shape_factory(plugin);
    case PluginKind::population:
      return population_factory(plugin);
    case PluginKind::restitution:
      return restitution_factory(plugin);
    case PluginKind::friction:
      return friction_factory(plugin);
    case PluginKind::rolling:
      return rolling_factory(plugin);
    case PluginKind::unilateral:
      return unilateral_factory(plugin);
    case PluginKind::velocity:
      return velocity_factory(plugin);
    case PluginKind::terrain:
      return terrain_factory(plugin);
  }
  throw std::logic_error("a plugin kind without an adapter");
}

}  // namespace flyrock
