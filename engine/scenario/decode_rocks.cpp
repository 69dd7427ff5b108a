// Groups of rocks and bodies.

#include "document/value.h"
#include "scenario/decode_sections.h"
#include "scenario/decode_shapes.h"
#include "scenario/load_table.h"

namespace flyrock {

namespace {

int decode_material(DecodeContext& context, const Node& node, const std::vector<Material>& materials) {
  const std::optional<Node> material = node.find("material");
  return material ? find_material(context, *material, materials) : -1;
}

std::optional<TurnPlan> decode_orientation(DecodeContext& context, const Node& parent) {
  const std::optional<Node> node = parent.find("orientation");
  if (!node || node->value->is_null()) return std::nullopt;
  return decode_turn(context, *node);
}

std::optional<PluginUse> decode_part(DecodeContext& context, const Node& node, PluginKind kind,
                                     std::string_view key) {
  const std::optional<Node> child = node.find(key);
  return child ? decode_plugin(context, *child, kind) : std::nullopt;
}

/// The elevation of a launch that gives none and has no direction of its own either (`velocity` and
/// `drill_angle` are such directions).
std::optional<double> assumed_elevation(const Node& launch, const PluginSpec& spec) {
  constexpr double of_every_model = pi / 4;
  const int elevation = spec.find("elevation");
  if (elevation < 0) return std::nullopt;
  for (const char* key : {"elevation", "velocity", "drill_angle"})
    if (find_given(launch, key)) return std::nullopt;
  return spec.params[elevation].default_number.value_or(of_every_model);
}

/// Whether the shape has the lengths of a table, and no plugin says it.
bool has_lengths_of_table(const Node& group) {
  const std::optional<Node> shape = group.find("shape");
  const Value* type = shape ? shape->value->find("type") : nullptr;
  return type && type->text() && *type->text() == from_lengths;
}

/// The first slot of a parameter of a plugin.
int slot_of(const PluginUse& use, std::string_view name) {
  const int index = use.plugin->spec.find(name);
  if (index < 0) return -1;
  std::vector<ParamValue> before(use.values.begin(), use.values.begin() + index);
  return static_cast<int>(dense_slots(before).size());
}

LaunchBySize decode_launch_by_size(DecodeContext& context, const Node& node) {
  const Section section = decode_section(context, node, "rocks.launch_by_size");
  return {.reference = section.number("reference"),
          .exponent = section.number("exponent"),
          .at_most = section.optional_number("at_most")};
}

RockGroup decode_group(DecodeContext& context, const Node& node, const std::vector<Material>& materials,
                       const DecodedTerrain& terrain) {
  const bool plane = context.dimension == 2;
  const Section section = decode_section(context, node, plane ? "rocks" : "rocks 3D");
  RockGroup group;
  group.name = section.text("name");
  if (section.given("weight")) group.weight = section.constant("weight");
  if (const auto population = decode_plugin(context, node, PluginKind::population))
    group.population = *population;
  group.density = section.number("density");
  group.mass = section.optional_number("mass");
  if (plane) {
    group.thickness = section.optional_number("thickness");
    group.orientation = section.optional_number("orientation");
  } else {
    group.turn = decode_orientation(context, node);
  }
  group.material = decode_material(context, node, materials);
  if (const auto air = node.find("air"); air && air->value->map()) group.air = decode_air(context, *air);
  if (section.given("table")) group.table = decode_rock_table(context, node, section);
  if (!has_lengths_of_table(node)) group.shape = decode_part(context, node, PluginKind::shape, "shape");
  if (const auto release = node.find("release")) group.release = decode_release(context, *release, terrain);
  if (section.given("per_hole")) {
    group.per_hole = section.integer("per_hole");
    if (!group.release) group.release.emplace().kind = ReleaseKind::collar;
  }
  group.launch = decode_part(context, node, PluginKind::velocity, "launch");
  if (const auto by_size = node.find("launch_by_size"))
    group.launch_by_size = decode_launch_by_size(context, *by_size);
  if (group.launch && node.find("launch")->find("bearing"))
    group.absolute_azimuth = slot_of(*group.launch, "azimuth");
  if (group.launch)
    group.assumed_elevation = assumed_elevation(*node.find("launch"), group.launch->plugin->spec);
  return group;
}

BodyPlan decode_body(DecodeContext& context, const Node& node, const std::vector<Material>& materials) {
  BodyPlan body;
  const bool plane = context.dimension == 2;
  const Section section = decode_section(context, node, plane ? "bodies" : "bodies 3D");
  body.name = section.text("name");
  body.fixed = section.constant("fixed") != 0;
  if (const auto driven = node.find("driven")) {
    const Section motion = decode_section(context, *driven, "bodies.driven");
    BodyPlan::Driven& kept = body.driven.emplace();
    for (const Number& component : motion.vector("velocity")) kept.velocity.push_back(component.constant);
    for (const Number& component : motion.vector("spin")) kept.spin.push_back(component.constant);
    for (const Number& component : motion.vector("acceleration"))
      kept.acceleration.push_back(component.constant);
    if (body.fixed) driven->error(context.diagnostics, "a body is either `fixed` or `driven`");
    body.over_time = decode_over_time(driven->find("velocity"));
    if (const auto acceleration = find_given(*driven, "acceleration"); acceleration && body.over_time)
      acceleration->error(context.diagnostics, "is that of the table of `velocity`: leave it out");
  }
  if (section.given("force")) {
    body.force = section.vector("force");
    if (const auto table = decode_over_time(node.find("force"))) body.over_time = table;
  }
  if (section.given("hold")) body.hold = section.number("hold");
  for (const char* key : {"force", "hold"})
    if (section.given(key) && (body.fixed || body.driven))
      node.find(key)->error(context.diagnostics, "is for a body that is neither `fixed` nor `driven`");
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
    body.turn = decode_orientation(context, node);
  }
  body.material = decode_material(context, node, materials);
  if (const auto shape = decode_part(context, node, PluginKind::shape, "shape")) body.shape = *shape;
  return body;
}

}  // namespace

std::vector<RockGroup> decode_rocks(DecodeContext& context, const Node& node,
                                    const std::vector<Material>& materials, const DecodedTerrain& terrain) {
  context.group = -1;
  std::vector<RockGroup> groups = decode_list<RockGroup>(node, [&](const Node& item) {
    ++context.group;
    return decode_group(context, item, materials, terrain);
  });
  context.group = -1;
  return groups;
}

std::vector<BodyPlan> decode_bodies(DecodeContext& context, const Node& node,
                                    const std::vector<Material>& materials) {
  context.group = -1;
  std::vector<BodyPlan> bodies = decode_list<BodyPlan>(node, [&](const Node& item) {
    ++context.group;
    return decode_body(context, item, materials);
  });
  context.group = -1;
  return bodies;
}

}  // namespace flyrock
