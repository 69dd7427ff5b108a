// Materials, terrain and pairs.

#include <fmt/format.h>

#include <algorithm>

#include "scenario/normalise.h"

namespace flyrock {

namespace {

constexpr NumberRules roughness_rules{.varies = true, .scope = Scope::impact, .finest = Scope::impact};
constexpr NumberRules material_rules{.varies = true, .scope = Scope::rock, .finest = Scope::impact};
constexpr NumberRules friction_rules{
    .varies = true, .scope = Scope::rock, .finest = Scope::impact, .over_time = "mu"};
constexpr NumberRules terrain_rules{.varies = true, .scope = Scope::trial, .finest = Scope::trial};

/// The name of a material; null if it is no text.
Value material_name(DecodeContext& context, const Node& node) {
  if (const std::string* name = node.value->text()) return text_value(*name);
  node.error(context.diagnostics,
             node.value->is_null()
                 ? "is empty, expected the name of a material"
                 : fmt::format("expected the name of a material, found {}", shown(*node.value)));
  return {};
}

/// { type: section, of: { type, ... }, from, to }: a profile out of a terrain in 3D.
Value section_terrain(DecodeContext& context, const Node& node) {
  const SectionSpec& spec = section_spec("terrain: section");
  std::vector<std::string> keys = spec.key_names();
  keys.insert(keys.end(), {"type", "material", "materials", "zones", "faces", "north"});
  for (std::string& key : earthworks_of(context, node)) keys.push_back(std::move(key));
  node.refuse_unknown_keys(keys, context.diagnostics);
  Map map;
  put(map, *node.find("type"), text_value("section"));
  if (const std::optional<Node> of = node.find("of")) {
    context.dimension = 3;
    put(map, *of, normalise_plugin(context, *of, PluginKind::terrain, terrain_rules));
    context.dimension = 2;
  } else {
    context.diagnostics.error(node.key_at, node.path,
                              "`of` is missing, expected a terrain in 3D: { type, ... }");
  }
  put_all(map, normalise_params(context, node, spec.keys, {}));
  return map_value(std::move(map));
}

/// What is built of a terrain: all but its zones, faces, origin and materials.
Value normalise_ground(DecodeContext& context, const Node& node) {
  const SoundnessOf soundness(context, node.path);
  const std::optional<Node> type = node.find("type");
  if (context.dimension == 2 && type && type->value->text() && *type->value->text() == "section")
    return section_terrain(context, node);
  std::vector<std::string> others = {"material", "materials", "zones", "faces", "north"};
  for (std::string& key : earthworks_of(context, node)) others.push_back(std::move(key));
  if (context.dimension == 3) others.insert(others.end(), {"origin", "crs"});
  return normalise_plugin(context, node, PluginKind::terrain, terrain_rules, others);
}

Value normalise_zones(DecodeContext& context, const Node& node) {
  return normalise_list(context, node, [&](const Node& item) {
    if (context.dimension == 2) return normalise_section(context, item, section_of_zone(std::nullopt), {});
    const std::optional<Node> key = key_of_zone(item);
    if (!key)
      item.error(
          context.diagnostics,
          "expected `polygon`, `geojson`, `raster` with `value`, or `group` in a zone of a terrain in 3D");
    for (const char* other : {"polygon", "geojson", "raster", "group"})
      if (key && key->key != other && item.find(other)) {
        item.error(context.diagnostics,
                   fmt::format("has both `{}` and `{}`, expected one of them", key->key, other));
        return Value{};
      }
    return key ? normalise_section(context, item, section_of_zone(key), {}) : Value{};
  });
}

}  // namespace

Value normalise_materials(DecodeContext& context, const Node& node) {
  if (!node.expect_map(context.diagnostics)) return {};
  Map all;
  for (const Node& entry : node.entries()) {
    check_key(context, entry);
    Map laws;
    const bool is_map = entry.expect_map(context.diagnostics);
    if (is_map) {
      entry.refuse_unknown_keys(section_spec("materials").key_names(), context.diagnostics);
      for (const PluginKind kind :
           {PluginKind::restitution, PluginKind::friction, PluginKind::rolling, PluginKind::unilateral})
        if (const std::optional<Node> law = entry.find(name_of(kind)))
          put(laws, *law,
              normalise_plugin(context, *law, kind,
                               kind == PluginKind::friction ? friction_rules : material_rules));
      if (const std::optional<Node> roughness = entry.find("roughness"))
        put(laws, *roughness, normalise_section(context, *roughness, "materials.roughness", roughness_rules));
    }
    put(all, entry, is_map ? map_value(std::move(laws)) : Value{});
  }
  return map_value(std::move(all));
}

Value normalise_terrain(DecodeContext& context, const Node& node) {
  Value terrain = normalise_ground(context, node);
  if (!terrain.map()) return terrain;
  Map& map = *terrain.map();
  const bool space = context.dimension == 3;
  for (const std::string& key : earthworks_of(context, node))
    if (const auto work = node.find(key))
      put(map, *work, normalise_section(context, *work, "terrain." + key, {}));
  if (const auto zones = node.find("zones")) put(map, *zones, normalise_zones(context, *zones));
  if (const auto faces = node.find("faces"))
    put(map, *faces, normalise_list_of(context, *faces, space ? "terrain.faces 3D" : "terrain.faces"));
  for (const ParamSpec& spec : section_spec(space ? "terrain 3D" : "terrain").keys)
    if (spec.name != "material") put_all(map, normalise_params(context, node, {spec}, {}));
  if (const auto rest = node.find("material")) put(map, *rest, material_name(context, *rest));
  if (const auto named = node.find("materials")) {
    Map names;
    const bool is_map = named->expect_map(context.diagnostics);
    for (const Node& entry : named->entries()) put(names, entry, material_name(context, entry));
    put(map, *named, is_map ? map_value(std::move(names)) : Value{});
  }
  return terrain;
}

Value normalise_between(DecodeContext& context, const Node& node, const std::string& section,
                        const std::string& expected) {
  if (!node.expect_list(context.diagnostics)) return {};
  refuse_duplicate_names(context, node);
  List list;
  for (const Node& item : node.items()) {
    Value pair = normalise_section(context, item, section, {});
    const std::optional<Node> between = item.find("between");
    const bool is_pair = between && between->items().size() == 2;
    if (!is_pair)
      (between ? *between : item)
          .error(context.diagnostics, "expected `between` with the names of " + expected);
    Map map;
    if (is_pair) put(map, *between, *between->value);
    if (pair.map()) put_all(map, std::move(*pair.map()));
    list.push_back(map_value(std::move(map)));
    list.back().at = item.value->at;
  }
  return list_value(std::move(list));
}

std::vector<std::string> earthworks_of(DecodeContext& context, const Node& terrain) {
  const std::optional<Node> type = terrain.find("type");
  const std::string* name = type ? type->value->text() : nullptr;
  const Plugin* plugin = name ? context.registry.find(PluginKind::terrain, *name) : nullptr;
  std::vector<std::string> keys;
  for (const char* key : {"ditch", "bund"}) {
    const auto is_own = [&](const ParamSpec& param) { return param.group() == key; };
    const bool has_own =
        plugin && std::any_of(plugin->spec.params.begin(), plugin->spec.params.end(), is_own);
    if (context.dimension == 2 && !has_own) keys.emplace_back(key);
  }
  return keys;
}

std::optional<Node> key_of_zone(const Node& zone) {
  for (const char* key : {"polygon", "geojson", "raster", "group"})
    if (std::optional<Node> node = zone.find(key)) return node;
  return std::nullopt;
}

std::string section_of_zone(const std::optional<Node>& key) {
  return key ? fmt::format("terrain.zones: {} 3D", key->key) : "terrain.zones";
}

}  // namespace flyrock
