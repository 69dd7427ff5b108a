#pragma once
// What Lua code of scenarios and plugins finds: the pure part of the standard library, read-only, with the
// functions that could hide an exhausted budget, run unbounded, or make a run depend on addresses replaced.
//
// Not there: io, os, debug, package, load and its kin, rawset, collectgarbage, string.dump, math.random.
// Every name that is not defined is an error that says so.

#include <string>

struct lua_State;

namespace flyrock {

/// Opens the libraries and leaves the table of globals (strict, shared by all files) at the top of the stack.
/// `require` is not in it: the host adds it.
void push_globals(lua_State* lua);

/// Pushes an environment for one file: reads pass to the table of globals at `globals`, writes stay in it.
void push_environment(lua_State* lua, int globals);

/// Closes the environment at `index` for writing, once its file is loaded.
void freeze_environment(lua_State* lua, int index);

// The parts of push_globals; each fills the table at the top of the stack.
void add_base_library(lua_State* lua);
void add_table_library(lua_State* lua);
void add_string_library(lua_State* lua);
void add_coroutine_library(lua_State* lua);

}  // namespace flyrock
