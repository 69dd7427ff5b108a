#pragma once
// A Lua table to the tree of located values.

#include <functional>
#include <optional>
#include <string>

#include "document/diagnostics.h"
#include "host/locate.h"

struct lua_State;

namespace flyrock {

/// Takes a function that stands at `path`, at the top of the stack; returns false where none may stand there.
using FunctionSink = std::function<bool(const std::string& path)>;

/// Reads the value at `index`. Numbers, texts, booleans and tables of them; keys are texts (a map, sorted by
/// bytes) or 1 to n (a list); an empty table is an empty list. All else is an error, as are cycles,
/// numbers that are not finite, whole numbers beyond 2^53 and more than 100,000 values. Functions go to
/// `functions` and leave no value. Nothing where there are errors.
std::optional<Value> read_value(lua_State* lua, int index, const FieldPlaces& places,
                                Diagnostics& diagnostics, const FunctionSink& functions);

}  // namespace flyrock
