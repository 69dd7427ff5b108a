#pragma once
// Normalises the parts of a parameter of type shapes, and turns in 3D.

#include "document/value.h"
#include "scenario/normalise_number.h"

namespace flyrock {

/// A list of shapes, each a plugin with the keys `at` and `turn` in addition. Reports what is wrong; null if
/// it is no list of parts.
Value normalise_shapes(DecodeContext& context, const Node& node, const NumberRules& rules);

/// A turn in 3D: { axis, angle } or a quaternion [w, x, y, z].
Value normalise_turn(DecodeContext& context, const Node& node, const NumberRules& rules);

}  // namespace flyrock
