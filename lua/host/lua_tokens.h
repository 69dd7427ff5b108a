#pragma once
// Splits a Lua source into words, as far as finding table constructors needs it.

#include <string>
#include <vector>

namespace flyrock {

struct LuaToken {
  enum class Kind { name, text, number, symbol, end };
  Kind kind = Kind::end;
  std::string text;  ///< for a short text: the part between its quotes, with escapes as written
  int line = 0;      ///< from 1
  int column = 0;    ///< from 1, in bytes

  bool is(const char* what) const { return kind != Kind::text && text == what; }
};

/// The words of the lines without comments, then one of kind `end`. The source must compile; otherwise the
/// result is meaningless.
std::vector<LuaToken> lua_tokens(const std::vector<std::string>& lines);

}  // namespace flyrock
