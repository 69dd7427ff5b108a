#pragma once
// Calls a plugin's Lua function with its parameters.

#include <memory>
#include <string>
#include <vector>

#include "host/view.h"
#include "plugin/params.h"
#include "sandbox/freeze.h"
#include "sandbox/state.h"

namespace flyrock {

/// A pure Lua plugin, made from its manifest.
struct LuaPlugin {
  std::shared_ptr<LuaState> state;
  PluginSpec spec;
  int function = 0;              ///< reference of the entry function
  std::string origin;            ///< the place where the function is defined: "my_law, my_law.lua:14"
  std::string entry;             ///< name of the entry function: "impact"
  bool only_parameters = false;  ///< the function takes only `p`
};

/// The table `p`: one for each use of a plugin, read-only for Lua. A value is written again when its draw has
/// changed.
class LuaParameters {
 public:
  /// Reads all parameters of the manifest from `params`.
  LuaParameters(lua_State* lua, const PluginSpec& spec, Params& params);

  /// Writes the draws that differ from those of the last call, then pushes p.
  void push(lua_State* lua, Values values);
  std::vector<int> references() const;

 private:
  struct Field {
    std::string name;
    ParamType type;
    int slot;
    int component = 0;  // of a vector, from 1
    int inner = 0;      // reference of the table of its vector or group
  };
  void set(lua_State* lua, const Field& field, double value);

  std::vector<Field> fields_;
  std::vector<double> last_;  // values written last
  std::vector<int> vectors_;  // references of vectors and groups, like the two members below
  int table_ = 0, view_ = 0;
};

/// An entry function, ready for calls. Belongs to one thread.
class LuaCall {
 public:
  /// `make_views` returns the arguments of the function after p, in order. `instructions` is the limit of one
  /// call.
  LuaCall(std::shared_ptr<const LuaPlugin> plugin, Params& params,
          std::vector<View> (*make_views)(lua_State*, const PluginSpec&), double instructions);
  ~LuaCall();
  LuaCall(const LuaCall&) = delete;
  LuaCall& operator=(const LuaCall&) = delete;

  const LuaPlugin& plugin() const { return *plugin_; }

  /// Calls the function with p and views of `objects`. `read` takes the `results` results from the top of the
  /// stack. Throws PluginError, also for a LuaError in `read`.
  template <class Read>
  void operator()(Values values, std::initializer_list<const void*> objects, int results, Read&& read) const {
    try {
      plugin_->state->run(instructions_, [&](lua_State* lua) {
        call(lua, values, objects, results);
        read(lua);
      });
    } catch (const LuaError& error) {
      end_failed(error);
    }
  }

  /// Throws PluginError "plugin my_law, my_law.lua:14: impact() <text>".
  [[noreturn]] void fail(const std::string& text) const;
  /// The number at `index`; `name` is its name in messages.
  double number(lua_State* lua, int index, const char* name) const;

 private:
  void call(lua_State* lua, Values values, std::initializer_list<const void*> objects, int results) const;
  [[noreturn]] void end_failed(const LuaError& error) const;
  [[noreturn]] void rethrow(const LuaError& error) const;

  std::shared_ptr<const LuaPlugin> plugin_;
  double instructions_;
  int dimension_;                                      ///< of the scenario: the last argument of build()
  mutable std::unique_ptr<LuaParameters> parameters_;  // mutable: state of the interpreter, not of the law
  mutable std::vector<View> views_;
  std::unique_ptr<OuterLocals> outer_;
};

}  // namespace flyrock
