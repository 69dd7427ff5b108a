#include "host/session.h"

#include <fmt/format.h>

#include <filesystem>
#include <lua.hpp>

#include "document/odd_characters.h"
#include "host/adapters.h"
#include "host/manifest.h"
#include "host/read_value.h"
#include "host/share.h"
#include "host/table_reader.h"
#include "host/wording.h"
#include "plugin/module_loader.h"
#include "sandbox/read_only.h"
#include "sandbox/sandbox.h"
#include "sandbox/state.h"
#include "units/units.h"

namespace flyrock {

namespace fs = std::filesystem;

namespace {

/// The path after resolving symbolic links; the path itself where that fails (links in a circle, a name that
/// is too long), because reading it fails then too.
fs::path resolved(const fs::path& path) {
  std::error_code failed;
  // Absolute first, because a relative path that does not exist would not be resolved at all.
  const fs::path whole = fs::absolute(path), real = fs::weakly_canonical(whole, failed);
  return failed ? whole : real;
}

/// Whether a path is in a folder, also after resolving symbolic links.
bool is_within(const fs::path& path, const fs::path& folder) {
  const fs::path real = resolved(path), around = resolved(folder.empty() ? "." : folder);
  return std::mismatch(around.begin(), around.end(), real.begin(), real.end()).first == around.end();
}

}  // namespace

LuaSession::LuaSession(const std::string& share) : state_(std::make_shared<LuaState>(wording)) {
  if (!fs::is_directory(share))
    throw std::runtime_error(
        fmt::format("the folder {} is missing: flyrock is not installed as a whole", share));
  if (const std::string error = load_module(module_folder() + "/flyrock_plugins.so", natives_);
      !error.empty())
    throw std::runtime_error(error);
  try {
    state_->run(Budget::load_limit, [&](lua_State* lua) { open_libraries(lua, share); });
  } catch (const LuaError& error) {
    throw std::runtime_error(error.what());
  }
  const fs::path folder = fs::path(share) / "plugins";
  if (!fs::is_directory(folder))
    throw std::runtime_error(
        fmt::format("flyrock's plugins are missing: no folder {}; reinstall, or name the folder that "
                    "has them in FLYROCK_DATA",
                    folder.string()));
  std::vector<fs::path> manifests;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().filename() == "plugin.lua") manifests.push_back(entry.path());
  std::sort(manifests.begin(), manifests.end());
  Diagnostics diagnostics;
  builtin_ = true;
  for (const fs::path& manifest : manifests)
    load_plugin(manifest.string(), manifest.lexically_relative(share).string(), {}, diagnostics);
  builtin_ = false;
  if (diagnostics.has_errors())
    throw std::runtime_error("flyrock's own plugins are broken:\n" + diagnostics.to_text());
}

void LuaSession::open_libraries(lua_State* lua, const std::string& share) {
  const auto add_function = [&](const char* name, lua_CFunction function) {
    lua_pushlightuserdata(lua, this);
    lua_pushcclosure(lua, function, 1);
    lua_setfield(lua, -2, name);
  };
  push_globals(lua);
  add_function("require", guarded<require>);
  globals_ = luaL_ref(lua, LUA_REGISTRYINDEX);

  const std::string path = share + "/lua/flyrock/init.lua";
  std::string fault;
  const LuaFile* module = files_.read(path, "flyrock/init.lua", fault);
  if (!module) throw std::runtime_error(fmt::format("flyrock's Lua module is missing: cannot read {}", path));
  lua_createtable(lua, 0, 3);
  add_function("scenario", guarded<scenario>);
  add_function("plugin", guarded<plugin>);
  add_function("argument", guarded<argument>);
  add_function("over_time", guarded<over_time>);
  run_file(lua, *module);
  lua_createtable(lua, 0, 0);
  make_strict(lua, -2, "fr");
  make_read_only(lua, "fr");
  module_ = luaL_ref(lua, LUA_REGISTRYINDEX);
}

