#include "sandbox/freeze.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <lua.hpp>
#include <set>
#include <tuple>

#include "sandbox/read_only.h"
#include "sandbox/state.h"

namespace flyrock {

namespace {

int refuse_change(lua_State* lua) {
  raise(lua, fmt::format("`{}` cannot be changed: what stands outside of functions is frozen after loading",
                         lua_tostring(lua, lua_upvalueindex(1))));
}

/// "a.b"; "b" if the table has no name (the globals).
std::string field_path(const std::string& path, const char* field) {
  return path.empty() ? field : path + "." + field;
}

/// Walks over everything that a function reaches. Freezes tables and gives each function to `use`.
class Walk {
 public:
  explicit Walk(lua_State* lua) : lua_(lua) {
    lua_createtable(lua, 0, 0);
    waiting_ = lua_gettop(lua);
  }

  /// Adds the value at the top of the stack to the walk.
  void add(const std::string& name) {
    const int type = lua_type(lua_, -1);
    if (type == LUA_TTHREAD)
      raise(lua_, fmt::format(
                      "reaches the coroutine `{}`, which would remember one call in the next: make it inside "
                      "of the function",
                      name));
    if ((type == LUA_TTABLE || type == LUA_TFUNCTION) && seen_.insert(lua_topointer(lua_, -1)).second) {
      names_.push_back(name);
      lua_rawseti(lua_, waiting_, static_cast<lua_Integer>(names_.size()));
    } else {
      lua_pop(lua_, 1);
    }
  }

  /// Walks. use(name) finds the function at the top of the stack.
  template <class Use>
  void run(Use&& use) {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      charge(lua_, 10);
      const std::string name = names_[i];
      if (lua_rawgeti(lua_, waiting_, static_cast<lua_Integer>(i + 1)) == LUA_TTABLE) {
        table(name);
      } else {
        use(name);
        for (int n = 1; const char* local = lua_getupvalue(lua_, -1, n); ++n)
          add(!*local ? name : std::string_view(local) == "_ENV" ? "" : local);
      }
      lua_pop(lua_, 1);
    }
    lua_pop(lua_, 1);
  }

 private:
  void table(const std::string& name) {
    if (!push_shown(lua_, -1)) {
      const int table = lua_gettop(lua_);
      const bool has_metatable = lua_getmetatable(lua_, table);
      freeze_table(lua_, table, name, guarded<refuse_change>);
      if (has_metatable) keep_former_metatable(lua_, table);
      push_shown(lua_, table);
    }
    // Needed even if another walk has frozen the table, because its metamethods may set local variables.
    if (push_former_metatable(lua_, -2)) add(name + "'s metatable");
    add_fields(name);
    lua_pop(lua_, 1);
  }

  /// Adds the fields of the table at the top of the stack, in an order that does not depend on the addresses
  /// of keys.
  void add_fields(const std::string& path) {
    struct Field {
      int key_type;
      double number;
      std::string name;
      lua_Integer place;  // index in the list of values
    };
    std::vector<Field> fields;
    double count = 0;
    lua_createtable(lua_, 0, 0);
    const int values = lua_gettop(lua_);
    for (lua_pushnil(lua_); lua_next(lua_, values - 1); ++count) {
      const int type = lua_type(lua_, -1);
      if (type != LUA_TTABLE && type != LUA_TFUNCTION && type != LUA_TTHREAD) {
        lua_pop(lua_, 1);
        continue;
      }
      const int key = lua_type(lua_, -2);
      const double number = key == LUA_TNUMBER ? lua_tonumber(lua_, -2) : lua_toboolean(lua_, -2);
      const auto place = static_cast<lua_Integer>(fields.size()) + 1;
      fields.push_back(
          {key, number, key == LUA_TSTRING ? field_path(path, lua_tostring(lua_, -2)) : path + "[]", place});
      lua_rawseti(lua_, values, place);
    }
    charge(lua_, 10 * count);
    std::stable_sort(fields.begin(), fields.end(), [](const Field& a, const Field& b) {
      return std::tie(a.key_type, a.number, a.name) < std::tie(b.key_type, b.number, b.name);
    });
    for (const Field& field : fields) {
      lua_rawgeti(lua_, values, field.place);
      add(field.name);
    }
    lua_pop(lua_, 1);
  }

  lua_State* lua_;
  int waiting_;  // list of reached values, each with its name
  std::vector<std::string> names_;
  std::set<const void*> seen_;
};

bool same_value(lua_State* lua, int a, int b) {
  if (lua_type(lua, a) != LUA_TNUMBER || lua_type(lua, b) != LUA_TNUMBER) return lua_rawequal(lua, a, b);
  if (lua_isinteger(lua, a) != lua_isinteger(lua, b)) return false;
  if (lua_isinteger(lua, a)) return lua_tointeger(lua, a) == lua_tointeger(lua, b);
  // Compares bits, so that nan equals itself and 0 differs from -0.
  return std::bit_cast<std::uint64_t>(lua_tonumber(lua, a)) ==
         std::bit_cast<std::uint64_t>(lua_tonumber(lua, b));
}

}  // namespace

OuterLocals::OuterLocals(lua_State* lua, const std::string& what) {
  const int function = lua_gettop(lua);
  lua_createtable(lua, 0, 0);
  Walk walk(lua);
  lua_pushvalue(lua, function);
  walk.add(what);
  std::set<const void*> known;  // because functions may share a local
  walk.run([&](const std::string& name) {
    const bool library = lua_iscfunction(lua, -1);
    for (int n = 1; const char* local = lua_getupvalue(lua, -1, n); ++n) {
      // Iterators of the library count in an upvalue; they never set their other upvalues.
      const bool may_change = !library || lua_type(lua, -1) == LUA_TNUMBER;
      if (may_change && known.insert(lua_upvalueid(lua, -2, n)).second) {
        locals_.push_back({n, library ? name : local});
        const auto place = 2 * static_cast<lua_Integer>(locals_.size());
        lua_rawseti(lua, function + 1, place);
        lua_pushvalue(lua, -1);
        lua_rawseti(lua, function + 1, place - 1);
      } else {
        lua_pop(lua, 1);
      }
    }
  });
  cells_ = luaL_ref(lua, LUA_REGISTRYINDEX);
}

const char* OuterLocals::restore(lua_State* lua) const {
  const char* changed = nullptr;
  lua_rawgeti(lua, LUA_REGISTRYINDEX, cells_);
  const int cells = lua_gettop(lua);
  for (std::size_t i = 0; i < locals_.size(); ++i) {
    lua_rawgeti(lua, cells, static_cast<lua_Integer>(2 * i + 1));
    lua_getupvalue(lua, -1, locals_[i].upvalue);
    lua_rawgeti(lua, cells, static_cast<lua_Integer>(2 * i + 2));
    if (!same_value(lua, -1, -2)) {
      if (!changed) changed = locals_[i].name.c_str();
      lua_setupvalue(lua, -3, locals_[i].upvalue);
    }
    lua_settop(lua, cells);
  }
  lua_pop(lua, 1);
  return changed;
}

}  // namespace flyrock
