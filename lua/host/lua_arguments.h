#pragma once
// The arguments of Lua files: `fr.argument(name, default)`, and the values that a user gives in place of the
// defaults.

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "document/diagnostics.h"

struct lua_State;

namespace flyrock {

/// An argument that a Lua file asked for, with the value that it got.
struct LuaArgument {
  std::string name;
  std::variant<std::int64_t, double, std::string> value;

  bool operator==(const LuaArgument&) const = default;
};

/// "41", "0.25", "text"
std::string text_of(const LuaArgument& argument);

class LuaArguments {
 public:
  /// Takes assignments "name=value". Reports those without a name, and names that are given twice.
  void give(const std::vector<std::string>& assignments, Diagnostics& diagnostics);

  /// fr.argument(name, default) with its two values on the stack: pushes the value that was given, or the
  /// default. A number is given for a number. Throws std::runtime_error.
  void answer(lua_State* lua);

  /// In the order in which files asked for them first.
  const std::vector<LuaArgument>& asked() const { return asked_; }
  /// Reports the names that were given and that no file asked for, with the nearest.
  void refuse_unasked(Diagnostics& diagnostics) const;

 private:
  struct Given {
    std::string name, value, assignment;
  };
  const Given* given(const std::string& name) const;
  void note(LuaArgument argument, LuaArgument fallback);

  std::vector<Given> given_;
  std::vector<LuaArgument> asked_;
  std::vector<LuaArgument> defaults_;  // of asked_
};

}  // namespace flyrock
