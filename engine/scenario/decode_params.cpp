#include "scenario/decode_params.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "geometry/contactor.h"

namespace flyrock {

namespace {

bool is_number_type(ParamType type) { return type == ParamType::number || type == ParamType::integer; }

void refuse(DecodeContext& context, const Node& node, const ParamSpec& spec) {
  const std::string expected = expected_text(spec);
  if (node.value->is_null()) return node.error(context.diagnostics, "is empty, expected " + expected);
  const bool is_name = spec.type == ParamType::choice && node.value->text();
  const std::string nearest = is_name ? nearest_name(*node.value->text(), spec.choices) : std::string();
  const std::string hint = nearest.empty() ? "" : fmt::format(", did you mean `{}`?", nearest);
  node.error(context.diagnostics, fmt::format("expected {}, found {}{}", expected, shown(*node.value), hint));
}

void decode_boolean(DecodeContext& context, const Node& node, const ParamSpec& spec, ParamValue& value,
                    Value& resolved) {
  const bool* boolean = node.value->boolean();
  if (!boolean) return refuse(context, node, spec);
  value.numbers = {{*boolean ? 1.0 : 0.0, -1}};
  resolved.data = *boolean;
}

/// A choice of `off` and `on` may also be written as false and true, as in Lua.
void decode_choice(DecodeContext& context, const Node& node, const ParamSpec& spec, ParamValue& value,
                   Value& resolved) {
  std::string text;
  if (const bool* boolean = node.value->boolean()) text = *boolean ? "on" : "off";
  if (node.value->text()) text = *node.value->text();
  if (std::find(spec.choices.begin(), spec.choices.end(), text) == spec.choices.end())
    return refuse(context, node, spec);
  value.text = text;
  resolved = text_value(text);
}

void decode_text(DecodeContext& context, const Node& node, const ParamSpec& spec, ParamValue& value,
                 Value& resolved) {
  const std::string* text = node.value->text();
  if (!text || (text->empty() && spec.required())) return refuse(context, node, spec);
  value.text = *text;
  resolved = text_value(*text);
}

void decode_file(DecodeContext& context, const Node& node, const ParamSpec& spec, ParamValue& value,
                 Value& resolved) {
  const std::string* name = node.value->text();
  if (!name || name->empty()) return refuse(context, node, spec);
  const std::filesystem::path path = std::filesystem::path(context.folder) / *name;
  if (!std::filesystem::is_regular_file(path))
    return node.error(context.diagnostics, fmt::format("there is no file `{}` beside the scenario", *name));
  value.text = path.string();
  context.files[*name] = value.text;
  resolved = text_value(*name);
}

void decode_vector(DecodeContext& context, const Node& node, const ParamSpec& spec, const NumberRules& rules,
                   ParamValue& value, Value& resolved) {
  if (!node.is_list() || node.value->is_null()) return refuse(context, node, spec);
  const std::vector<Node> items = node.items();
  if (static_cast<int>(items.size()) != context.dimension)
    return node.error(context.diagnostics, fmt::format("has {} components, expected {} in {}D", items.size(),
                                                       context.dimension, context.dimension));
  ParamSpec component = spec;
  component.type = ParamType::number;
  List list;
  for (const Node& item : items) {
    std::optional<DecodedNumber> decoded = decode_number(context, item, component, rules);
    value.numbers.push_back(decoded ? decoded->number : Number{});
    if (decoded) list.push_back(std::move(decoded->resolved));
  }
  resolved = list_value(std::move(list));
}

/// A point [x, y]; empty where it is wrong, which was then reported.
std::vector<double> decode_point(DecodeContext& context, const Node& node, const ParamSpec& spec) {
  const std::vector<Node> items = node.items();
  if (static_cast<int>(items.size()) != context.dimension) {
    node.error(context.diagnostics, fmt::format("expected a point of {} coordinates", context.dimension));
    return {};
  }
  ParamSpec coordinate = spec;
  coordinate.type = ParamType::number;
  std::vector<double> point;
  for (const Node& item : items)
    if (auto si = decode_quantity(context, item, spec.dimension, {}, expected_text(coordinate)))
      point.push_back(*si);
  return point.size() == items.size() ? point : std::vector<double>();
}

/// The corners of a polygon of space in its own plane; empty where they span none or leave it by more than a millionth of
/// its size.
std::vector<Vec2> flattened(const std::vector<std::vector<double>>& points) {
  std::vector<Vec3> corners;
  for (const std::vector<double>& point : points) corners.emplace_back(point[0], point[1], point[2]);
  Vec3 twice_area = Vec3::Zero();
  double size = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    twice_area += (corners[i] - corners[0]).cross(corners[(i + 1) % corners.size()] - corners[0]);
    size = std::max(size, (corners[i] - corners[0]).norm());
  }
  if (twice_area.norm() <= 1e-12 * size * size) return {};
  const Vec3 normal = twice_area.normalized();
  const Eigen::Matrix3d frame = contact_frame(normal);
  std::vector<Vec2> flat;
  for (const Vec3& corner : corners) {
    const Vec3 p = frame.transpose() * (corner - corners[0]);
    if (std::abs(p[0]) > 1e-6 * size) return {};
    flat.emplace_back(p[1], p[2]);
  }
  return flat;
}

/// What is wrong with points as the outline of a convex polygon, or an empty text.
std::string outline_fault(const std::vector<std::vector<double>>& points, int dimension) {
  std::vector<Vec2> vertices;
  if (dimension == 2)
    for (const std::vector<double>& point : points) vertices.emplace_back(point[0], point[1]);
  else if (vertices = flattened(points); vertices.empty())
    return "expected the corners of a polygon that lie in one plane and not on one line";
  return make_convex(vertices);
}

/// Points. Those of a parameter called `inside`, and in 2D `vertices`, are the outline of a convex polygon, wherever
/// it stands: what is wrong with it is said here, where its place in the file is known.
void decode_points(DecodeContext& context, const Node& node, const ParamSpec& spec, ParamValue& value,
                   Value& resolved) {
  if (!node.is_list() || node.value->is_null()) return refuse(context, node, spec);
  List list;
  bool good = true;
  for (const Node& item : node.items()) {
    std::vector<double> point = decode_point(context, item, spec);
    good = good && !point.empty();
    List coordinates;
    for (double coordinate : point) coordinates.push_back(number_value(coordinate, spec.dimension));
    list.push_back(list_value(std::move(coordinates)));
    value.points.push_back(std::move(point));
  }
  if (good && (spec.name == "inside" || (spec.name == "vertices" && context.dimension == 2)))
    if (const std::string fault = outline_fault(value.points, context.dimension); !fault.empty())
      node.error(context.diagnostics, fault);
  resolved = list_value(std::move(list));
}

void decode_param(DecodeContext& context, const Node& node, const ParamSpec& spec, const NumberRules& rules,
                  ParamValue& value, Value& resolved) {
  value.given = true;
  switch (spec.type) {
    case ParamType::spin:
      if (context.dimension == 3) return decode_vector(context, node, spec, rules, value, resolved);
      [[fallthrough]];
    case ParamType::number:
    case ParamType::integer:
      if (std::optional<DecodedNumber> decoded = decode_number(context, node, spec, rules)) {
        value.numbers = {decoded->number};
        resolved = std::move(decoded->resolved);
      }
      return;
    case ParamType::boolean:
      return decode_boolean(context, node, spec, value, resolved);
    case ParamType::choice:
      return decode_choice(context, node, spec, value, resolved);
    case ParamType::text:
      return decode_text(context, node, spec, value, resolved);
    case ParamType::file:
      return decode_file(context, node, spec, value, resolved);
    case ParamType::vector:
      return decode_vector(context, node, spec, rules, value, resolved);
    case ParamType::points:
      return decode_points(context, node, spec, value, resolved);
  }
}

/// The default of a parameter that was not written; false where it has none.
bool take_default(const ParamSpec& spec, int dimension, ParamValue& value, Value& resolved) {
  if (spec.default_number && spec.type == ParamType::spin && dimension == 3) {
    value.numbers.assign(3, {*spec.default_number, -1});
    resolved = list_value(List(3, number_value(*spec.default_number, spec.dimension)));
  } else if (spec.default_number) {
    value.numbers = {{*spec.default_number, -1}};
    resolved = number_value(*spec.default_number, spec.dimension);
    if (spec.type == ParamType::boolean) resolved.data = *spec.default_number != 0;
  } else if (spec.default_text) {
    value.text = *spec.default_text;
    resolved = text_value(*spec.default_text);
  } else if (spec.default_vector) {
    List list;
    for (double component : *spec.default_vector) {
      value.numbers.push_back({component, -1});
      list.push_back(number_value(component, spec.dimension));
    }
    resolved = list_value(std::move(list));
  } else {
    return false;
  }
  value.given = true;
  return true;
}

/// Makes an instance and drops it: a plugin refuses parameters that contradict each other when it is made.
void try_to_make(DecodeContext& context, const Node& node, const PluginUse& use) {
  auto make = [&]<class Interface>(const FactoryOf<Interface>&) {
    make_instance<Interface>(use, context.dimension);
  };
  try {
    std::visit(make, use.plugin->make);
  } catch (const PluginError& error) {
    context.diagnostics.error(node.key_at, node.path, error.what());
  }
}

}  // namespace

