#include "scenario/normalise_params.h"

#include <fmt/format.h>

#include <algorithm>

#include "plugin/gain.h"
#include "scenario/load_table.h"
#include "scenario/normalise_param.h"
#include "units/units.h"

namespace flyrock {

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

/// The normalised map of a group, after the parameters before it.
Map& normalised_group(Map& map, const Node& parent) {
  if (map.empty() || map.back().key != parent.key) put(map, parent, map_value({}));
  return *map.back().value.map();
}

/// The parameters of a plugin as this use of it has them: without the limits that its `allow_gain` lifts.
std::vector<ParamSpec> params_here(const Node& use, const PluginSpec& spec) {
  std::vector<ParamSpec> params = spec.params;
  const std::optional<Node> given = use.find(allow_gain);
  const bool* allows = given ? given->value->boolean() : nullptr;
  for (ParamSpec& param : params)
    if (allows && *allows && is_limit_of_gain(spec, param)) param.max.reset();
  if (auto bearing = bearing_beside(params)) params.push_back(std::move(*bearing));
  return params;
}

/// The plugin that a map names, or of the type `type` if it names none; null if there is none, which is
/// reported.
const Plugin* find_plugin(DecodeContext& context, const Node& node, PluginKind kind, std::string type) {
  const std::vector<std::string> known = context.registry.names(kind);
  const std::optional<Node> given = node.find("type");
  if (given) {
    const std::string* text = given->value->text();
    if (!text) {
      given->error(context.diagnostics,
                   fmt::format("expected the name of a {}, found {}", name_of(kind), shown(*given->value)));
      return nullptr;
    }
    type = *text;
  } else if (type.empty()) {
    context.diagnostics.error(node.key_at, node.path,
                              fmt::format("`type` is missing, expected {}", choice_text(known)));
    return nullptr;
  }
  const Plugin* plugin = context.registry.find(kind, type);
  if (!plugin && !(given && context.earlier_errors))
    (given ? *given : node)
        .error(context.diagnostics,
               fmt::format("unknown {} `{}`{}", name_of(kind), type, suggestion(type, known)));
  return plugin;
}

}  // namespace

std::optional<ParamSpec> bearing_beside(const std::vector<ParamSpec>& params) {
  const auto azimuth = std::find_if(params.begin(), params.end(), [](const ParamSpec& one) {
    return one.name == "azimuth" && one.type == ParamType::number && one.dimension == dimension::angle;
  });
  if (azimuth == params.end()) return std::nullopt;
  ParamSpec bearing;
  bearing.name = "bearing";
  bearing.unit = azimuth->unit;
  bearing.dimension = dimension::angle;
  bearing.optional = true;
  bearing.min = -2 * pi;
  bearing.max = 2 * pi;
  bearing.doc = "in place of `azimuth`: clockwise from north";
  return bearing;
}

ParamSpec with_exponent(const ParamSpec& spec, const std::vector<ParamSpec>& specs, const Node& map) {
  ParamSpec result = spec;
  const auto other = std::find_if(specs.begin(), specs.end(),
                                  [&](const ParamSpec& one) { return one.name == spec.unit_exponent; });
  const std::optional<Node> node = map.find(spec.unit_exponent);
  const double* given = node ? node->value->number() : nullptr;
  const double exponent = given ? *given : node ? 1 : other->default_number.value_or(1);
  const std::string unit = spec.unit + "^" + shortest(exponent);
  const std::optional<Unit> parsed = parse_unit(unit);
  const bool is_allowed =
      parsed && limit_fault(*other, exponent, exponent).empty();  // else that is the error
  if (exponent == 1 || !is_allowed) return result;
  result.unit = unit;
  result.dimension = parsed->dimension;
  return result;
}

Map normalise_params(DecodeContext& context, const Node& map, const std::vector<ParamSpec>& specs,
                     const NumberRules& rules) {
  Map normalised;
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const ParamSpec& spec = specs[i];
    const bool is_grouped = !spec.group().empty();
    const std::optional<Node> parent = is_grouped ? find_group(context, map, specs, i) : map;
    if (!parent) continue;
    const std::optional<Node> node = parent->find(spec.own_name());
    std::optional<Value> by_default = node ? std::nullopt : default_value(spec, context.dimension);
    if (!node && spec.required_in(context.dimension))
      context.diagnostics.error(
          parent->key_at, parent->path,
          fmt::format("`{}` is missing, expected {}", spec.own_name(), expected_text(spec)));
    if (!node && !by_default) continue;
    Map& to = is_grouped ? normalised_group(normalised, *parent) : normalised;
    if (node && spec.name == rules.over_time && is_over_time(*node->value)) {
      put(to, *node, normalise_over_time(context, *node, spec));
    } else if (node) {
      put(to, *node,
          normalise_param(context, *node, spec.unit_exponent.empty() ? spec : with_exponent(spec, specs, map),
                          rules));
    } else {
      by_default->assumed = true;
      put(to, spec.own_name(), std::move(*by_default));
    }
  }
  return normalised;
}

Value normalise_section(DecodeContext& context, const std::optional<Node>& node, std::string_view name,
                        const NumberRules& rules) {
  static const Value nothing = map_value({});
  const SectionSpec& spec = section_spec(name);
  const Node map =
      node ? *node : Node{&nothing, Location{}, std::string(name), std::string(name), std::string(name)};
  const SoundnessOf soundness(context, map.path);
  if (!map.expect_map(context.diagnostics)) return {};
  map.refuse_unknown_keys(spec.key_names(), context.diagnostics);
  return map_value(normalise_params(context, map, spec.keys, rules));
}

Value normalise_plugin(DecodeContext& context, const Node& node, PluginKind kind, const NumberRules& rules,
                       const std::vector<std::string>& others, std::string_view default_type) {
  if (!node.expect_map(context.diagnostics)) return {};
  const Plugin* plugin = find_plugin(context, node, kind, std::string(default_type));
  Map map;
  const std::optional<Node> type = node.find("type");
  Value name = plugin ? text_value(plugin->spec.name) : Value{};
  if (type)
    put(map, *type, std::move(name));
  else
    put(map, "type", std::move(name));
  if (plugin) {
    std::vector<std::string> keys{"type"};
    for (const ParamSpec& spec : plugin->spec.params)
      keys.emplace_back(spec.group().empty() ? spec.own_name() : spec.group());
    if (bearing_beside(plugin->spec.params)) keys.emplace_back("bearing");
    keys.insert(keys.end(), others.begin(), others.end());
    if (const auto bearing = node.find("bearing"); bearing && node.find("azimuth"))
      bearing->error(context.diagnostics, "says the same as `azimuth`, expected one of them");
    node.refuse_unknown_keys(keys, context.diagnostics);
    const SoundnessOf soundness(context, node.path);
    NumberRules of_plugin = rules;
    of_plugin.limits_gain = plugin->spec.find(allow_gain) >= 0;
    put_all(map, normalise_params(context, node, params_here(node, plugin->spec), of_plugin));
  }
  Value use = map_value(std::move(map));
  use.at = node.value->at;
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

void check_name(DecodeContext& context, const Node& node) {
  const std::string* text = node.value->text();  // anything else is already reported
  if (text && !is_name(*text))
    node.error(context.diagnostics, fmt::format("{} is not a name, {}", shown(*node.value), name_rule));
}

void check_key(DecodeContext& context, const Node& node) {
  if (!is_name(node.key))
    context.diagnostics.error(node.key_at, node.path,
                              fmt::format("`{}` is not a name, {}", node.key, name_rule));
}

}  // namespace flyrock
