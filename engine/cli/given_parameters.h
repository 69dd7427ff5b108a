#pragma once
// The parameters of a plugin that the command line gives, `--set name=value`, with units as in a scenario.

#include <optional>
#include <string>
#include <vector>

#include "plugin/registry.h"

namespace flyrock::cli {

/// The use of a plugin with these parameters and the defaults of the others. Prints faults and returns
/// nothing if there are any, also for a required parameter that is not given. Throws UsageError for a text
/// without `=`.
std::optional<PluginUse> decode_use(const Registry& registry, const PluginSpec& spec,
                                    const std::vector<std::string>& settings);

/// Only these parameters, for each parameter of the plugin (ParamValue::given).
std::optional<std::vector<ParamValue>> decode_given(const Registry& registry, const PluginSpec& spec,
                                                    const std::vector<std::string>& settings, int dimension);

}  // namespace flyrock::cli
