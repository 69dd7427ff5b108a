// The trees of a scenario in 3D.

#include <fmt/format.h>

#include <algorithm>

#include "scenario/decode_sections.h"
#include "scenario/normalise.h"
#include "scenario/table_cells.h"
#include "scenario/tree_file.h"

namespace flyrock {

namespace {

constexpr NumberRules of_tree{.varies = true, .scope = Scope::rock, .finest = Scope::rock};
constexpr NumberRules of_hit{.varies = true, .scope = Scope::impact, .finest = Scope::impact};

const char* section_of(const Node& node) {
  return node.find("file") ? "forest: file 3D" : "forest: density 3D";
}

void read_file(DecodeContext& context, const Node& node, const Section& section, ForestPlan& plan) {
  std::map<std::string, double> strengths;
  if (const auto species = node.find("species"))
    for (const Section& one : decode_list<Section>(
             *species, [&](const Node& item) { return decode_section(context, item, "forest.species 3D"); }))
      strengths[one.text("name")] = one.constant("factor");
  if (section.text("file").empty()) return;  // reported
  const Node file = *node.find("file");
  auto trees = read_trees(section.text("file"), strengths, heads_of(node), file, context.diagnostics);
  if (!trees) return;
  context.tables.push_back(fmt::format("trees of {}: {}", *file.value->text(), trees->summary));
  plan.stems = std::move(trees->stems);
  plan.other_heads = std::move(trees->other_heads);
}

void check_zone(DecodeContext& context, const Node& node, const std::string& zone,
                std::vector<std::string> parts) {
  if (parts.empty()) return;  // the terrain could not be built
  std::erase(parts, "");
  if (std::find(parts.begin(), parts.end(), zone) != parts.end()) return;
  node.find("zone")->error(context.diagnostics, fmt::format("the terrain has no zone or part `{}`{}", zone,
                                                            suggestion(zone, parts)));
}

}  // namespace

Value normalise_forest(DecodeContext& context, const Node& node) {
  if (!node.expect_map(context.diagnostics)) return {};
  const SectionSpec& spec = section_spec(section_of(node));
  node.refuse_unknown_keys(spec.key_names(), context.diagnostics);
  Map map;
  for (const ParamSpec& key : spec.keys) {
    const bool is_size = key.name == "diameter" || key.name == "height";
    put_all(map, normalise_params(context, node, {key},
                                  is_size              ? of_tree
                                  : key.name == "turn" ? of_hit
                                                       : NumberRules{}));
  }
  if (const auto columns = node.find("columns"); columns && node.find("file"))
    put(map, *columns, normalise_section(context, *columns, "forest.columns 3D", {}));
  if (const auto species = node.find("species"); species && node.find("file"))
    put(map, *species, normalise_list_of(context, *species, "forest.species 3D"));
  return map_value(std::move(map));
}

std::optional<ForestPlan> decode_forest(DecodeContext& context, const Node& node,
                                        const DecodedTerrain& terrain) {
  if (context.dimension != 3) {
    node.error(context.diagnostics, "trees stand in dimension 3, the scenario has dimension 2");
    return std::nullopt;
  }
  if (!node.value->map()) return std::nullopt;  // reported
  // Numbers of trees are no inputs of rocks: their draws stay here.
  std::vector<Draw> others;
  std::swap(context.draws, others);
  const Section section = decode_section(context, node, section_of(node));
  ForestPlan plan;
  plan.is_fixed = section.text("law") == "fixed";
  if (section.given("energy")) plan.energy = section.constant("energy");
  if (plan.is_fixed != section.given("energy"))
    (plan.is_fixed ? *node.find("law") : *node.find("energy"))
        .error(context.diagnostics, plan.is_fixed
                                        ? "the law `fixed` needs `energy`, which a tree takes at most"
                                        : "belongs to `law: fixed`");
  plan.factor = section.constant("energy_factor");
  plan.turn = section.number("turn");
  if (node.find("file")) {
    read_file(context, node, section, plan);
  } else {
    plan.density = section.constant("density");
    plan.diameter = section.number("diameter");
    plan.height = section.number("height");
    plan.is_drawn = true;
    if (section.given("zone")) {
      plan.zone = section.text("zone");
      check_zone(context, node, plan.zone, terrain.parts);
    }
  }
  plan.text = to_json(*node.value);
  plan.draws = std::move(context.draws);
  context.draws = std::move(others);
  return plan;
}

}  // namespace flyrock
