#pragma once
// Loads that change over time: `{ table: [[t, v], ...] }` in place of a number or a vector.

#include <memory>

#include "document/node.h"
#include "math/over_time.h"
#include "scenario/decode_context.h"

namespace flyrock {

/// Whether a value is a table over time.
bool is_over_time(const Value& value);

/// The table with times and values in SI units, within the limits of `spec`. Gravity is a number in the
/// schema; in a table it is a vector, too. Null if it is wrong.
Value normalise_over_time(DecodeContext& context, const Node& node, const ParamSpec& spec);

/// The value of a normalised table in its first row: of a number one, of a vector its components. Of gravity
/// as a vector, how much of it points down.
std::vector<double> start_of_table(const Value& table, const ParamSpec& spec);

/// The normalised table. Null if the value is no table. A number that points down (gravity) is a vector.
std::shared_ptr<const OverTime> decode_over_time(const std::optional<Node>& node);
std::shared_ptr<const OverTime> decode_gravity_over_time(const std::optional<Node>& node, int dimension);

}  // namespace flyrock
