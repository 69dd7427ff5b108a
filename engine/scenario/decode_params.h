#pragma once
// Decodes the parameters of a normalised tree (decode_context.h).

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenario/decode_context.h"
#include "scenario/schema.h"

namespace flyrock {

/// A normalised number. A distribution is appended to the draws of the context.
Number decode_number(DecodeContext& context, const Node& node, const Dimension& dimension);

/// The azimuth of a bearing, which was decoded to `number`: its draw, if it is one, becomes one of the
/// azimuth.
Number azimuth_of(DecodeContext& context, const Node& bearing, const Number& number);

/// The parameters of a map, in the order of `specs`. Reports those that contradict each other.
std::vector<ParamValue> decode_params(DecodeContext& context, const Node& map,
                                      const std::vector<ParamSpec>& specs);

/// One decoded section.
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

/// A section of the schema.
Section decode_section(DecodeContext& context, const Node& node, std::string_view name);

/// The use of a plugin. Tries to make an instance. Nothing if there is no such plugin.
std::optional<PluginUse> decode_plugin(DecodeContext& context, const Node& node, PluginKind kind);

}  // namespace flyrock
