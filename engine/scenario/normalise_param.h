#pragma once
// Normalises the value of one parameter.

#include "document/value.h"
#include "scenario/normalise_number.h"

namespace flyrock {

/// The value of a parameter in the normalised tree. Reports what is wrong with it; then it is null.
Value normalise_param(DecodeContext& context, const Node& node, const ParamSpec& spec,
                      const NumberRules& rules);

/// The default of a parameter that is not given; nothing if it has none.
std::optional<Value> default_value(const ParamSpec& spec, int dimension);

}  // namespace flyrock
