#pragma once
// Decodes parameters by their specification. Plugins and the scenario's own sections use the same code.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenario/decode_number.h"
#include "scenario/schema.h"

namespace flyrock {

/// Decodes the keys of a map that `specs` name, in their order, fills in defaults, and reports missing keys.
/// Appends to `resolved`. The caller handles keys that are not in `specs`.
std::vector<ParamValue> decode_params(DecodeContext& context, const Node& map,
                                      const std::vector<ParamSpec>& specs, const NumberRules& rules,
                                      Map& resolved);

/// One decoded section. A value that was reported as wrong reads as 0, as empty text or as a constant 0, so
/// that the rest of the scenario can still be checked before it is refused.
class Section {
 public:
  Section(const std::vector<ParamSpec>& specs, std::vector<ParamValue> values)
      : specs_(specs), values_(std::move(values)) {}

  bool given(std::string_view name) const { return at(name).given; }
  Number number(std::string_view name) const;
  std::optional<Number> optional_number(std::string_view name) const;
  double constant(std::string_view name) const { return number(name).constant; }
  int integer(std::string_view name) const { return static_cast<int>(constant(name)); }
  const std::string& text(std::string_view name) const { return at(name).text; }
  const std::vector<Number>& vector(std::string_view name) const { return at(name).numbers; }
  /// Points in the dimension of the scenario; z = 0 in 2D.
  std::vector<Vec3> points(std::string_view name) const;

 private:
  const ParamValue& at(std::string_view name) const;

  const std::vector<ParamSpec>& specs_;
  std::vector<ParamValue> values_;
};

/// Decodes a section of the schema. If there is no node, all keys take their defaults.
Section decode_section(DecodeContext& context, const std::optional<Node>& node, std::string_view name,
                       const NumberRules& rules, Map& resolved);

/// Decodes the use of a plugin: `type` and its parameters. The map may also hold the keys `others`. `type`
/// may be missing if there is a `default_type`.
std::optional<PluginUse> decode_plugin(DecodeContext& context, const Node& node, PluginKind kind,
                                       const NumberRules& rules, Map& resolved,
                                       const std::vector<std::string>& others = {},
                                       std::string_view default_type = {});

/// Checks a text that becomes a step of paths and measures: only letters, digits, `_` and `-`.
bool check_name(DecodeContext& context, const Node& node);
/// The same check for the key of a node.
bool check_key(DecodeContext& context, const Node& node);

}  // namespace flyrock
