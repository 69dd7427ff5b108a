#pragma once
// Reads the fields of what a plugin's Lua function returned.

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "document/value.h"
#include "host/locate.h"
#include "host/lua_call.h"
#include "host/table_reader.h"
#include "math/space.h"

namespace flyrock {

/// Reads the tree of one answer. Every error names its place in the tree.
class AnswerReader {
 public:
  explicit AnswerReader(const LuaCall& call) : call_(call) {}

  [[noreturn]] void wrong(const std::string& path, const Value& value, const std::string& expected) const {
    const std::string name = path.empty() ? "" : path + " = ";
    const std::string found = value.number() ? shortest(*value.number()) : value.kind();
    call_.fail(fmt::format("returned {}{}, expected {}", name, found, expected));
  }

  void check_keys(const Value& value, const std::string& path, const std::vector<std::string>& known) const {
    if (value.list() && value.list()->empty())
      return;  // an empty list and a table without fields look the same in Lua
    if (!value.map()) wrong(path, value, "a table with " + choice_text(known));
    for (const Entry& entry : *value.map())
      if (std::find(known.begin(), known.end(), entry.key) == known.end()) {
        const std::string hint = did_you_mean(entry.key, known);
        call_.fail(fmt::format("returned the unknown field {}{}", join_path(path, entry.key),
                               hint.empty() ? ", expected " + choice_text(known) : hint));
      }
  }

  double number(const Value& value, const std::string& path) const {
    if (!value.number()) wrong(path, value, "a number");
    return *value.number();
  }

  const List& list(const Value& value, const std::string& path, const std::string& expected) const {
    if (!value.list()) wrong(path, value, expected);
    return *value.list();
  }

  Vec3 vector(const Value& value, const std::string& path, int dimension) const {
    const char* expected = dimension == 2 ? "{ x, y }" : "{ x, y, z }";
    const List& components = list(value, path, expected);
    if (static_cast<int>(components.size()) != dimension) wrong(path, value, expected);
    Vec3 result = Vec3::Zero();
    for (int i = 0; i < dimension; ++i) result[i] = number(components[i], join_path(path, i));
    return result;
  }

  Vec2 point(const Value& value, const std::string& path) const { return vector(value, path, 2).head<2>(); }

  std::vector<Vec2> points(const Value& value, const std::string& path) const {
    std::vector<Vec2> result;
    const List& items = list(value, path, "a list of { x, y }");
    for (std::size_t i = 0; i < items.size(); ++i) result.push_back(point(items[i], join_path(path, i)));
    return result;
  }

 protected:
  const LuaCall& call_;
};

}  // namespace flyrock
