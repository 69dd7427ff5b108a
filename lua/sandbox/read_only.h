#pragma once
// Tables that Lua code may read and not write.

#include <string>
#include <vector>

struct lua_State;

namespace flyrock {

/// Replaces the table at the top of the stack by a view of it: reading passes through, also for `#` and
/// pairs; writing and setmetatable are errors. The host keeps writing to the table itself.
/// `what` names it in messages: "p", "math". `is_data` says that it holds values, which a plugin may return.
void make_read_only(lua_State* lua, const std::string& what, bool is_data = false);

/// Makes the table at `index` a view of its own fields, in place: who holds it cannot write it any more.
/// Its metamethods stay, but for those that write. `refuse` is its __newindex; it finds `what` in upvalue 1.
void freeze_table(lua_State* lua, int index, const std::string& what, int (*refuse)(lua_State*));

/// Keeps the metatable at the top of the stack, which is popped, as the one that the frozen table at `index`
/// had.
void keep_former_metatable(lua_State* lua, int index);
/// Pushes the metatable that the frozen table at `index` had, or returns false where there was none.
bool push_former_metatable(lua_State* lua, int index);

/// Marks the table at `index`, which has a metatable, as one that no Lua code gets hold of: it is its own
/// view.
void mark_hidden(lua_State* lua, int index);

/// Pushes the table that the view at `index` shows, or returns false where it is no view.
bool push_shown(lua_State* lua, int index);

/// Pushes the view whose fields stand in the table at `index`, or returns false where there is none: frozen
/// tables are metatables by their fields, since Lua asks metatables past any view.
bool push_view(lua_State* lua, int index);

/// Replaces a view of data at the top of the stack by what it shows; false where it is a view of other
/// things. What is no view stays as it is.
bool see_through(lua_State* lua);

/// Makes reading an absent field of the table at `index` an error with the nearest name, but for the names
/// in `absent`, a table { name = true } at the top of the stack, which is popped. `what` is as above.
void make_strict(lua_State* lua, int index, const std::string& what);

/// The text keys of the table at `index`, sorted.
std::vector<std::string> text_keys(lua_State* lua, int index);

}  // namespace flyrock
