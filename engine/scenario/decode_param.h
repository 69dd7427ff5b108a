#pragma once
// The value of one parameter.

#include "scenario/decode_number.h"

namespace flyrock {

/// Decodes what was written for a parameter to its value and to the resolved tree, and reports what is wrong
/// with it.
void decode_param(DecodeContext& context, const Node& node, const ParamSpec& spec, const NumberRules& rules,
                  ParamValue& value, Value& resolved);

/// The default of a parameter that was not written; false where it has none.
bool take_default(const ParamSpec& spec, int dimension, ParamValue& value, Value& resolved);

}  // namespace flyrock
