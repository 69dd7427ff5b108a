// Groups of rocks and bodies.

#include <fmt/format.h>

#include <algorithm>

#include "scenario/decode_sections.h"

namespace flyrock {

namespace {

constexpr NumberRules rock_rules{.varies = true, .scope = Scope::rock, .finest = Scope::rock};
constexpr NumberRules population_rules{.varies = true, .scope = Scope::trial, .finest = Scope::trial};
constexpr NumberRules body_rules{.varies = true, .scope = Scope::trial, .finest = Scope::trial};

/// Exactly one of density and mass; none where `is_optional`.
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

void check_bench(DecodeContext& context, const Node& node, int bench, const std::optional<Profile>& profile) {
  if (!profile || bench < 1) return;
  const int faces = static_cast<int>(profile->faces.size());
  if (bench <= faces) return;
  const std::string found =
      faces == 0 ? "the terrain has no bench faces" : fmt::format("the terrain has {}", faces);
  node.error(context.diagnostics, fmt::format("there is no bench {}, {}", bench, found));
}

std::optional<Release> decode_release(DecodeContext& context, const Node& node,
                                      const std::optional<Profile>& profile, Map& resolved) {
  constexpr std::array<std::pair<std::string_view, ReleaseKind>, 5> kinds{
      {{"from", ReleaseKind::face},
       {"x", ReleaseKind::above_ground},
       {"position", ReleaseKind::position},
       {"along", ReleaseKind::along},
       {"inside", ReleaseKind::inside}}};
  if (!node.expect_map(context.diagnostics)) return std::nullopt;
  std::vector<std::string> names;
  for (const auto& [name, kind] : kinds) names.emplace_back(name);
  const auto chosen =
      std::find_if(kinds.begin(), kinds.end(), [&](const auto& kind) { return node.find(kind.first); });
  if (chosen == kinds.end()) {
    node.refuse_unknown_keys(names, context.diagnostics);
    context.diagnostics.error(node.key_at, node.path, fmt::format("expected one of {}", choice_text(names)));
    return std::nullopt;
  }
  const Section section =
      decode_section(context, node, fmt::format("rocks.release: {}", chosen->first), rock_rules, resolved);
  Release release;
  release.kind = chosen->second;
  switch (release.kind) {
    case ReleaseKind::face:
      release.bench = section.integer("bench");
      check_bench(context, node, release.bench, profile);
      break;
    case ReleaseKind::above_ground:
      release.x = section.number("x");
      release.above_ground = section.number("above_ground");
      break;
    case ReleaseKind::position:
      release.position = section.vector("position");
      break;
    case ReleaseKind::along:
      release.points = section.points("along");
      if (release.points.size() < 2) node.error(context.diagnostics, "`along` needs at least two points");
      break;
    case ReleaseKind::inside:
      release.points = section.points("inside");
      break;
  }
  return release;
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

RockGroup decode_group(DecodeContext& context, const Node& node, const std::vector<Material>& materials,
                       const std::optional<Profile>& profile, Map& resolved) {
  const SectionSpec& spec = section_spec("rocks");
  RockGroup group;
  const Section section(spec.keys, decode_params(context, node, spec.keys, rock_rules, resolved));
  group.name = section.text("name");
  if (const auto population = decode_plugin(context, node, PluginKind::population, population_rules, resolved,
                                            spec.key_names(), default_population))
    group.population = *population;
  check_mass(context, node, section, false);
  group.density = section.number("density");
  group.mass = section.optional_number("mass");
  group.thickness = section.optional_number("thickness");
  group.orientation = section.optional_number("orientation");
  group.material = decode_material(context, node, section, materials);
  group.shape = decode_part(context, node, PluginKind::shape, "shape", rock_rules, resolved);
  if (const auto release = node.find("release")) {
    Map map;
    group.release = decode_release(context, *release, profile, map);
    put(resolved, "release", map_value(std::move(map)));
  }
  group.launch = decode_part(context, node, PluginKind::velocity, "launch", rock_rules, resolved);
  if (group.population.plugin && group.population.plugin->spec.name == default_population)
    for (const char* key : {"shape", "release"})  // other populations may decide both themselves
      if (!node.find(key))
        context.diagnostics.error(node.key_at, node.path, fmt::format("`{}` is missing", key));
  return group;
}

BodyPlan decode_body(DecodeContext& context, const Node& node, const std::vector<Material>& materials,
                     Map& resolved) {
  BodyPlan body;
  const Section section = decode_section(context, node, "bodies", body_rules, resolved);
  body.name = section.text("name");
  body.fixed = section.constant("fixed") != 0;
  if (const auto driven = node.find("driven")) {
    Map map;
    const Section motion = decode_section(context, driven, "bodies.driven", {}, map);
    std::vector<double> velocity;
    for (const Number& component : motion.vector("velocity")) velocity.push_back(component.constant);
    body.driven.emplace(std::move(velocity), motion.constant("spin"));
    if (body.fixed) driven->error(context.diagnostics, "a body is either `fixed` or `driven`");
    put(resolved, "driven", map_value(std::move(map)));
  }
  check_mass(context, node, section, body.fixed || body.driven);
  body.density = section.optional_number("density");
  body.mass = section.optional_number("mass");
  body.thickness = section.optional_number("thickness");
  body.position = section.vector("position");
  body.velocity = section.vector("velocity");
  if (body.velocity.empty()) body.velocity.assign(context.dimension, Number{});
  body.spin = section.number("spin");
  body.orientation = section.number("orientation");
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
                                    const std::vector<Material>& materials,
                                    const std::optional<Profile>& profile, Map& resolved) {
  refuse_empty(context, node);
  return decode_list<RockGroup>(context, node, "rocks", resolved, [&](const Node& item, Map& map) {
    return decode_group(context, item, materials, profile, map);
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
