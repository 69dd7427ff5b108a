#pragma once
// The plugins and scenarios of a run, read by a Lua state.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "document/diagnostics.h"
#include "plugin/registry.h"
#include "sandbox/print_log.h"

namespace flyrock {

/// A Lua state with the plugins registered in it; each worker thread has one. What its Lua plugins make
/// belongs to that thread too, and keeps the state alive.
class LuaSession {
 public:
  /// Loads every manifest under <share>/plugins, sorted by path, native ones through
  /// <share>/flyrock_plugins.so. Throws std::runtime_error naming the file where the installation is broken.
  explicit LuaSession(const std::string& share);
  ~LuaSession();

  /// A plugin file, or a folder with plugin.lua in it. One with `native = "NAME"` has NAME.so beside its
  /// manifest. `path` is opened, `shown` is for messages, `at` where the scenario names it.
  void load_plugin(const std::string& path, const std::string& shown, const Location& at,
                   Diagnostics& diagnostics);

  /// Runs a Lua scenario; its result as a tree of located values. Calls of fr.plugin in it register plugins.
  std::optional<Value> read_scenario(const std::string& path, const std::string& shown,
                                     Diagnostics& diagnostics);

  const Registry& registry() const;

  /// From here on `print` of Lua code writes nothing to stderr: what it says waits to be taken.
  void collect_prints();
  PrintLog take_prints();

  struct SourceText {
    std::string name, text;
  };
  /// Every file that the plugins come from (manifests, modules, shared objects of users), in the order read.
  const std::vector<SourceText>& sources() const;

 private:
  class Host;
  std::unique_ptr<Host> host_;
};

}  // namespace flyrock
