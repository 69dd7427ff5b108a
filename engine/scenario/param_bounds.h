#pragma once
// Parameters that bound each other: `max = "mu_s"` in a manifest.

#include <vector>

#include "scenario/decode_number.h"

namespace flyrock {

/// Reports each number of `map` that is out of a bound which another one of it sets, at the key of the one
/// that the file gives, with both values. What is drawn is judged by the ends of its distribution: no draw
/// may break a bound. `decoded` says which values are there and sound.
void check_bounds(DecodeContext& context, const Node& map, const std::vector<ParamSpec>& specs,
                  const std::vector<ParamValue>& values, const std::vector<bool>& decoded);

}  // namespace flyrock
