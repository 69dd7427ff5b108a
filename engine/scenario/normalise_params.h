#pragma once
// Normalises parameters by their specification. Plugins and the scenario's own sections use the same code.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "document/value.h"
#include "scenario/normalise_number.h"
#include "scenario/schema.h"

namespace flyrock {

/// The parameter `bearing`, which may stand in place of a plugin's angle `azimuth`; nothing if it has none.
std::optional<ParamSpec> bearing_beside(const std::vector<ParamSpec>& params);

/// A parameter whose unit has another one as its exponent (ParamSpec::unit_exponent), with the unit that
/// follows from the map: N/m^1.5. Where the exponent is drawn, the unit keeps the exponent 1.
ParamSpec with_exponent(const ParamSpec& spec, const std::vector<ParamSpec>& specs, const Node& map);

/// The keys of a map that `specs` name, in their order, with defaults. Reports missing keys. The caller
/// handles keys that are not in `specs`.
Map normalise_params(DecodeContext& context, const Node& map, const std::vector<ParamSpec>& specs,
                     const NumberRules& rules);

/// A section of the schema without its parts; null if it is no map. If there is no node, all keys take their
/// defaults.
Value normalise_section(DecodeContext& context, const std::optional<Node>& node, std::string_view name,
                        const NumberRules& rules);

/// The use of a plugin: `type` and its parameters. The map may also hold the keys `others`, which are left
/// out. `type` may be missing if there is a `default_type`; it is null if there is no such plugin. Null if it
/// is no map.
Value normalise_plugin(DecodeContext& context, const Node& node, PluginKind kind, const NumberRules& rules,
                       const std::vector<std::string>& others = {}, std::string_view default_type = {});

/// Checks a text that becomes a step of paths and measures: only letters, digits, `_` and `-`.
void check_name(DecodeContext& context, const Node& node);
/// The same check for the key of a node.
void check_key(DecodeContext& context, const Node& node);

}  // namespace flyrock
