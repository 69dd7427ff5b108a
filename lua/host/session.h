#pragma once
// The plugins and scenarios of a run, read in a Lua state.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "document/diagnostics.h"
#include "document/value.h"
#include "host/load_functions.h"
#include "host/locate.h"
#include "host/lua_arguments.h"
#include "host/source_files.h"
#include "plugin/registry.h"
#include "sandbox/print_log.h"

namespace flyrock {

class LuaState;

/// A Lua state with its registered plugins. Each worker thread has its own. The products of its Lua plugins
/// belong to the same thread and keep the state alive.
class LuaSession {
 public:
  /// Loads every manifest under <share>/plugins, sorted by path, native plugins through
  /// <share>/flyrock_plugins.so. If the installation is broken, throws std::runtime_error with the name of
  /// the file.
  explicit LuaSession(const std::string& share);
  LuaSession(const LuaSession&) = delete;
  LuaSession& operator=(const LuaSession&) = delete;

  /// What fr.argument of the files that are loaded from here on answers, and what they asked for.
  LuaArguments& arguments() { return arguments_; }
  const LuaArguments& arguments() const { return arguments_; }

  /// Loads a plugin file, or a folder with plugin.lua in it. A plugin with `native = "NAME"` has NAME.so in
  /// the folder of its manifest. `path` is opened, `shown` is for messages, `at` is where the scenario names
  /// it.
  void load_plugin(const std::string& path, const std::string& shown, const Location& at,
                   Diagnostics& diagnostics);

  /// Runs a Lua scenario and returns its result as a tree of located values. Calls of fr.plugin in it
  /// register plugins.
  std::optional<Value> read_scenario(const std::string& path, const std::string& shown,
                                     Diagnostics& diagnostics);

  const Registry& registry() const { return registry_; }

  /// From here on a plugin file with `native` is an error.
  void refuse_natives() { refuses_natives_ = true; }

  /// From here on `print` of Lua code writes nothing to stderr, and its lines wait to be taken.
  void collect_prints();
  PrintLog take_prints();

  struct SourceText {
    std::string name, text;
  };
  /// Every source file of the plugins (manifests, modules, shared objects of users), in the order of reading.
  const std::vector<SourceText>& sources() const { return sources_; }

 private:
  /// A table given to fr.scenario, and the place of the call.
  struct Marked {
    const void* table;
    FieldPlaces places;
  };

  // The functions that Lua sees. Upvalue 1 is the session.
  static LuaSession& self(lua_State* lua);
  static int scenario(lua_State* lua);
  static int plugin(lua_State* lua);
  static int argument(lua_State* lua);
  static int over_time(lua_State* lua);
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
  LoadFunctions loads_;
  std::map<std::string, int> required_;  // by path: reference of the result; 0 while it is being loaded
  std::vector<Marked> scenarios_;

  // Set while a file is loaded:
  Diagnostics* diagnostics_ = nullptr;
  const LuaFile* main_ = nullptr;
  std::optional<std::string> scenario_folder_;  // while a scenario is loaded, as shown
  bool builtin_ = false;
  bool refuses_natives_ = false;
  int registered_ = 0;
};

}  // namespace flyrock
