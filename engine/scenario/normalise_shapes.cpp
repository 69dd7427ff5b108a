#include "scenario/normalise_shapes.h"

#include <fmt/format.h>

#include "scenario/normalise_params.h"

namespace flyrock {

namespace {

constexpr std::size_t most_parts = 1000;

const SectionSpec& part_section(int dimension) {
  return section_spec(dimension == 2 ? "rocks.shape.parts" : "rocks.shape.parts 3D");
}

Value normalise_part(DecodeContext& context, const Node& node, const NumberRules& rules) {
  const SectionSpec& spec = part_section(context.dimension);
  Value part = normalise_plugin(context, node, PluginKind::shape, rules, {"at", "turn"});
  if (!part.map()) return {};
  for (const char* key : {"at", "turn"})
    if (part.find(key)) {
      node.error(context.diagnostics,
                 fmt::format("the shape has a parameter `{}` of its own, so it cannot be a part", key));
      return {};
    }
  put_all(*part.map(), normalise_params(context, node, spec.keys, rules));
  if (context.dimension == 3)
    if (const std::optional<Node> turn = node.find("turn"))
      put(*part.map(), *turn, normalise_turn(context, *turn, rules));
  return part;
}

}  // namespace

Value normalise_shapes(DecodeContext& context, const Node& node, const NumberRules& rules) {
  if (!node.expect_list(context.diagnostics)) return {};
  const std::vector<Node> items = node.items();
  if (items.empty() || items.size() > most_parts) {
    node.error(context.diagnostics, fmt::format("has {} parts, expected from 1 to {}: a list of shapes "
                                                "{{ type, ..., at, turn }}",
                                                items.size(), most_parts));
    return {};
  }
  List parts;
  for (const Node& item : items) {
    parts.push_back(normalise_part(context, item, rules));
    parts.back().at = item.value->at;
  }
  return list_value(std::move(parts));
}

Value normalise_turn(DecodeContext& context, const Node& node, const NumberRules& rules) {
  if (node.value->map()) return normalise_section(context, node, "orientation 3D", rules);
  const std::vector<Node> items = node.is_list() ? node.items() : std::vector<Node>();
  if (items.size() != 4) {
    node.error(context.diagnostics, "expected { axis: [x, y, z], angle } or a quaternion [w, x, y, z]");
    return {};
  }
  ParamSpec component;
  component.name = node.key;
  List list;
  for (const Node& item : items) list.push_back(normalise_number(context, item, component, rules));
  return list_value(std::move(list));
}

}  // namespace flyrock
