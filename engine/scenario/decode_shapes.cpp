#include "scenario/decode_shapes.h"

#include <algorithm>
#include <span>

#include "scenario/decode_params.h"

namespace flyrock {

namespace {

bool vanishes(std::span<const Number> numbers) {
  return std::all_of(numbers.begin(), numbers.end(),
                     [](const Number& n) { return n.is_constant() && n.constant == 0; });
}

template <class Numbers>
void append(ParamValue& value, const Numbers& numbers) {
  value.numbers.insert(value.numbers.end(), numbers.begin(), numbers.end());
}

/// The turn of a part in 3D; without one the quaternion of no turn.
TurnPlan turn_of_part(DecodeContext& context, const Node& part) {
  const std::optional<Node> node = part.find("turn");
  if (node && !node->value->is_null()) return decode_turn(context, *node);
  return {.numbers = {Number{1}, {}, {}, {}}, .about_axis = false};
}

}  // namespace

ParamValue decode_shapes(DecodeContext& context, const Node& node) {
  ParamValue value;
  value.given = true;
  std::vector<ShapePart> parts;
  for (const Node& item : node.items()) {
    if (item.value->is_null()) continue;
    const std::optional<PluginUse> shape = decode_plugin(context, item, PluginKind::shape);
    if (!shape) continue;
    ShapePart& part = parts.emplace_back();
    part.shape = *shape;
    const Section place =
        decode_section(context, item, context.dimension == 2 ? "rocks.shape.parts" : "rocks.shape.parts 3D");
    append(value, place.vector("at"));
    if (context.dimension == 2) {
      value.numbers.push_back(place.number("turn"));
    } else {
      const TurnPlan turn = turn_of_part(context, item);
      part.about_axis = turn.about_axis;
      append(value, turn.numbers);
    }
    append(value, shape->slots);
  }
  value.parts = std::make_shared<const std::vector<ShapePart>>(std::move(parts));
  return value;
}

TurnPlan decode_turn(DecodeContext& context, const Node& node) {
  TurnPlan turn;
  if (node.value->map()) {
    const Section section = decode_section(context, node, "orientation 3D");
    const std::vector<Number>& axis = section.vector("axis");
    turn.about_axis = true;
    if (axis.size() == 3) std::copy(axis.begin(), axis.end(), turn.numbers.begin());
    turn.numbers[3] = section.number("angle");
    if (axis.size() == 3 && vanishes(axis)) node.error(context.diagnostics, "`axis` has no direction");
    return turn;
  }
  const std::vector<Node> items = node.items();
  for (std::size_t k = 0; k < turn.numbers.size(); ++k)
    turn.numbers[k] =
        items[k].value->is_null() ? Number{1} : decode_number(context, items[k], dimension::none);
  if (vanishes(turn.numbers))
    node.error(context.diagnostics, "the quaternion is zero, which is not a rotation");
  return turn;
}

}  // namespace flyrock
