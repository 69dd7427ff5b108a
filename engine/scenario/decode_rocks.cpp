// Groups of rocks and bodies.

#include <fmt/format.h>

#include <algorithm>

#include "scenario/decode_sections.h"

namespace flyrock {

namespace {

constexpr NumberRules rock_rules{.varies = true, .scope = Scope::rock, .finest = Scope::rock};
constexpr NumberRules population_rules{.varies = true, .scope = Scope::trial, .finest = Scope::trial};
constexpr NumberRules body_rules{.varies = true, .scope = Scope::trial, .finest = Scope::trial};

/// Requires exactly one of density and mass; none is fine if `is_optional`.
void check_mass(DecodeContext& context, const Node& node, const Section& section, bool is_optional) {
  const bool density = section.given("density"), mass = section.given("mass");
  if (density && mass)
    context.diagnostics.error(node.key_at, node.path, "has both `density` and `mass`, expected one of them");
  if (!density && !mass && !is_optional)
    context.diagnostics.error(node.key_at, node.path, "`density` or `mass` is missing");
}

int decode_material(DecodeContext& context, const Node& node, const Section& section,
                    const std::vector<Material>& materials) {
  const std::optional<Node> material = node.find("material");
  return material && section.given("material") ? find_material(context, *material, materials) : -1;
}

/// In 3D: { axis, angle } or a quaternion [w, x, y, z].
std::optional<TurnPlan> decode_turn(DecodeContext& context, const Node& parent, const NumberRules& rules,
                                    Map& resolved) {
  const std::optional<Node> node = parent.find("orientation");
  if (!node) return std::nullopt;
  TurnPlan turn;
  const auto vanishes = [](const std::vector<Number>& numbers) {
    return std::all_of(numbers.begin(), numbers.end(),
                       [](const Number& n) { return n.is_constant() && n.constant == 0; });
  };
  if (node->value->map()) {
    Map map;
    const Section section = decode_section(context, *node, "orientation 3D", rules, map);
    turn.axis = section.vector("axis");
    turn.angle = section.number("angle");
    if (turn.axis.size() == 3 && vanishes(turn.axis))
      node->error(context.diagnostics, "`axis` has no direction");
    put(resolved, "orientation", map_value(std::move(map)));
    return turn;
  }
  const std::vector<Node> items = node->is_list() ? node->items() : std::vector<Node>();
  if (items.size() != 4) {
    node->error(context.diagnostics, "expected { axis: [x, y, z], angle } or a quaternion [w, x, y, z]");
    return std::nullopt;
  }
  ParamSpec component;
  component.name = "orientation";
  List list;
  for (const Node& item : items) {
    std::optional<DecodedNumber> decoded = decode_number(context, item, component, rules);
    turn.quaternion.push_back(decoded ? decoded->number : Number{1});
    if (decoded) list.push_back(std::move(decoded->resolved));
  }
  if (vanishes(turn.quaternion))
    node->error(context.diagnostics, "the quaternion is zero, which is no rotation");
  put(resolved, "orientation", list_value(std::move(list)));
  return turn;
}

std::optional<PluginUse> decode_part(DecodeContext& context, const Node& node, PluginKind kind,
                                     std::string_view key, const NumberRules& rules, Map& resolved) {
  const std::optional<Node> child = node.find(key);
  if (!child) return std::nullopt;
  Map map;
  std::optional<PluginUse> use = decode_plugin(context, *child, kind, rules, map);
  put(resolved, key, map_value(std::move(map)));
  return use;
}

/// The elevation of a launch that gives none and has no direction of its own either (`velocity` and
/// `drill_angle` are such directions).
std::optional<double> assumed_elevation(const Node& launch, const PluginSpec& spec) {
  constexpr double of_every_model = pi / 4;
  const int elevation = spec.find("elevation");
  if (elevation < 0 || launch.find("elevation") || launch.find("velocity") || launch.find("drill_angle"))
    return std::nullopt;
  return spec.params[elevation].default_number.value_or(of_every_model);
}

RockGroup decode_group(DecodeContext& context, const Node& node, const std::vector<Material>& materials,
                       const DecodedTerrain& terrain, Map& resolved) {
  const bool plane = context.dimension == 2;
  const SectionSpec& spec = section_spec(plane ? "rocks" : "rocks 3D");
  RockGroup group;
  const Section section(spec.keys, decode_params(context, node, spec.keys, rock_rules, resolved));
  group.name = section.text("name");
  if (const auto population = decode_plugin(context, node, PluginKind::population, population_rules, resolved,
                                            spec.key_names(), default_population))
    group.population = *population;
  check_mass(context, node, section, false);
  group.density = section.number("density");
  group.mass = section.optional_number("mass");
  if (plane) {
    group.thickness = section.optional_number("thickness");
    group.orientation = section.optional_number("orientation");
  } else {
    group.turn = decode_turn(context, node, rock_rules, resolved);
  }
  group.material = decode_material(context, node, section, materials);
  group.shape = decode_part(context, node, PluginKind::shape, "shape", rock_rules, resolved);
  if (const auto release = node.find("release")) {
    Map map;
    group.release = decode_release(context, *release, terrain, map);
    put(resolved, "release", map_value(std::move(map)));
  }
  group.launch = decode_part(context, node, PluginKind::velocity, "launch", rock_rules, resolved);
  if (group.launch)
    group.assumed_elevation = assumed_elevation(*node.find("launch"), group.launch->plugin->spec);
  if (group.population.plugin && group.population.plugin->spec.name == default_population)
    for (const char* key : {"shape", "release"})  // other populations may decide both
      if (!node.find(key))
        context.diagnostics.error(node.key_at, node.path, fmt::format("`{}` is missing", key));
  return group;
}

BodyPlan decode_body(DecodeContext& context, const Node& node, const std::vector<Material>& materials,
                     Map& resolved) {
  BodyPlan body;
  const bool plane = context.dimension == 2;
  const Section section = decode_section(context, node, plane ? "bodies" : "bodies 3D", body_rules, resolved);
  body.name = section.text("name");
  body.fixed = section.constant("fixed") != 0;
  if (const auto driven = node.find("driven")) {
    Map map;
    const Section motion = decode_section(context, driven, "bodies.driven", {}, map);
    BodyPlan::Driven& kept = body.driven.emplace();
    for (const Number& component : motion.vector("velocity")) kept.velocity.push_back(component.constant);
    for (const Number& component : motion.vector("spin")) kept.spin.push_back(component.constant);
    if (body.fixed) driven->error(context.diagnostics, "a body is either `fixed` or `driven`");
    put(resolved, "driven", map_value(std::move(map)));
  }
  check_mass(context, node, section, body.fixed || body.driven);
  body.density = section.optional_number("density");
  body.mass = section.optional_number("mass");
  body.position = section.vector("position");
  body.velocity = section.vector("velocity");
  if (body.velocity.empty()) body.velocity.assign(context.dimension, Number{});
  body.spin = section.vector("spin");
  if (plane) {
    body.thickness = section.optional_number("thickness");
    body.orientation = section.number("orientation");
  } else {
    body.turn = decode_turn(context, node, body_rules, resolved);
  }
  body.material = decode_material(context, node, section, materials);
  if (const auto shape = decode_part(context, node, PluginKind::shape, "shape", body_rules, resolved))
    body.shape = *shape;
  else if (!node.find("shape"))
    context.diagnostics.error(node.key_at, node.path, "`shape` is missing");
  return body;
}

void refuse_empty(DecodeContext& context, const Node& list) {
  if (list.value->list() && list.items().empty())
    list.error(context.diagnostics, "is empty, expected at least one element");
}

}  // namespace

void refuse_duplicate_names(DecodeContext& context, const Node& list) {
  std::map<std::string, int> line_of;
  for (const Node& item : list.items()) {
    const std::optional<Node> name = item.find("name");
    if (!name || !name->value->text()) continue;
    const auto [first, is_new] = line_of.emplace(*name->value->text(), name->value->at.line);
    if (is_new) continue;
    const std::string place = first->second > 0 ? fmt::format(" (line {})", first->second) : "";
    name->error(context.diagnostics,
                fmt::format("the name `{}` is taken by an earlier element{}", first->first, place));
  }
}

std::vector<RockGroup> decode_rocks(DecodeContext& context, const Node& node,
                                    const std::vector<Material>& materials, const DecodedTerrain& terrain,
                                    Map& resolved) {
  refuse_empty(context, node);
  return decode_list<RockGroup>(context, node, "rocks", resolved, [&](const Node& item, Map& map) {
    return decode_group(context, item, materials, terrain, map);
  });
}

std::vector<BodyPlan> decode_bodies(DecodeContext& context, const Node& node,
                                    const std::vector<Material>& materials, Map& resolved) {
  refuse_empty(context, node);
  return decode_list<BodyPlan>(context, node, "bodies", resolved, [&](const Node& item, Map& map) {
    return decode_body(context, item, materials, map);
  });
}

}  // namespace flyrock
