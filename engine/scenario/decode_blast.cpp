#include <fmt/format.h>

#include <algorithm>

#include "scenario/decode_sections.h"

namespace flyrock {

namespace {

/// One spec at a time, because the burden varies from hole to hole and the rest from trial to trial.
NumberRules rules_of(std::string_view path) {
  const bool is_of_hole = path.starts_with("hole.") || path == "burden";
  return {.varies = true, .scope = is_of_hole ? Scope::hole : Scope::trial, .finest = Scope::rock};
}

/// Decodes the fields of `section` ("" of the blast itself, "hole.", "explosive.") that are given.
void decode_fields(DecodeContext& context, const Node& node, std::string_view section,
                   std::string_view prefix, BlastPlan& plan, Map& resolved) {
  for (const ParamSpec& spec : section_spec(section).keys) {
    const std::string path = std::string(prefix) + spec.name;
    const std::vector<ParamValue> values = decode_params(context, node, {spec}, rules_of(path), resolved);
    if (!values[0].given) continue;
    for (const BlastFieldInfo& info : blast_fields())
      if (info.path == path) plan.fields[info.field] = values[0].numbers[0];
  }
}

/// D/3 in place of a Gurney constant that was not given: the draw of D itself, scaled, so that both fall
/// together.
Number third_of(DecodeContext& context, const Number& velocity) {
  if (velocity.is_constant()) return {velocity.constant / 3, -1};
  Draw draw = context.draws[velocity.draw];
  draw.distribution = scaled(draw.distribution, 1.0 / 3);
  context.draws.push_back(std::move(draw));
  return {0, static_cast<int>(context.draws.size()) - 1};
}

void decode_explosive(DecodeContext& context, const Node& node, BlastPlan& plan, Map& resolved) {
  if (const std::string* name = node.value->text()) {
    std::vector<std::string> names;
    for (const Explosive& explosive : explosives()) {
      names.emplace_back(explosive.name);
      if (explosive.name != *name) continue;
      plan.fields[BlastField::explosive_density] = {explosive.density, -1};
      plan.fields[BlastField::detonation_velocity] = {explosive.detonation_velocity, -1};
      plan.fields[BlastField::gurney_constant] = {explosive.gurney_constant, -1};
      plan.is_anfo = explosive.is_anfo;
      put(resolved, "explosive", text_value(*name));
      return;
    }
    return node.error(
        context.diagnostics,
        fmt::format("unknown explosive `{}`{}; or give a map with its density and detonation_velocity", *name,
                    suggestion(*name, names)));
  }
  if (!node.expect_map(context.diagnostics)) return;
  node.refuse_unknown_keys(section_spec("blast.explosive").key_names(), context.diagnostics);
  Map map;
  decode_fields(context, node, "blast.explosive", "explosive.", plan, map);
  const auto velocity = plan.fields.find(BlastField::detonation_velocity);
  if (velocity != plan.fields.end() && !plan.fields.contains(BlastField::gurney_constant))
    plan.fields[BlastField::gurney_constant] = third_of(context, velocity->second);
  put(resolved, "explosive", map_value(std::move(map)));
}

struct Range {
  double low = 0, high = 0;
};

Range range_of(const DecodeContext& context, const Number& number) {
  if (number.is_constant()) return {number.constant, number.constant};
  const Distribution& distribution = context.draws[number.draw].distribution;
  return {distribution.lowest(), distribution.highest()};
}

Range field_range(const DecodeContext& context, const BlastPlan& plan, BlastField field) {
  const auto found = plan.fields.find(field);
  return found == plan.fields.end() ? Range{} : range_of(context, found->second);
}

std::string metres(const Range& range) {
  if (range.low == range.high) return fmt::format("{:.6g} m", range.low);
  return fmt::format("{:.6g} to {:.6g} m", range.low, range.high);
}

}  // namespace

BlastPlan decode_blast(DecodeContext& context, const Node& node, Map& resolved) {
  BlastPlan plan;
  if (!node.expect_map(context.diagnostics)) return plan;
  node.refuse_unknown_keys(section_spec("blast").key_names(), context.diagnostics);
  Map map;
  if (const auto explosive = node.find("explosive")) decode_explosive(context, *explosive, plan, map);
  if (const auto hole = node.find("hole"); hole && hole->expect_map(context.diagnostics)) {
    hole->refuse_unknown_keys(section_spec("blast.hole").key_names(), context.diagnostics);
    Map fields;
    decode_fields(context, *hole, "blast.hole", "hole.", plan, fields);
    put(map, "hole", map_value(std::move(fields)));
  }
  decode_fields(context, node, "blast", "", plan, map);
  if (const auto rows = node.find("rows")) {
    Map fields;
    const Section section = decode_section(context, rows, "blast.rows", {}, fields);
    const double holes = section.constant("count") * section.constant("holes");
    constexpr double most_holes = 1e6;
    if (holes > most_holes)
      rows->error(context.diagnostics,
                  fmt::format("has {:.6g} holes, must be at most {:.6g}", holes, most_holes));
    plan.holes = static_cast<int>(std::clamp(holes, 1.0, most_holes));
    put(map, "rows", map_value(std::move(fields)));
  }
  put(resolved, "blast", map_value(std::move(map)));
  return plan;
}

void check_hole(DecodeContext& context, const Node& blast, const BlastPlan& plan,
                const TerrainPlan& terrain) {
  const std::optional<Node> hole = blast.find("hole");
  if (!hole || !plan.fields.contains(BlastField::hole_charge_length) || !terrain.model.plugin) return;
  if (terrain.model.plugin->spec.name != "benches") return;
  const int index = terrain.model.plugin->spec.find("height");
  if (index < 0) return;
  const Range height = range_of(context, terrain.model.values[index].numbers[0]);
  const Range stemming = field_range(context, plan, BlastField::hole_stemming);
  const Range charge = field_range(context, plan, BlastField::hole_charge_length);
  const Range subdrilling = field_range(context, plan, BlastField::hole_subdrilling);
  const Range length{stemming.low + charge.low, stemming.high + charge.high};
  if (length.high > height.low + subdrilling.low)
    return context.diagnostics.error(
        hole->key_at, hole->path,
        fmt::format("stemming ({}) and charge_length ({}) are up to {:.6g} m long, longer than bench height "
                    "({}) + subdrilling ({})",
                    metres(stemming), metres(charge), length.high, metres(height), metres(subdrilling)));
  if (length.low < height.high)
    context.diagnostics.warning(
        hole->key_at, hole->path,
        fmt::format("the hole ({}) is shorter than the bench ({})", metres(length), metres(height)));
}

}  // namespace flyrock
