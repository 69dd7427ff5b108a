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

/// Replaces a view of data at the top of the stack by what it shows; false where it is a view of other
/// things. What is no view stays as it is.
bool see_through(lua_State* lua);

/// Makes reading an absent field of the table at `index` an error with the nearest name, but for the names
/// in `absent`, a table { name = true } at the top of the stack, which is popped. `what` is as above.
void make_strict(lua_State* lua, int index, const std::string& what);

/// The text keys of the table at `index`, sorted.
std::vector<std::string> text_keys(lua_State* lua, int index);

}  // namespace flyrock