std::vector<ParamValue> decode_params(DecodeContext& context, const Node& map,
                                      const std::vector<ParamSpec>& specs, const NumberRules& rules,
                                      Map& resolved) {
  std::vector<ParamValue> values(specs.size());
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const ParamSpec& spec = specs[i];
    Value shown_value;
    if (const std::optional<Node> node = map.find(spec.name))
      decode_param(context, *node, spec, rules, values[i], shown_value);
    else if (spec.required())
      context.diagnostics.error(map.key_at, map.path,
                                fmt::format("`{}` is missing, expected {}", spec.name, expected_text(spec)));
    else if (!take_default(spec, context.dimension, values[i], shown_value))
      continue;
    put(resolved, spec.name, std::move(shown_value));
    if (is_number_type(spec.type) && values[i].numbers.empty()) values[i].numbers = {Number{}};
  }
  return values;
}

const ParamValue& Section::at(std::string_view name) const {
  for (std::size_t i = 0; i < specs_.size(); ++i)
    if (specs_[i].name == name) return values_[i];
  throw std::logic_error("no key " + std::string(name));
}

Number Section::number(std::string_view name) const {
  const ParamValue& value = at(name);
  return value.numbers.empty() ? Number{} : value.numbers.front();
}

std::optional<Number> Section::optional_number(std::string_view name) const {
  return given(name) ? std::optional<Number>(number(name)) : std::nullopt;
}

