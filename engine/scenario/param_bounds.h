#pragma once
// Checks parameters that bound each other: `max = "mu_s"` in a manifest.

#include <vector>

#include "scenario/decode_context.h"

namespace flyrock {

/// Reports each number of `map` that violates a bound given by another number of it. The message is at the
/// key that the file gives and shows both values. A number that is drawn is judged by the ends of its
/// distribution, because no draw may violate a bound. `decoded` says which values are present and sound.
void check_bounds(DecodeContext& context, const Node& map, const std::vector<ParamSpec>& specs,
                  const std::vector<ParamValue>& values, const std::vector<bool>& decoded);

}  // namespace flyrock
