#pragma once
// The environment of Lua code in scenarios and plugins: the pure part of the standard library, read-only.
// Functions are replaced if they could hide an exhausted budget, run without bound, or make a run depend on
// addresses.
//
// Not included: io, os, debug, package, load and similar functions, rawset, collectgarbage, string.dump,
// math.random. Reading an undefined name is an error that says so.

struct lua_State;

namespace flyrock {

/// Opens the libraries and leaves the table of globals (strict, shared by all files) at the top of the stack.
/// It does not contain `require`: the host adds it.
void push_globals(lua_State* lua);

/// Pushes an environment for one file. Reads go on to the table of globals at `globals`; writes stay in the
/// environment.
void push_environment(lua_State* lua, int globals);

/// Makes the environment at `index` read-only after its file is loaded.
void freeze_environment(lua_State* lua, int index);

// The parts of push_globals. Each fills the table at the top of the stack.
void add_base_library(lua_State* lua);
void add_table_library(lua_State* lua);
void add_string_library(lua_State* lua);
void add_coroutine_library(lua_State* lua);

}  // namespace flyrock
