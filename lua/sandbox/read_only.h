#pragma once
// Tables that Lua code can read but not write.

#include <string>
#include <vector>

struct lua_State;

namespace flyrock {

/// Replaces the table at the top of the stack by a view of it. Reading passes through, also for `#` and
/// pairs; writing and setmetatable are errors. The host still writes to the table itself. `what` names it in
/// messages: "p", "math". `is_data` means that it holds values, which a plugin may return.
void make_read_only(lua_State* lua, const std::string& what, bool is_data = false);

/// Turns the table at `index` in place into a view of its own fields, so that nobody who holds it can write
/// it. Its metamethods stay, except those that write. `refuse` is its __newindex and finds `what` in upvalue
/// 1.
void freeze_table(lua_State* lua, int index, const std::string& what, int (*refuse)(lua_State*));

/// Stores the metatable at the top of the stack as the former metatable of the frozen table at `index`. Pops
/// it.
void keep_former_metatable(lua_State* lua, int index);
/// Pushes the former metatable of the frozen table at `index`; false if it had none.
bool push_former_metatable(lua_State* lua, int index);

/// Marks the table at `index`, which has a metatable, as hidden from all Lua code: it is its own view.
void mark_hidden(lua_State* lua, int index);

/// Pushes the table that the view at `index` shows; false if it is no view.
bool push_shown(lua_State* lua, int index);

/// Pushes the view of the fields in the table at `index`; false if there is none. It is needed for frozen
/// tables that are metatables: Lua reads a metatable's fields without going through the view.
bool push_view(lua_State* lua, int index);

/// Replaces a view of data at the top of the stack by its table. False if it is a view of something else. A
/// value that is no view stays as it is.
bool see_through(lua_State* lua);

/// Makes reading an absent field of the table at `index` an error that names the nearest field. Exceptions
/// are the names in `absent`, a table { name = true } at the top of the stack, which is popped. `what`: as
/// above.
void make_strict(lua_State* lua, int index, const std::string& what);

/// The text keys of the table at `index`, sorted.
std::vector<std::string> text_keys(lua_State* lua, int index);

}  // namespace flyrock
