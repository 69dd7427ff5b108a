#pragma once
// Parameters drawn from the limits that a manifest declares.

#include <optional>
#include <vector>

#include "plugin/params.h"
#include "random/stream.h"

namespace flyrock {

/// Whether a value of this parameter can be made up: not a text or the name of a file.
bool can_sample(const ParamSpec& spec);

/// A value within the limits: near the default where there is one that is not 0, else in the range (an open
/// side is one unit long; whole numbers six steps). Points are those of a convex polygon with x increasing, in 3D
/// of a tetrahedron.
ParamValue sample_param(const ParamSpec& spec, int dimension, RandomStream& rng);

/// Every choice of optional parameters (at most ten of them are varied) with all the others given; nothing
/// where a required one cannot be sampled.
std::vector<std::vector<ParamValue>> sample_variants(const PluginSpec& spec, int dimension, RandomStream& rng);

}  // namespace flyrock
