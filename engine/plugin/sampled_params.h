#pragma once
// Parameters drawn from the limits that a manifest declares.

#include <string>
#include <vector>

#include "plugin/params.h"
#include "random/stream.h"

namespace flyrock {

/// Whether a value of this parameter can be made up: not a text or the name of a file.
bool can_sample(const ParamSpec& spec);
/// Whether values can be made up for all parameters that must be given.
bool can_sample(const PluginSpec& spec);

/// A value of parameter `i` within its limits and the bounds that it and those of `values` that are given set
/// each other: near the default where there is one that is not 0, else in the range (an open side is one unit
/// long; whole numbers six steps). Points are those of a convex polygon with x increasing, in 3D of a
/// tetrahedron.
ParamValue sample_param(const PluginSpec& spec, std::size_t i, const std::vector<ParamValue>& values,
                        int dimension, RandomStream& rng);

/// Whether the numbers of `values` keep the bounds that parameters set each other.
bool keeps_bounds(const PluginSpec& spec, const std::vector<ParamValue>& values);

/// Every choice of optional parameters with all the others given; of more than six optional ones none, all,
/// and choices at random, 64 together. Nothing where a required one cannot be sampled. A choice is left out
/// where no sample of a hundred keeps the bounds.
std::vector<std::vector<ParamValue>> sample_variants(const PluginSpec& spec, int dimension,
                                                     RandomStream& rng);

/// "en = 0.4, speed = 12 m/s, sides = 5": the parameters that are given, numbers as they stand in `numbers`,
/// which are dense_slots drawn, in the units that are declared; "none" where there are none.
std::string parameters_text(const PluginSpec& spec, const std::vector<ParamValue>& values, Values numbers);

}  // namespace flyrock
