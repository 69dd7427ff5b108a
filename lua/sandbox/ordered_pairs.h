#pragma once
// Traverses tables in an order that does not depend on addresses or hashes.

struct lua_State;

namespace flyrock {

/// pairs(t): numbers ascending, then texts by bytes, then false, true. Any other key is an error, because it
/// has no fixed order. A metamethod __pairs is called first, as in Lua.
int ordered_pairs(lua_State* lua);

/// next(t [, key]) in the same order. Takes time proportional to the size of t.
int ordered_next(lua_State* lua);

}  // namespace flyrock
