// Groups of rocks and bodies.

#include <fmt/format.h>

#include <array>

#include "document/wording.h"
#include "scenario/layer.h"
#include "scenario/normalise.h"
#include "scenario/normalise_shapes.h"

namespace flyrock {

namespace {

constexpr NumberRules rock_rules{.varies = true, .scope = Scope::rock, .finest = Scope::rock};
constexpr NumberRules population_rules{.varies = true, .scope = Scope::trial, .finest = Scope::trial};
constexpr NumberRules body_rules{
    .varies = true, .scope = Scope::trial, .finest = Scope::trial, .over_time = "force"};

struct ReleaseKey {
  std::string_view key;
  bool only_3d;
};
constexpr std::array<ReleaseKey, 7> release_keys{{{"from", false},
                                                  {"x", false},
                                                  {"position", false},
                                                  {"along", false},
                                                  {"inside", false},
                                                  {"zone", true},
                                                  {"raster", true}}};

/// Whether the points of `along` or `inside` are places in plan: [x, y] in 3D.
bool is_in_plan(const Node& points) {
  if (is_layer(*points.value)) return true;
  const std::vector<Node> items = points.is_list() ? points.items() : std::vector<Node>();
  return !items.empty() && items.front().is_list() && items.front().items().size() == 2;
}

Value normalise_release(DecodeContext& context, const Node& node) {
  if (!node.expect_map(context.diagnostics)) return {};
  const std::optional<Node> key = key_of_release(node, context.dimension);
  if (!key) {
    std::vector<std::string> names;
    for (const ReleaseKey& known : release_keys)
      if (context.dimension == 3 || !known.only_3d) names.emplace_back(known.key);
    node.refuse_unknown_keys(names, context.diagnostics);
    context.diagnostics.error(node.key_at, node.path, fmt::format("expected one of {}", choice_text(names)));
    return {};
  }
  Value release = normalise_section(context, node, section_of_release(*key, context.dimension), rock_rules);
  if (const Value* face = release.find("face"); face && face->text() && !face->text()->empty()) {
    if (node.find("bench"))
      node.error(context.diagnostics, "has both `bench` and `face`, expected one of them");
    // The face takes the place of the bench, which has a default.
    std::erase_if(*release.map(), [](const Entry& entry) { return entry.key == "bench"; });
  }
  return release;
}

/// Requires exactly one of density and mass; none is fine if `is_optional`.
void check_mass(DecodeContext& context, const Node& node, bool is_optional) {
  const bool density = node.find("density").has_value(), mass = node.find("mass").has_value();
  if (density && mass)
    context.diagnostics.error(node.key_at, node.path, "has both `density` and `mass`, expected one of them");
  if (!density && !mass && !is_optional)
    context.diagnostics.error(node.key_at, node.path, "`density` or `mass` is missing");
}

void put_plugin(DecodeContext& context, Map& map, const Node& parent, std::string_view key, PluginKind kind,
                const NumberRules& rules) {
  if (const std::optional<Node> node = parent.find(key))
    put(map, *node, normalise_plugin(context, *node, kind, rules));
}

void put_turn(DecodeContext& context, Map& map, const Node& parent, const NumberRules& rules) {
  if (context.dimension != 3) return;
  if (const std::optional<Node> node = parent.find("orientation"))
    put(map, *node, normalise_turn(context, *node, rules));
}

/// What says how many rocks there are, in place of the number of the population: rocks of holes and of a
/// table.
constexpr std::array counting_keys = {"per_hole", "table"};

std::optional<Node> counting_key(const Node& node) {
  for (const char* key : counting_keys)
    if (auto found = node.find(key)) return found;
  return std::nullopt;
}

void check_counting_key(DecodeContext& context, const Node& node, bool is_independent) {
  const std::optional<Node> key = counting_key(node);
  if (!key) return;
  if (node.find("per_trial"))
    key->error(context.diagnostics, "replaces `per_trial`: give only one");
  else if (node.find("per_hole") && node.find("table"))
    node.find("table")->error(context.diagnostics, "replaces `per_hole`: give only one");
  else if (!is_independent)
    key->error(
        context.diagnostics,
        fmt::format("needs the population `{}`, the other ones say themselves how many rocks there are",
                    default_population));
}

/// A shape of the document, by its name, or one of a plugin.
void put_named_or_plugin(DecodeContext& context, Map& map, const Node& parent, const NumberRules& rules) {
  const std::optional<Node> shape = parent.find("shape");
  const std::string* name = shape ? shape->value->text() : nullptr;
  if (!name) return put_plugin(context, map, parent, "shape", PluginKind::shape, rules);
  const auto found = context.shapes.find(*name);
  if (found != context.shapes.end()) {
    if (!context.is_sound("shapes." + *name)) context.unsound.insert(shape->path);  // no second error
    return put(map, *shape, found->second);
  }
  std::vector<std::string> names;
  for (const auto& [known, use] : context.shapes) names.push_back(known);
  shape->error(context.diagnostics,
               fmt::format("`shapes` has no `{}`{}: expected its name, or a shape {{ type, ... }}", *name,
                           suggestion(*name, names)));
}

/// The form of the lengths of a table, or a shape of a plugin.
void put_shape(DecodeContext& context, Map& group, const Node& node) {
  const std::optional<Node> shape = node.find("shape");
  if (!shape) return;
  const Value* type = shape->value->find("type");
  if (!type || !type->text() || *type->text() != from_lengths)
    return put_named_or_plugin(context, group, node, rock_rules);
  Value form = normalise_section(context, *shape, "rocks.shape: from_lengths", {});
  if (Map* keys = form.map()) keys->insert(keys->begin(), Entry{"type", type->at, *type});
  if (!node.find("table"))
    shape->error(context.diagnostics, "has the lengths of a `table`, the group has none");
  put(group, *shape, std::move(form));
}

/// What belongs to a table only.
void check_words_of_table(DecodeContext& context, const Node& node) {
  if (node.find("table")) return;
  if (const auto columns = node.find("columns"))
    columns->error(context.diagnostics, "are the heads of a `table`, the group has none");
  if (const auto density = node.find("density");
      density && density->value->text() && *density->value->text() == from_table)
    density->error(context.diagnostics, "needs a `table` with masses and lengths, the group has none");
}

void put_launch_by_size(DecodeContext& context, Map& group, const Node& node) {
  const std::optional<Node> by_size = node.find("launch_by_size");
  if (!by_size) return;
  if (!node.find("launch"))
    by_size->error(context.diagnostics, "changes the speed of `launch`, the group has none");
  put(group, *by_size, normalise_section(context, *by_size, "rocks.launch_by_size", rock_rules));
}

/// Which of the measured holes have rocks.
void put_holes(DecodeContext& context, Map& group, const Node& node) {
  const auto rows = node.find("rows"), holes = node.find("holes");
  if (rows && holes) holes->error(context.diagnostics, "chooses holes as `rows` does, expected one of them");
  for (const auto& [key, expected] : {std::pair(rows, "row"), std::pair(holes, "hole")}) {
    if (!key) continue;
    if (!node.find("per_hole"))
      context.diagnostics.error(key->key_at, key->path, "chooses holes for `per_hole`, the group has none");
    put(group, *key, normalise_names(context, *key, expected));
  }
}

/// Air of its own, or none.
void put_air(DecodeContext& context, Map& group, const Node& node) {
  const auto air = node.find("air");
  if (!air) return;
  const std::string* word = air->value->text();
  put(group, *air,
      word && *word == "none" ? text_value(*word) : normalise_section(context, *air, "air", air_rules));
}

Value normalise_group(DecodeContext& context, const Node& node) {
  const SectionSpec& spec = section_spec(context.dimension == 2 ? "rocks" : "rocks 3D");
  Map group = normalise_params(context, node, spec.keys, rock_rules);
  const Value population = normalise_plugin(context, node, PluginKind::population, population_rules,
                                            spec.key_names(), default_population);
  put_all(group, *population.map());
  if (const auto weight = node.find("weight"); weight && weight->value->map())
    weight->error(context.diagnostics,
                  "takes no distribution: it is the number of real rocks that each rock "
                  "of the group stands for");
  check_mass(context, node, false);
  put_turn(context, group, node, rock_rules);
  put_columns(context, group, node, "rocks.columns");
  put_holes(context, group, node);
  put_air(context, group, node);
  put_shape(context, group, node);
  check_words_of_table(context, node);
  if (const auto release = node.find("release")) put(group, *release, normalise_release(context, *release));
  put_plugin(context, group, node, "launch", PluginKind::velocity, rock_rules);
  put_launch_by_size(context, group, node);
  const std::string* type = population.find("type")->text();
  if (counting_key(node))  // which takes the place of the default
    std::erase_if(group, [](const Entry& entry) { return entry.key == "per_trial" && entry.value.assumed; });
  check_counting_key(context, node, type && *type == default_population);
  if (type && *type == default_population)
    for (const char* key : {"shape", "release"})  // other populations may decide both
      if (!node.find(key) && !(key == std::string_view("release") && counting_key(node)))
        context.diagnostics.error(node.key_at, node.path, fmt::format("`{}` is missing", key));
  return map_value(std::move(group));
}

Value normalise_body(DecodeContext& context, const Node& node) {
  Value body = normalise_section(context, node, context.dimension == 2 ? "bodies" : "bodies 3D", body_rules);
  const std::optional<Node> driven = node.find("driven");
  if (driven)
    put(*body.map(), *driven,
        normalise_section(context, *driven, "bodies.driven", {.over_time = "velocity"}));
  const bool* fixed = body.find("fixed")->boolean();
  check_mass(context, node, driven || (fixed && *fixed));
  put_turn(context, *body.map(), node, body_rules);
  put_named_or_plugin(context, *body.map(), node, body_rules);
  if (!node.find("shape")) context.diagnostics.error(node.key_at, node.path, "`shape` is missing");
  return body;
}

void refuse_empty(DecodeContext& context, const Node& list) {
  if (list.value->list() && list.items().empty())
    list.error(context.diagnostics, "is empty, expected at least one element");
}

}  // namespace

std::optional<Node> key_of_release(const Node& release, int dimension) {
  for (const ReleaseKey& known : release_keys)
    if (dimension == 3 || !known.only_3d)
      if (std::optional<Node> key = release.find(known.key)) return key;
  return std::nullopt;
}

std::string section_of_release(const Node& key, int dimension) {
  const std::string name = "rocks.release: " + key.key;
  if (dimension == 2 || key.key == "from" || key.key == "position") return name;
  if (key.key == "along" || key.key == "inside") return is_in_plan(key) ? name + " plan 3D" : name;
  return name + " 3D";
}

Value normalise_shape_of_rocks(DecodeContext& context, const Node& node) {
  return normalise_plugin(context, node, PluginKind::shape, rock_rules);
}

Value normalise_shape_of_bodies(DecodeContext& context, const Node& node) {
  return normalise_plugin(context, node, PluginKind::shape, body_rules);
}

Value normalise_rocks(DecodeContext& context, const Node& list) {
  refuse_empty(context, list);
  return normalise_list(context, list, [&](const Node& item) { return normalise_group(context, item); });
}

Value normalise_bodies(DecodeContext& context, const Node& list) {
  refuse_empty(context, list);
  return normalise_list(context, list, [&](const Node& item) { return normalise_body(context, item); });
}

}  // namespace flyrock
