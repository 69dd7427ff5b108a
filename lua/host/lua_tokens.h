#pragma once
// The words of a Lua source, as far as finding table constructors needs them.

#include <string>
#include <vector>

namespace flyrock {

struct LuaToken {
  enum class Kind { name, text, number, symbol, end };
  Kind kind = Kind::end;
  std::string text;  ///< of a short text: between its quotes, escapes as written
  int line = 0;      ///< from 1
  int column = 0;    ///< from 1, in bytes

  bool is(const char* what) const { return kind != Kind::text && text == what; }
};

/// The words of the lines, comments left out, and one of kind `end` after them. The source is expected to
/// compile: of what does not, nothing sensible comes out.
std::vector<LuaToken> lua_tokens(const std::vector<std::string>& lines);

}  // namespace flyrock
