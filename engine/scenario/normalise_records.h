#pragma once
// Normalises lists of records, and laws from which a plugin samples.

#include "document/value.h"
#include "scenario/normalise_number.h"

namespace flyrock {

/// Records of a parameter: a list of maps, one map where the parameter is `single`, or one of its words. A
/// file is a YAML file with a list under the name of the parameter, or a table whose columns are the fields;
/// its records then stand in the tree.
Value normalise_records(DecodeContext& context, const Node& node, const ParamSpec& spec,
                        const NumberRules& rules);

/// A number, or a distribution without `per`, because the plugin says how often it draws.
Value normalise_law(DecodeContext& context, const Node& node, const ParamSpec& spec);

}  // namespace flyrock
