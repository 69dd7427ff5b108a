#include "sandbox/pattern.h"

#include <cctype>
#include <cstring>
#include <lua.hpp>

#include "sandbox/budget.h"

namespace flyrock {

namespace {

constexpr char escape = '%';

bool in_class(int c, int letter) {
  bool inside;
  switch (std::tolower(letter)) {
    case 'a':
      inside = std::isalpha(c);
      break;
    case 'c':
      inside = std::iscntrl(c);
      break;
    case 'd':
      inside = std::isdigit(c);
      break;
    case 'g':
      inside = std::isgraph(c);
      break;
    case 'l':
      inside = std::islower(c);
      break;
    case 'p':
      inside = std::ispunct(c);
      break;
    case 's':
      inside = std::isspace(c);
      break;
    case 'u':
      inside = std::isupper(c);
      break;
    case 'w':
      inside = std::isalnum(c);
      break;
    case 'x':
      inside = std::isxdigit(c);
      break;
    default:
      return letter == c;
  }
  return std::isupper(letter) ? !inside : inside;
}

int byte(const char* p) { return static_cast<unsigned char>(*p); }

}  // namespace

PatternMatcher::PatternMatcher(lua_State* lua, std::string_view subject, std::string_view pattern)
    : lua_(lua),
      begin_(subject.data()),
      end_(subject.data() + subject.size()),
      pattern_(pattern.data()),
      pattern_end_(pattern.data() + pattern.size()) {}

void PatternMatcher::step() {
  constexpr int together = 100;
  if (++steps_ % together == 0) charge(lua_, together);
}

const char* PatternMatcher::match(const char* start) {
  level_ = 0;
  depth_ = 0;
  return match(start, pattern_);
}

const char* PatternMatcher::match(const char* s, const char* p) {
  if (++depth_ > max_depth) luaL_error(lua_, "pattern too complex");
  const char* result = nullptr;
  for (;;) {
    step();
    if (p == pattern_end_) {
      result = s;
      break;
    }
    const char next = p + 1 < pattern_end_ ? p[1] : '\0';
    if (*p == '(') {
      result = next == ')' ? open_capture(s, p + 2, position) : open_capture(s, p + 1, unfinished);
      break;
    }
    if (*p == ')') {
      result = close_capture(s, p + 1);
      break;
    }
    if (*p == '$' && p + 1 == pattern_end_) {
      result = s == end_ ? s : nullptr;
      break;
    }
    if (*p == escape && (next == 'b' || next == 'f' || std::isdigit(static_cast<unsigned char>(next)))) {
      if (next == 'b')
        s = match_balanced(s, p + 2);
      else if (next == 'f')
        s = match_frontier(s, p + 2);
      else
        s = match_back_reference(s, next);
      if (!s) break;
      p = next == 'b' ? p + 4 : next == 'f' ? class_end(p + 2) : p + 2;
      continue;
    }
    const char* end_of_class = class_end(p);
    const char suffix = end_of_class < pattern_end_ ? *end_of_class : '\0';
    const bool one = matches_one(s, p, end_of_class);
    if (suffix == '*' || suffix == '+') {
      result = suffix == '*' ? expand_longest(s, p, end_of_class)
               : one         ? expand_longest(s + 1, p, end_of_class)
                             : nullptr;
      break;
    }
    if (suffix == '-') {
      result = expand_shortest(s, p, end_of_class);
      break;
    }
    if (suffix == '?') {
      if (one)
        if (const char* rest = match(s + 1, end_of_class + 1)) {
          result = rest;
          break;
        }
      p = end_of_class + 1;
      continue;
    }
    if (!one) break;
    ++s;
    p = end_of_class;
  }
  --depth_;
  return result;
}

const char* PatternMatcher::class_end(const char* p) const {
  if (*p++ == escape) {
    if (p == pattern_end_) luaL_error(lua_, "malformed pattern (ends with '%%')");
    return p + 1;
  }
  if (p[-1] != '[') return p;
  if (p < pattern_end_ && *p == '^') ++p;
  do {  // looks for the closing bracket; a bracket in first place is a member
    if (p == pattern_end_) luaL_error(lua_, "malformed pattern (missing ']')");
    if (*p++ == escape && p < pattern_end_) ++p;
  } while (p == pattern_end_ || *p != ']');
  return p + 1;
}

bool PatternMatcher::matches_set(int c, const char* p, const char* end_of_class) const {
  const char* last = end_of_class - 1;  // the closing bracket
  const bool negated = p[1] == '^';
  for (p += negated ? 2 : 1; p < last; ++p) {
    if (*p == escape) {
      if (in_class(c, byte(++p))) return !negated;
    } else if (p[1] == '-' && p + 2 < last) {
      if (byte(p) <= c && c <= byte(p + 2)) return !negated;
      p += 2;
    } else if (byte(p) == c) {
      return !negated;
    }
  }
  return negated;
}

bool PatternMatcher::matches_one(const char* s, const char* p, const char* end_of_class) const {
  if (s >= end_) return false;
  const int c = byte(s);
  switch (*p) {
    case '.':
      return true;
    case escape:
      return in_class(c, byte(p + 1));
    case '[':
      return matches_set(c, p, end_of_class);
    default:
      return byte(p) == c;
  }
}

const char* PatternMatcher::expand_longest(const char* s, const char* p, const char* end_of_class) {
  std::ptrdiff_t count = 0;
  for (; matches_one(s + count, p, end_of_class); ++count) step();
  for (; count >= 0; --count)
    if (const char* rest = match(s + count, end_of_class + 1)) return rest;
  return nullptr;
}

const char* PatternMatcher::expand_shortest(const char* s, const char* p, const char* end_of_class) {
  for (;; ++s) {
    if (const char* rest = match(s, end_of_class + 1)) return rest;
    if (!matches_one(s, p, end_of_class)) return nullptr;
  }
}

const char* PatternMatcher::open_capture(const char* s, const char* p, std::ptrdiff_t kind) {
  if (level_ >= max_captures) luaL_error(lua_, "too many captures");
  capture_[level_++] = {s, kind};
  const char* rest = match(s, p);
  if (!rest) --level_;
  return rest;
}

const char* PatternMatcher::close_capture(const char* s, const char* p) {
  int open = level_ - 1;
  while (open >= 0 && capture_[open].length != unfinished) --open;
  if (open < 0) luaL_error(lua_, "invalid pattern capture");
  capture_[open].length = s - capture_[open].start;
  const char* rest = match(s, p);
  if (!rest) capture_[open].length = unfinished;
  return rest;
}

const char* PatternMatcher::match_balanced(const char* s, const char* p) {
  if (pattern_end_ - p < 2) luaL_error(lua_, "malformed pattern (missing arguments to '%%b')");
  if (s >= end_ || *s != p[0]) return nullptr;
  int depth = 1;
  for (++s; s < end_; ++s) {
    step();
    if (*s == p[1]) {
      if (--depth == 0) return s + 1;
    } else if (*s == p[0]) {
      ++depth;
    }
  }
  return nullptr;
}

const char* PatternMatcher::match_frontier(const char* s, const char* p) {
  if (p >= pattern_end_ || *p != '[') luaL_error(lua_, "missing '[' after '%%f' in pattern");
  const char* end_of_class = class_end(p);
  const int before = s == begin_ ? '\0' : byte(s - 1);
  return !matches_set(before, p, end_of_class) && matches_set(at(s), p, end_of_class) ? s : nullptr;
}

const char* PatternMatcher::match_back_reference(const char* s, int digit) const {
  const int index = digit - '1';
  if (index < 0 || index >= level_ || capture_[index].length == unfinished)
    luaL_error(lua_, "invalid capture index %%%d in pattern", index + 1);
  const std::ptrdiff_t length = capture_[index].length;
  const bool same = length >= 0 && end_ - s >= length && std::memcmp(capture_[index].start, s, length) == 0;
  return same ? s + length : nullptr;
}

void PatternMatcher::push_capture(int index, const char* start, const char* end) const {
  if (index >= level_) {
    if (index != 0) luaL_error(lua_, "invalid capture index %%%d", index + 1);
    lua_pushlstring(lua_, start, end - start);
    return;
  }
  const Capture& capture = capture_[index];
  if (capture.length == unfinished) luaL_error(lua_, "unfinished capture");
  if (capture.length == position)
    lua_pushinteger(lua_, capture.start - begin_ + 1);
  else
    lua_pushlstring(lua_, capture.start, capture.length);
}

int PatternMatcher::push_captures(const char* start, const char* end) const {
  const int count = level_ == 0 && start ? 1 : level_;
  luaL_checkstack(lua_, count, "too many captures");
  for (int i = 0; i < count; ++i) push_capture(i, start, end);
  return count;
}

}  // namespace flyrock
