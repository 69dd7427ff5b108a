#pragma once
// Parameters sampled within the limits that a manifest declares.

#include <string>
#include <vector>

#include "plugin/params.h"
#include "random/stream.h"

namespace flyrock {

/// Whether a value of this parameter can be sampled; a text or the name of a file cannot.
bool can_sample(const ParamSpec& spec);
/// Whether values can be sampled for all required parameters.
bool can_sample(const PluginSpec& spec);

/// A value of parameter `i` within its limits and within the bounds between it and the given ones of
/// `values`. It is near the default, if there is one other than 0; otherwise anywhere in the range. A side
/// without limit is one unit long, for whole numbers six steps. Points are those of a convex polygon with
/// increasing x, in 3D of a tetrahedron; with limits of their components any three with increasing x.
ParamValue sample_param(const PluginSpec& spec, std::size_t i, const std::vector<ParamValue>& values,
                        int dimension, RandomStream& rng);

/// Whether the numbers of `values` satisfy the bounds between parameters.
bool keeps_bounds(const PluginSpec& spec, const std::vector<ParamValue>& values);

/// Samples for every choice of optional parameters, with all required ones given. With more than six optional
/// parameters: none, all, and random choices, 64 in total. Returns nothing if a required parameter cannot be
/// sampled. A choice is left out if none of a hundred samples satisfies the bounds. Parameters that `fixed`
/// gives keep that value; it is empty or has an entry for each parameter.
std::vector<std::vector<ParamValue>> sample_variants(const PluginSpec& spec, int dimension, RandomStream& rng,
                                                     const std::vector<ParamValue>& fixed = {});
/// Whether `fixed` gives parameter `i`.
inline bool is_given(const std::vector<ParamValue>& fixed, std::size_t i) {
  return !fixed.empty() && fixed[i].given;
}

/// The given parameters as a text: "en = 0.4, speed = 12 m/s, sides = 5". The values are taken from `numbers`
/// (drawn dense_slots) and written in the declared units. "none" if there are no parameters.
std::string parameters_text(const PluginSpec& spec, const std::vector<ParamValue>& values, Values numbers);

}  // namespace flyrock
