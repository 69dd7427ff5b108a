#pragma once
// Parameters by their specification: those of plugins and those of a scenario's own sections alike.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenario/decode_number.h"
#include "scenario/schema.h"

namespace flyrock {

/// Decodes the keys of a map that `specs` name, in their order, fills in defaults, and reports what is
/// missing. Appends to `resolved`. Keys that are not in `specs` are left to the caller.
std::vector<ParamValue> decode_params(DecodeContext& context, const Node& map,
                                      const std::vector<ParamSpec>& specs, const NumberRules& rules,
                                      Map& resolved);

/// One decoded section. A value that was reported as wrong reads as 0, empty text or a constant 0: the
/// scenario is refused anyway, once all of it was looked at.
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
  /// Points of the scenario's dimension; z = 0 in 2D.
  std::vector<Vec3> points(std::string_view name) const;

 private:
  const ParamValue& at(std::string_view name) const;

  const std::vector<ParamSpec>& specs_;
  std::vector<ParamValue> values_;
};

/// Decodes a section of the schema. Without a node all its keys take their defaults.
Section decode_section(DecodeContext& context, const std::optional<Node>& node, std::string_view name,
                       const NumberRules& rules, Map& resolved);

/// Decodes the use of a plugin: `type` and its parameters, beside which the keys `others` may stand. `type`
/// may be left out where there is a `default_type`.
std::optional<PluginUse> decode_plugin(DecodeContext& context, const Node& node, PluginKind kind,
                                       const NumberRules& rules, Map& resolved,
                                       const std::vector<std::string>& others = {},
                                       std::string_view default_type = {});

/// Text that becomes a step of paths and measures: letters, digits, `_` and `-`.
bool check_name(DecodeContext& context, const Node& node);
/// The same of the key at which a node stands.
bool check_key(DecodeContext& context, const Node& node);

}  // namespace flyrock