template <class Use>
void LuaSession::load(const LuaFile& file, Diagnostics& diagnostics, Use&& use) {
  diagnostics_ = &diagnostics;
  main_ = &file;
  registered_ = 0;
  try {
    state_->run(Budget::load_limit, [&](lua_State* lua) {
      lua_pushnil(lua);  // the file gets no argument
      run_file(lua, file);
      use(lua);
    });
  } catch (const LuaError& error) {
    // The text may claim any place, for example by error(text, 0). The place of the code that raised it is
    // known.
    auto message = files_.split_message(error.what());
    if (!message) message = files_.split_message(error.raised_at + error.what());
    if (!message) message.emplace(Location{file.source, 1, 1}, error.what());
    const bool is_odd_token = message->second.find("near '<\\") != std::string::npos;  // near '<\194>'
    diagnostics.error(message->first, "",
                      message->second + (is_odd_token ? hint_of_line(message->first) : std::string()));
  }
  diagnostics_ = nullptr;
  main_ = nullptr;
}

void LuaSession::run_file(lua_State* lua, const LuaFile& file) {
  const int argument = lua_gettop(lua);
  lua_rawgeti(lua, LUA_REGISTRYINDEX, globals_);
  push_environment(lua, -1);
  const int environment = lua_gettop(lua);
  const std::string_view code = file.code();
  if (luaL_loadbufferx(lua, code.data(), code.size(), ("@" + file.source->name).c_str(), "t") != LUA_OK)
    lua_error(lua);
  lua_pushvalue(lua, environment);
  lua_setupvalue(lua, -2, 1);  // the first upvalue of a chunk is its _ENV
  lua_pushvalue(lua, argument);
  lua_call(lua, 1, 1);
  freeze_environment(lua, environment);
  lua_replace(lua, argument);
  lua_settop(lua, argument);
}

void LuaSession::load_plugin(const std::string& path, const std::string& shown, const Location& at,
                             Diagnostics& diagnostics) {
  if (fs::is_directory(path))
    return load_plugin((fs::path(path) / "plugin.lua").string(), (fs::path(shown) / "plugin.lua").string(),
                       at, diagnostics);
  std::string fault;
  const LuaFile* file = files_.read(path, shown, fault);
  if (!file)
    return diagnostics.error(at, "plugins",
                             fault + ", expected a Lua file, or a folder with plugin.lua in it");
  sources_.push_back({shown, file->text});
  const std::size_t errors_before = diagnostics.errors_given();
  load(*file, diagnostics, [](lua_State*) {});
  if (registered_ == 0 && diagnostics.errors_given() == errors_before)
    diagnostics.error({file->source, 1, 1}, "", "registers no plugin, expected `return fr.plugin { ... }`");
}

std::optional<Value> LuaSession::read_scenario(const std::string& path, const std::string& shown,
                                               Diagnostics& diagnostics) {
  std::string fault;
  const LuaFile* file = files_.read(path, shown, fault);
  if (!file) {
    diagnostics.error({std::make_shared<Source>(Source{shown, {}}), 0, 0}, "",
                      fault + ", expected a Lua file");
    return std::nullopt;
  }
  std::optional<Value> value;
  scenario_folder_ = fs::path(shown).parent_path().string();
  load(*file, diagnostics, [&](lua_State* lua) {
    for (const Marked& marked : scenarios_)
      if (marked.table == lua_topointer(lua, -1)) {
        loads_.sample(lua);
        value = read_value(lua, -1, marked.places, diagnostics, [](const std::string&) { return false; });
        return;
      }
    diagnostics.error({file->source, 1, 1}, "",
                      fmt::format("returns {}, expected `return fr.scenario {{ ... }}` at its end",
                                  lua_isnil(lua, -1) ? "nothing" : "something else"));
  });
  if (registered_ > 0) sources_.push_back({name_in_hash(shown), file->text});
  scenario_folder_.reset();
  scenarios_.clear();
  loads_.clear();
  if (diagnostics.has_errors()) return std::nullopt;
  return value;
}

