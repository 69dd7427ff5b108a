#include "scenario/decode_params.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "scenario/decode_param.h"
#include "scenario/param_bounds.h"

namespace flyrock {

namespace {

bool is_number_type(ParamType type) { return type == ParamType::number || type == ParamType::integer; }

/// Makes an instance and drops it, because a plugin refuses contradicting parameters only when it is made.
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

namespace {

/// The map of a group of parameters; nothing if it is not given, or is no map, which is reported at the first
/// of its parameters.
std::optional<Node> find_group(DecodeContext& context, const Node& map, const std::vector<ParamSpec>& specs,
                               std::size_t i) {
  const std::string_view group = specs[i].group();
  std::optional<Node> node = map.find(group);
  if (!node) return std::nullopt;
  if (i > 0 && specs[i - 1].group() == group) return node->is_map() ? node : std::nullopt;
  if (!node->expect_map(context.diagnostics)) return std::nullopt;
  std::vector<std::string> names;
  for (const ParamSpec& spec : specs)
    if (spec.group() == group) names.emplace_back(spec.own_name());
  node->refuse_unknown_keys(names, context.diagnostics);
  return node;
}

/// The resolved map of a group, after the parameters before it.
Map& resolved_group(Map& resolved, std::string_view group) {
  if (resolved.empty() || resolved.back().key != group) put(resolved, group, map_value({}));
  return std::get<Map>(resolved.back().value.data);
}

}  // namespace

std::vector<ParamValue> decode_params(DecodeContext& context, const Node& map,
                                      const std::vector<ParamSpec>& specs, const NumberRules& rules,
                                      Map& resolved) {
  std::vector<ParamValue> values(specs.size());
  std::vector<bool> decoded(specs.size(), false);
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const ParamSpec& spec = specs[i];
    const bool is_grouped = !spec.group().empty();
    const std::optional<Node> parent = is_grouped ? find_group(context, map, specs, i) : map;
    if (!parent) continue;
    Value shown_value;
    if (const std::optional<Node> node = parent->find(spec.own_name()))
      decode_param(context, *node, spec, rules, values[i], shown_value);
    else if (spec.required())
      context.diagnostics.error(
          parent->key_at, parent->path,
          fmt::format("`{}` is missing, expected {}", spec.own_name(), expected_text(spec)));
    else if (!take_default(spec, context.dimension, values[i], shown_value))
      continue;
    put(is_grouped ? resolved_group(resolved, spec.group()) : resolved, spec.own_name(),
        std::move(shown_value));
    decoded[i] = !values[i].numbers.empty();
    if (is_number_type(spec.type) && values[i].numbers.empty()) values[i].numbers = {Number{}};
  }
  check_bounds(context, map, specs, values, decoded);
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
  for (const ParamSpec& spec : plugin->spec.params)
    keys.emplace_back(spec.group().empty() ? spec.own_name() : spec.group());
  keys.insert(keys.end(), others.begin(), others.end());
  node.refuse_unknown_keys(keys, context.diagnostics);

  PluginUse use;
  use.plugin = plugin;
  use.path = node.path;
  put(resolved, "type", text_value(type));
  const std::size_t errors = context.diagnostics.errors_given();
  use.values = decode_params(context, node, plugin->spec.params, rules, resolved);
  use.slots = dense_slots(use.values);
  if (context.diagnostics.errors_given() == errors) try_to_make(context, node, use);
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
  if (!text) return false;  // already reported
  if (is_name(*text)) return true;
  node.error(context.diagnostics, fmt::format("{} is not a name, {}", shown(*node.value), name_rule));
  return false;
}

bool check_key(DecodeContext& context, const Node& node) {
  if (is_name(node.key)) return true;
  context.diagnostics.error(node.key_at, node.path,
                            fmt::format("`{}` is not a name, {}", node.key, name_rule));
  return false;
}

}  // namespace flyrock
