#pragma once
// table.sort of the sandbox. In long tables Lua's own version chooses pivots by the clock, so the order of
// elements that compare as equal differs from run to run.

struct lua_State;

namespace flyrock {

/// table.sort(list [, comp]) by merging: equal elements keep their order, and the sort ends for any
/// comparison.
int stable_sort(lua_State* lua);

}  // namespace flyrock
