#pragma once
// Reads a Lua table into the tree of located values.

#include <functional>
#include <optional>
#include <string>

#include "document/diagnostics.h"
#include "document/value.h"
#include "host/locate.h"

struct lua_State;

namespace flyrock {

/// Takes a function at `path`, which is at the top of the stack. Returns false if no function is allowed
/// there.
using FunctionSink = std::function<bool(const std::string& path)>;

/// Reads the value at `index`: numbers, texts, booleans and tables of them. Keys are texts (a map, sorted by
/// bytes) or 1 to n (a list); an empty table is an empty list. Everything else is an error, also cycles,
/// numbers that are not finite, whole numbers above 2^53 and more than 100,000 values. Functions go to
/// `functions` and leave no value. Nothing if there are errors.
std::optional<Value> read_value(lua_State* lua, int index, const FieldPlaces& places,
                                Diagnostics& diagnostics, const FunctionSink& functions);

}  // namespace flyrock