std::string LuaSession::name_in_hash(const std::string& shown) const {
  return scenario_folder_ ? fs::path(shown).lexically_relative(*scenario_folder_).string() : shown;
}

LuaSession& LuaSession::self(lua_State* lua) {
  return *static_cast<LuaSession*>(lua_touserdata(lua, lua_upvalueindex(1)));
}

std::pair<const LuaFile*, FieldPlaces> LuaSession::calling(lua_State* lua, const char* function) const {
  lua_Debug frame;
  const bool called = lua_getstack(lua, 1, &frame) != 0 &&
                      lua_getinfo(lua, "Sl", &frame) != 0;  // false if a coroutine calls it directly
  const LuaFile* file = main_ && called ? files_.of_chunk(frame.source) : nullptr;
  if (!file)
    throw std::runtime_error(
        fmt::format("call fr.{} at the top level of the file, not in a function", function));
  charge(lua, 10'000 + 5.0 * static_cast<double>(file->text.size()));  // for scanning the source
  return {file, FieldPlaces(file->source, function, frame.currentline)};
}

int LuaSession::scenario(lua_State* lua) {
  if (!lua_istable(lua, 1)) raise(lua, "fr.scenario takes a table: fr.scenario { ... }");
  LuaSession& session = self(lua);
  session.scenarios_.push_back({lua_topointer(lua, 1), session.calling(lua, "scenario").second});
  lua_settop(lua, 1);
  lua_pushvalue(lua, 1);
  luaL_ref(lua, LUA_REGISTRYINDEX);  // kept, so that no other table gets its address
  return 1;
}

int LuaSession::plugin(lua_State* lua) {
  if (!lua_istable(lua, 1))
    raise(lua, "fr.plugin takes a table: fr.plugin { kind = ..., name = ..., doc = ..., ... }");
  lua_settop(lua, 1);
  self(lua).register_plugin(lua);
  lua_createtable(lua, 0, 2);  // the functions that a script may use
  for (const char* field : {"kind", "name"}) {
    lua_getfield(lua, 1, field);
    lua_setfield(lua, -2, field);
  }
  make_read_only(lua, "plugin");
  return 1;
}

int LuaSession::argument(lua_State* lua) {
  LuaSession& session = self(lua);
  // The hash of a scenario knows no number that a law asks for in a call.
  if (!session.main_)
    throw std::runtime_error("call fr.argument at the top level of the file, not in a function");
  session.arguments_.answer(lua);
  return 1;
}

int LuaSession::over_time(lua_State* lua) {
  LuaSession& session = self(lua);
  if (!session.scenario_folder_)
    throw std::runtime_error("fr.over_time is for Lua scenarios: it stands at the top level of one");
  session.loads_.answer(lua);
  return 1;
}

void LuaSession::register_plugin(lua_State* lua) {
  const auto [file, places] = calling(lua, "plugin");
  charge(lua, 90'000);  // because `flyrock check` calls each plugin thousands of times
  ++registered_;
  std::map<std::string, int> functions;
  const auto value = read_value(lua, 1, places, *diagnostics_, [&](const std::string& path) {
    if (path.find_first_of(".[") != path.npos) return false;
    lua_pushvalue(lua, -1);
    functions[path] = luaL_ref(lua, LUA_REGISTRYINDEX);
    return true;
  });
  if (!value) return;
  std::map<std::string, Location> function_places;
  for (const auto& [name, reference] : functions) function_places[name] = places.key(name);
  auto spec = read_manifest(*value, function_places, *diagnostics_);
  if (!spec) return;
  spec->file = file->source->name;
  std::optional<Factory> make;
  if (!spec->native.empty())
    make = native_factory(*spec, *file, places.value("native"));
  else
    make = lua_factory(state_, lua, *spec, functions.begin()->second);
  if (!make) return;
  if (const std::string error = registry_.add({*spec, std::move(*make)}); !error.empty())
    diagnostics_->error(places.value("name"), "name", error);
}

std::optional<Factory> LuaSession::native_factory(const PluginSpec& spec, const LuaFile& file,
                                                  const Location& at) {
  const auto refuse = [&](const std::string& text) {
    diagnostics_->error(at, "native", text);
    return std::nullopt;
  };
  if (refuses_natives_ && !builtin_)
    return refuse("a plugin in native code, which --confined refuses: write it in Lua");
  FactoryTable own;
  std::string object = "flyrock_plugins.so";
  if (!builtin_) {
    object = spec.native + ".so";
    const fs::path named = fs::path(file.folder) / object;
    if (!is_within(named, file.folder))
      return refuse(fmt::format("`{}` leads out of the folder of {}", object, file.source->name));
    const std::string path = resolved(named).string();  // loads exactly the file that was checked
    const auto bytes = read_bytes(path);
    if (!bytes) return refuse(fmt::format("no shared object `{}` beside the manifest", object));
    if (const std::string error = load_module_guarded(path, own); !error.empty()) return refuse(error);
    sources_.push_back({name_in_hash((fs::path(file.source->name).parent_path() / object).string()), *bytes});
  }
  const FactoryTable& table = builtin_ ? natives_ : own;
  if (const auto found = table.find({spec.kind, spec.native}); found != table.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& [key, factory] : table)
    if (key.first == spec.kind) known.push_back(key.second);
  return refuse(fmt::format("{} has no {} `{}`{}", object, name_of(spec.kind), spec.native,
                            did_you_mean(spec.native, known)));
}

int LuaSession::require(lua_State* lua) {
  const std::string name = luaL_checkstring(lua, 1);
  LuaSession& session = self(lua);
  if (name == "flyrock")
    lua_rawgeti(lua, LUA_REGISTRYINDEX, session.module_);
  else
    session.require_file(lua, name);
  return 1;
}

void LuaSession::require_file(lua_State* lua, const std::string& name) {
  if (!main_) throw std::runtime_error("call require at the top level of the file, not in a function");
  constexpr const char* allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.";
  if (name.find_first_not_of(allowed) != name.npos || name.find("..") != name.npos || name.starts_with("."))
    throw std::runtime_error(fmt::format(
        "require: `{}` is not a module, expected letters, digits and _, with dots for folders", name));
  std::string relative = name;
  std::replace(relative.begin(), relative.end(), '.', '/');
  const std::string path = (fs::path(main_->folder) / (relative + ".lua")).string();
  if (const auto found = required_.find(path); found != required_.end()) {
    if (found->second == 0) throw std::runtime_error(fmt::format("require: `{}` requires itself", name));
    lua_rawgeti(lua, LUA_REGISTRYINDEX, found->second);
    return;
  }
  if (!is_within(path, main_->folder))
    throw std::runtime_error(
        fmt::format("require: `{}` leads out of the folder of {}", name, main_->source->name));
  const std::string shown = (fs::path(main_->source->name).parent_path() / (relative + ".lua")).string();
  std::string fault;
  const LuaFile* file = files_.read(path, shown, fault);
  if (!file)
    throw std::runtime_error(
        fmt::format("require: {}, expected a module in the folder of the file{}", fault,
                    nearest_name(name, {"flyrock"}).empty() ? "" : "; did you mean `flyrock`?"));
  sources_.push_back({name_in_hash(shown), file->text});
  struct Loading {  // forgets the file if loading fails, because a Lua error unwinds this frame
    std::map<std::string, int>& required;
    const std::string& path;
    int reference = 0;
    Loading(std::map<std::string, int>& all, const std::string& one) : required(all), path(one) {
      required[path] = 0;
    }
    ~Loading() {
      if (reference == 0)
        required.erase(path);
      else
        required[path] = reference;
    }
  } loading(required_, path);
  lua_pushstring(lua, name.c_str());
  run_file(lua, *file);
  lua_pushvalue(lua, -1);
  loading.reference = luaL_ref(lua, LUA_REGISTRYINDEX);
}

void LuaSession::collect_prints() { state_->collect_prints(); }
PrintLog LuaSession::take_prints() { return state_->take_prints(); }

}  // namespace flyrock
