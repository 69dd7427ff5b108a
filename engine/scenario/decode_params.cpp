#include "scenario/decode_params.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "geometry/bearing.h"
#include "plugin/contact_law.h"
#include "scenario/decode_shapes.h"
#include "scenario/layer.h"
#include "scenario/load_table.h"
#include "scenario/normalise_params.h"
#include "scenario/param_bounds.h"
#include "survey/surveyed_terrain.h"

namespace flyrock {

namespace {

bool is_number_type(ParamType type) { return type == ParamType::number || type == ParamType::integer; }

Scope scope_named(const Value& per) {
  for (const Scope scope : {Scope::run, Scope::trial, Scope::hole, Scope::rock, Scope::impact})
    if (name_of(scope) == *per.text()) return scope;
  throw std::logic_error("no scope " + *per.text());
}

std::vector<double> point_of(const Value& value) {
  std::vector<double> point;
  for (const Value& coordinate : *value.list()) point.push_back(si_of(coordinate));
  return point;
}

/// A law of the tree; a number is the distribution of this one value.
Distribution law_of(const Value& value) {
  if (value.map()) return read_distribution(value);
  return {.kind = DistributionKind::discrete, .values = {si_of(value)}};
}

/// The value of one parameter that the tree has. One that is wrong has no numbers.
ParamValue decode_param(DecodeContext& context, const Node& node, const ParamSpec& spec) {
  ParamValue value;
  value.given = true;
  if (node.value->is_null()) return value;
  const std::string* text = node.value->text();
  switch (spec.type) {
    case ParamType::number:
    case ParamType::integer:
    case ParamType::spin:
    case ParamType::vector:
      if (text && std::find(spec.choices.begin(), spec.choices.end(), *text) != spec.choices.end())
        value.text = *text;
      else if (is_over_time(*node.value))
        for (const double start : start_of_table(*node.value, spec)) value.numbers.push_back({start, -1});
      else if (node.value->list())
        for (const Node& item : node.items())
          value.numbers.push_back(decode_number(context, item, spec.dimension));
      else
        value.numbers = {decode_number(context, node, spec.dimension)};
      break;
    case ParamType::boolean:
      value.numbers = {{*node.value->boolean() ? 1.0 : 0.0, -1}};
      break;
    case ParamType::choice:
    case ParamType::text:
      value.text = *text;
      break;
    case ParamType::file:
      value.text = (std::filesystem::path(context.folder) / *text).string();
      break;
    case ParamType::points:
    case ParamType::plan_points:
      if (is_layer(*node.value)) {
        if (spec.name != "polygon") value.points = layer_points(context, node, spec);
        break;  // zones read a polygon as a region
      }
      for (const Value& point : *node.value->list()) value.points.push_back(point_of(point));
      break;
    case ParamType::shapes:
      return decode_shapes(context, node);
    case ParamType::records:
      if (text) value.text = *text;
      for (const Node& item : node.value->list() ? node.items() : std::vector<Node>()) {
        value.records.push_back(decode_params(context, item, spec.fields));
        for (const ParamValue& field : value.records.back())
          value.numbers.insert(value.numbers.end(), field.numbers.begin(), field.numbers.end());
      }
      break;
    case ParamType::law:
      value.law = std::make_shared<const Distribution>(law_of(*node.value));
      break;
  }
  return value;
}

/// Makes an instance and drops it, because a plugin refuses contradicting parameters only when it is made.
void try_to_make(DecodeContext& context, const Node& node, const PluginUse& use) {
  auto make = [&]<class Interface>(const FactoryOf<Interface>&) {
    make_instance<Interface>(use, context.dimension);
  };
  try {
    std::visit(make, use.plugin->make);
  } catch (const FileFaults& found) {
    for (const std::string& wrong : found.faults) context.diagnostics.error(node.key_at, node.path, wrong);
  } catch (const PluginError& error) {
    context.diagnostics.error(node.key_at, node.path, error.what());
  }
}

}  // namespace

Number decode_number(DecodeContext& context, const Node& node, const Dimension& dimension) {
  if (!node.value->map()) return {si_of(*node.value), -1};
  context.draws.push_back({.path = node.path,
                           .stream = node.stream,
                           .distribution = read_distribution(*node.value),
                           .scope = scope_named(*node.value->find("per")),
                           .stream_hash = hash_name(node.stream),
                           .factor = 1,
                           .unit = si_unit(dimension),
                           .group = context.group});
  return {0, static_cast<int>(context.draws.size()) - 1};
}

/// The distribution of sum - x, where x has this one; nothing for a kind that is open on one side.
std::optional<Distribution> mirrored(Distribution x, double sum) {
  const auto turn = [&](double& low, double& high) {
    std::swap(low, high);
    low = sum - low;
    high = sum - high;
  };
  switch (x.kind) {
    case DistributionKind::uniform:
      turn(x.a, x.b);
      break;
    case DistributionKind::normal:
      x.a = sum - x.a;
      break;
    case DistributionKind::triangular:
      turn(x.a, x.c);
      x.b = sum - x.b;
      break;
    case DistributionKind::beta:
      std::swap(x.a, x.b);
      turn(x.c, x.d);
      break;
    case DistributionKind::discrete:
      for (double& value : x.values) value = sum - value;
      break;
    default:
      return std::nullopt;
  }
  turn(x.min, x.max);
  return x;
}

Number azimuth_of(DecodeContext& context, const Node& bearing, const Number& number) {
  if (number.is_constant()) return {azimuth_of_bearing(number.constant, context.north), -1};
  Draw& draw = context.draws[static_cast<std::size_t>(number.draw)];
  const auto azimuth = mirrored(draw.distribution, context.north);
  if (!azimuth) {
    bearing.error(context.diagnostics,
                  fmt::format("takes no distribution `{}`, expected uniform, normal, triangular, "
                              "beta or discrete; or write the `azimuth`",
                              name_of(draw.distribution.kind)));
    return number;
  }
  draw.distribution = *azimuth;
  for (std::string* name : {&draw.path, &draw.stream})
    name->replace(name->rfind('.') + 1, std::string::npos, "azimuth");
  draw.stream_hash = hash_name(draw.stream);
  return number;
}

std::vector<ParamValue> decode_params(DecodeContext& context, const Node& map,
                                      const std::vector<ParamSpec>& specs) {
  std::vector<ParamValue> values(specs.size());
  std::vector<bool> decoded(specs.size(), false);
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const ParamSpec& spec = specs[i];
    const std::optional<Node> parent = spec.group().empty() ? map : map.find(spec.group());
    const std::optional<Node> node = parent ? parent->find(spec.own_name()) : std::nullopt;
    if (node)
      values[i] =
          decode_param(context, *node, spec.unit_exponent.empty() ? spec : with_exponent(spec, specs, map));
    decoded[i] = !values[i].numbers.empty();
    if (node && is_number_type(spec.type) && values[i].numbers.empty()) values[i].numbers = {Number{}};
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

Section decode_section(DecodeContext& context, const Node& node, std::string_view name) {
  const std::vector<ParamSpec>& specs = section_spec(name).keys;
  return {specs, decode_params(context, node, specs)};
}

std::optional<PluginUse> decode_plugin(DecodeContext& context, const Node& node, PluginKind kind) {
  const std::optional<Node> type = node.find("type");
  if (!type || !type->value->text()) return std::nullopt;
  PluginUse use;
  use.plugin = context.registry.find(kind, *type->value->text());
  use.path = node.path;
  const std::size_t errors = context.diagnostics.errors_given();
  use.values = decode_params(context, node, use.plugin->spec.params);
  if (const auto bearing = node.find("bearing"); bearing && bearing_beside(use.plugin->spec.params)) {
    ParamValue& azimuth = use.values[static_cast<std::size_t>(use.plugin->spec.find("azimuth"))];
    azimuth.given = true;
    azimuth.numbers = {azimuth_of(context, *bearing, decode_number(context, *bearing, dimension::angle))};
  }
  use.slots = dense_slots(use.values);
  if (context.is_sound(node.path) && context.diagnostics.errors_given() == errors)
    try_to_make(context, node, use);
  return use;
}

}  // namespace flyrock
