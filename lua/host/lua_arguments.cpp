#include "host/lua_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <lua.hpp>
#include <memory>
#include <stdexcept>

#include "document/printable.h"
#include "document/wording.h"

namespace flyrock {

namespace {

constexpr const char* name_letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";

bool is_name(const std::string& text) {
  return !text.empty() && text.find_first_not_of(name_letters) == std::string::npos;
}

Location in_option(const std::string& assignment) {
  return {std::make_shared<Source>(Source{"--arg " + assignment, {}}), 0, 0};
}

/// The text at a place of the stack, with its zero bytes; empty for another type.
std::string text_at(lua_State* lua, int index) {
  if (lua_type(lua, index) != LUA_TSTRING) return {};
  std::size_t size = 0;
  const char* text = lua_tolstring(lua, index, &size);
  return {text, size};
}

/// The number or text at a place of the stack.
LuaArgument argument_at(lua_State* lua, int index, const std::string& name) {
  if (lua_type(lua, index) == LUA_TSTRING) return {name, text_at(lua, index)};
  if (lua_isinteger(lua, index)) return {name, std::int64_t{lua_tointeger(lua, index)}};
  return {name, lua_tonumber(lua, index)};
}

/// Whether a default is a text that can be stored, or a finite number.
bool is_default(lua_State* lua, int index) {
  if (lua_type(lua, index) == LUA_TSTRING) return text_fault(text_at(lua, index)).empty();
  return lua_type(lua, index) == LUA_TNUMBER && std::isfinite(lua_tonumber(lua, index));
}

/// Pushes the value of a text that stands for a number; whether it is one.
bool push_number(lua_State* lua, const std::string& text) {
  if (lua_stringtonumber(lua, text.c_str()) != text.size() + 1) return false;
  return std::isfinite(lua_tonumber(lua, -1));
}

}  // namespace

std::string text_of(const LuaArgument& argument) {
  return std::visit([](const auto& value) { return fmt::format("{}", value); }, argument.value);
}

void LuaArguments::give(const std::vector<std::string>& assignments, Diagnostics& diagnostics) {
  for (const std::string& assignment : assignments) {
    const std::size_t equals = assignment.find('=');
    const std::string name = assignment.substr(0, equals);
    if (equals == std::string::npos || !is_name(name))
      diagnostics.error(in_option(assignment), "", "expected name=value, as in --arg stones=41");
    else if (given(name))
      diagnostics.error(in_option(assignment), "", fmt::format("`{}` is given twice", name));
    else if (const std::string fault = text_fault(assignment); !fault.empty())
      diagnostics.error(in_option(assignment), "", fmt::format("the value {}", fault));
    else
      given_.push_back({name, assignment.substr(equals + 1), assignment});
  }
}

void LuaArguments::answer(lua_State* lua) {
  const std::string name = text_at(lua, 1);
  if (!is_name(name) || !is_default(lua, 2))
    throw std::runtime_error(
        "fr.argument takes a name (letters, digits and _) and a default, a number or a text, as "
        "fr.argument(\"stones\", 21)");
  lua_settop(lua, 2);
  const LuaArgument fallback = argument_at(lua, 2, name);
  if (const Given* found = given(name)) {
    if (lua_type(lua, 2) == LUA_TSTRING)
      lua_pushlstring(lua, found->value.data(), found->value.size());
    else if (!push_number(lua, found->value))
      throw std::runtime_error(fmt::format("argument `{}`: `{}` is not a number, as its default {} is", name,
                                           printable(found->value), text_of(fallback)));
  }
  note(argument_at(lua, -1, name), fallback);
}

void LuaArguments::note(LuaArgument argument, LuaArgument fallback) {
  const auto before = std::find_if(defaults_.begin(), defaults_.end(),
                                   [&](const LuaArgument& one) { return one.name == fallback.name; });
  if (before == defaults_.end()) {
    asked_.push_back(std::move(argument));
    defaults_.push_back(std::move(fallback));
  } else if (before->value != fallback.value) {
    throw std::runtime_error(fmt::format("argument `{}` is declared with two defaults: {} and {}",
                                         fallback.name, text_of(fallback), text_of(*before)));
  }
}

void LuaArguments::refuse_unasked(Diagnostics& diagnostics) const {
  const std::vector<std::string> names = names_of(asked_);
  for (const Given& one : given_) {
    if (std::find(names.begin(), names.end(), one.name) != names.end()) continue;
    diagnostics.error(
        in_option(one.assignment), "",
        names.empty()
            ? fmt::format("unknown argument `{}`: no Lua file of this scenario calls fr.argument", one.name)
            : fmt::format("unknown argument `{}`{}", one.name, suggestion(one.name, names)));
  }
}

const LuaArguments::Given* LuaArguments::given(const std::string& name) const {
  const auto found =
      std::find_if(given_.begin(), given_.end(), [&](const Given& one) { return one.name == name; });
  return found == given_.end() ? nullptr : &*found;
}

}  // namespace flyrock
