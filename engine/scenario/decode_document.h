#pragma once
// One point of a sweep: a tree without sweeps to a typed scenario.

#include "scenario/decode_number.h"
#include "scenario/scenario.h"

namespace flyrock {

/// Decodes all sections; what is wrong is reported. Appends to `resolved` in schema order.
Scenario decode_document(DecodeContext& context, const Node& root, Map& resolved);

}  // namespace flyrock
