#pragma once
// Decodes one point of a sweep: a normalised tree becomes a typed scenario.

#include "scenario/decode_context.h"
#include "scenario/scenario.h"

namespace flyrock {

/// Decodes all sections of a normalised document, and reports what is wrong in what they mean together.
Scenario decode_document(DecodeContext& context, const Node& root);

}  // namespace flyrock
