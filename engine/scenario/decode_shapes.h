#pragma once
// Decodes the parts of a parameter of type shapes, and turns in 3D, of a normalised tree (decode_context.h).

#include "scenario/decode_context.h"
#include "scenario/scenario.h"

namespace flyrock {

/// The parts and their numbers, as ShapePart says.
ParamValue decode_shapes(DecodeContext& context, const Node& node);

/// A turn in 3D. Reports one that is no rotation.
TurnPlan decode_turn(DecodeContext& context, const Node& node);

}  // namespace flyrock
