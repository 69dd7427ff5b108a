#pragma once
// Lua's text patterns (reference manual 6.4.1). Each step is charged to the budget, because the library's own
// matcher can backtrack for hours without calling a hook.

#include <array>
#include <cstddef>
#include <string_view>

struct lua_State;

namespace flyrock {

class PatternMatcher {
 public:
  /// Both texts must outlive the matcher. Errors in the pattern are Lua errors, as in the library.
  PatternMatcher(lua_State* lua, std::string_view subject, std::string_view pattern);

  /// The end of the match that begins at `start`; null if there is none. `pattern` must not include its
  /// anchor.
  const char* match(const char* start);

  int captures() const { return level_; }
  /// Pushes capture `index`, from 0. If the pattern has no captures, index 0 is the whole match from start to
  /// end.
  void push_capture(int index, const char* start, const char* end) const;
  /// Pushes all captures, or the whole match if there are none and `start` is not null. Returns their number.
  int push_captures(const char* start, const char* end) const;

 private:
  static constexpr int max_captures = 32, max_depth = 200;
  static constexpr std::ptrdiff_t unfinished = -1, position = -2;
  struct Capture {
    const char* start;
    std::ptrdiff_t length;
  };

  void step();
  const char* match(const char* s, const char* p);
  const char* class_end(const char* p) const;
  bool matches_one(const char* s, const char* p, const char* end_of_class) const;
  bool matches_set(int c, const char* p, const char* end_of_class) const;
  const char* expand_longest(const char* s, const char* p, const char* end_of_class);
  const char* expand_shortest(const char* s, const char* p, const char* end_of_class);
  const char* open_capture(const char* s, const char* p, std::ptrdiff_t kind);
  const char* close_capture(const char* s, const char* p);
  const char* match_balanced(const char* s, const char* p);
  const char* match_frontier(const char* s, const char* p);
  const char* match_back_reference(const char* s, int digit) const;
  int at(const char* s) const { return s < end_ ? static_cast<unsigned char>(*s) : '\0'; }

  lua_State* lua_;
  const char *begin_, *end_, *pattern_, *pattern_end_;
  std::array<Capture, max_captures> capture_;
  int level_ = 0;
  int depth_ = 0;
  int steps_ = 0;
};

/// Replaces find, match, gmatch and gsub in the string library at the top of the stack.
void add_pattern_functions(lua_State* lua);

}  // namespace flyrock
