#pragma once
// table.sort of the sandbox. Lua's own chooses pivots by the clock in long tables, so that the order of
// elements that compare as equal differs from run to run.

struct lua_State;

namespace flyrock {

/// table.sort(list [, comp]): by merging, so that equal elements keep their order, and any comparison ends.
int stable_sort(lua_State* lua);

}  // namespace flyrock
