#pragma once
// Decodes one point of a sweep: a tree without sweeps becomes a typed scenario.

#include "scenario/decode_number.h"
#include "scenario/scenario.h"

namespace flyrock {

/// Decodes all sections and reports what is wrong. Appends to `resolved` in schema order.
Scenario decode_document(DecodeContext& context, const Node& root, Map& resolved);

}  // namespace flyrock
