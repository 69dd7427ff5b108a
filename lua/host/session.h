#pragma once
// The plugins and scenarios of a run, read in a Lua state.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "document/diagnostics.h"
#include "host/lua_arguments.h"
#include "plugin/registry.h"
#include "sandbox/print_log.h"

namespace flyrock {

/// A Lua state with its registered plugins. Each worker thread has its own. The products of its Lua plugins
/// belong to the same thread and keep the state alive.
class LuaSession {
 public:
  /// Loads every manifest under <share>/plugins, sorted by path, native plugins through
  /// <share>/flyrock_plugins.so. If the installation is broken, throws std::runtime_error with the name of
  /// the file.
  explicit LuaSession(const std::string& share);
  ~LuaSession();

  /// What fr.argument of the files that are loaded from here on answers, and what they asked for.
  LuaArguments& arguments();
  const LuaArguments& arguments() const;

  /// Loads a plugin file, or a folder with plugin.lua in it. A plugin with `native = "NAME"` has NAME.so in
  /// the folder of its manifest. `path` is opened, `shown` is for messages, `at` is where the scenario names
  /// it.
  void load_plugin(const std::string& path, const std::string& shown, const Location& at,
                   Diagnostics& diagnostics);

  /// Runs a Lua scenario and returns its result as a tree of located values. Calls of fr.plugin in it
  /// register plugins.
  std::optional<Value> read_scenario(const std::string& path, const std::string& shown,
                                     Diagnostics& diagnostics);

  const Registry& registry() const;

  /// From here on `print` of Lua code writes nothing to stderr, and its lines wait to be taken.
  void collect_prints();
  PrintLog take_prints();

  struct SourceText {
    std::string name, text;
  };
  /// Every source file of the plugins (manifests, modules, shared objects of users), in the order of reading.
  const std::vector<SourceText>& sources() const;

 private:
  class Host;
  std::unique_ptr<Host> host_;
};

}  // namespace flyrock
