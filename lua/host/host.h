#pragma once
// The implementation of LuaSession: the state with its libraries, the functions fr.scenario, fr.plugin,
// fr.argument and require, and the files that are being loaded.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/locate.h"
#include "host/lua_arguments.h"
#include "host/session.h"
#include "host/source_files.h"
#include "plugin/module.h"
#include "sandbox/state.h"

namespace flyrock {

class LuaSession::Host {
 public:
  explicit Host(const std::string& share);

  void load_builtin(const std::string& path, const std::string& shown, Diagnostics& diagnostics);
  void load_plugin(const std::string& path, const std::string& shown, const Location& at,
                   Diagnostics& diagnostics);
  std::optional<Value> read_scenario(const std::string& path, const std::string& shown,
                                     Diagnostics& diagnostics);
  LuaState& state() { return *state_; }
  LuaArguments& arguments() { return arguments_; }
  const Registry& registry() const { return registry_; }
  const std::vector<SourceText>& sources() const { return sources_; }

 private:
  /// A table given to fr.scenario, and the place of the call.
  struct Marked {
    const void* table;
    FieldPlaces places;
  };

  // The functions that Lua sees. Upvalue 1 is the host.
  static Host& self(lua_State* lua);
  static int scenario(lua_State* lua);
  static int plugin(lua_State* lua);
  static int argument(lua_State* lua);
  static int require(lua_State* lua);

  void open_libraries(lua_State* lua, const std::string& share);
  /// Loads a file at the top level. `use` finds its result at the top of the stack.
  template <class Use>
  void load(const LuaFile& file, Diagnostics& diagnostics, Use&& use);
  /// Runs a file in its own environment; its result stays on the stack.
  void run_file(lua_State* lua, const LuaFile& file);
  void require_file(lua_State* lua, const std::string& name);
  /// The file and the field places of the running call of fr.`function`.
  std::pair<const LuaFile*, FieldPlaces> calling(lua_State* lua, const char* function) const;
  void register_plugin(lua_State* lua);
  /// The name of a source for the hash of a scenario: of a Lua scenario and what is beside it, from its
  /// folder, because the same scenario may be named by another path.
  std::string name_in_hash(const std::string& shown) const;
  /// The factory with the name `native`. Reports an error if there is none.
  std::optional<Factory> native_factory(const PluginSpec& spec, const LuaFile& file, const Location& at);

  std::shared_ptr<LuaState> state_;
  int globals_ = 0, module_ = 0;  // references: the table of globals, the module flyrock
  Registry registry_;
  FactoryTable natives_;  // of flyrock_plugins.so
  SourceFiles files_;
  std::vector<SourceText> sources_;
  LuaArguments arguments_;
  std::map<std::string, int> required_;  // by path: reference of the result; 0 while it is being loaded
  std::vector<Marked> scenarios_;

  // Set while a file is loaded:
  Diagnostics* diagnostics_ = nullptr;
  const LuaFile* main_ = nullptr;
  std::optional<std::string> scenario_folder_;  // while a scenario is loaded, as shown
  bool builtin_ = false;
  int registered_ = 0;
};

}  // namespace flyrock
