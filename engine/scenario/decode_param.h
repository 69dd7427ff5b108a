#pragma once
// Decodes the value of one parameter.

#include "scenario/decode_number.h"

namespace flyrock {

/// Decodes the value of a parameter into `value` and into the resolved tree, and reports what is wrong with
/// it.
void decode_param(DecodeContext& context, const Node& node, const ParamSpec& spec, const NumberRules& rules,
                  ParamValue& value, Value& resolved);

/// Takes the default of a parameter that is not given; false if it has none.
bool take_default(const ParamSpec& spec, int dimension, ParamValue& value, Value& resolved);

}  // namespace flyrock