std::vector<Vec3> Section::points(std::string_view name) const {
  std::vector<Vec3> list;
  for (const std::vector<double>& point : at(name).points)
    if (!point.empty()) list.emplace_back(point[0], point[1], point.size() > 2 ? point[2] : 0);
  return list;
}

Section decode_section(DecodeContext& context, const std::optional<Node>& node, std::string_view name,
                       const NumberRules& rules, Map& resolved) {
  static const Value nothing = map_value({});
  const SectionSpec& spec = section_spec(name);
  const Node map = node ? *node : Node{&nothing, {}, std::string(name), std::string(name), std::string(name)};
  if (map.expect_map(context.diagnostics)) {
    map.refuse_unknown_keys(spec.key_names(), context.diagnostics);
    return {spec.keys, decode_params(context, map, spec.keys, rules, resolved)};
  }
  return {spec.keys, std::vector<ParamValue>(spec.keys.size())};
}

std::optional<PluginUse> decode_plugin(DecodeContext& context, const Node& node, PluginKind kind,
                                       const NumberRules& rules, Map& resolved,
                                       const std::vector<std::string>& others,
                                       std::string_view default_type) {
  if (!node.expect_map(context.diagnostics)) return std::nullopt;
  const std::vector<std::string> known = context.registry.names(kind);
  std::string type(default_type);
  if (const std::optional<Node> child = node.find("type")) {
    const std::string* text = child->value->text();
    if (!text) {
      child->error(context.diagnostics,
                   fmt::format("expected the name of a {}, found {}", name_of(kind), shown(*child->value)));
      return std::nullopt;
    }
    type = *text;
    if (!context.registry.find(kind, type)) {
      if (!context.a_plugin_failed)
        child->error(context.diagnostics,
                     fmt::format("unknown {} `{}`{}", name_of(kind), type, suggestion(type, known)));
      return std::nullopt;
    }
  } else if (type.empty()) {
    context.diagnostics.error(node.key_at, node.path,
                              fmt::format("`type` is missing, expected {}", choice_text(known)));
    return std::nullopt;
  }
  const Plugin* plugin = context.registry.find(kind, type);
  if (!plugin) {
    node.error(context.diagnostics,
               fmt::format("unknown {} `{}`{}", name_of(kind), type, suggestion(type, known)));
    return std::nullopt;
  }
  std::vector<std::string> keys{"type"};
  for (const ParamSpec& spec : plugin->spec.params) keys.push_back(spec.name);
  keys.insert(keys.end(), others.begin(), others.end());
  node.refuse_unknown_keys(keys, context.diagnostics);

  PluginUse use;
  use.plugin = plugin;
  use.path = node.path;
  put(resolved, "type", text_value(type));
  const std::size_t messages = context.diagnostics.all().size();
  use.values = decode_params(context, node, plugin->spec.params, rules, resolved);
  use.slots = dense_slots(use.values);
  if (context.diagnostics.all().size() == messages) try_to_make(context, node, use);
  return use;
}

namespace {

bool is_name(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

constexpr const char* name_rule = "expected letters, digits, `_` and `-`";

}  // namespace

bool check_name(DecodeContext& context, const Node& node) {
  const std::string* text = node.value->text();
  if (!text) return false;  // reported as not being text
  if (is_name(*text)) return true;
  node.error(context.diagnostics, fmt::format("{} is not a name, {}", shown(*node.value), name_rule));
  return false;
}

bool check_key(DecodeContext& context, const Node& node) {
  if (is_name(node.key)) return true;
  context.diagnostics.error(node.key_at, node.path, fmt::format("`{}` is not a name, {}", node.key, name_rule));
  return false;
}

}  // namespace flyrock
