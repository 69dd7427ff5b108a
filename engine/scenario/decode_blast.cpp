#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "scenario/decode_sections.h"

namespace flyrock {

namespace {

/// Decodes the given fields of `section`: "" for the blast itself, "hole.", "explosive.".
void decode_fields(DecodeContext& context, const Node& node, std::string_view section,
                   std::string_view prefix, BlastPlan& plan) {
  const Section fields = decode_section(context, node, section);
  for (const ParamSpec& spec : section_spec(section).keys)
    for (const BlastFieldInfo& info : blast_fields())
      if (info.path == std::string(prefix) + spec.name && fields.given(spec.name))
        plan.fields[info.field] = fields.number(spec.name);
  const std::optional<Node> bearing = section == "blast.hole" ? node.find("bearing") : std::nullopt;
  if (!bearing || bearing->value->is_null()) return;
  if (fields.given("azimuth"))
    bearing->error(context.diagnostics, "says the same as `azimuth`, expected one of them");
  else
    plan.fields[BlastField::hole_azimuth] = azimuth_of(context, *bearing, fields.number("bearing"));
}

/// D/3 for a Gurney constant that is not given. The draw of D itself is scaled by 1/3, so that both vary
/// together.
Number third_of(DecodeContext& context, const Number& velocity) {
  if (velocity.is_constant()) return {velocity.constant / 3, -1};
  Draw draw = context.draws[velocity.draw];
  draw.factor /= 3;
  context.draws.push_back(std::move(draw));
  return {0, static_cast<int>(context.draws.size()) - 1};
}

void decode_explosive(DecodeContext& context, const Node& node, BlastPlan& plan) {
  if (const std::string* name = node.value->text()) {
    std::vector<std::string> names;
    for (const Explosive& explosive : explosives()) {
      names.emplace_back(explosive.name);
      if (explosive.name != *name) continue;
      plan.fields[BlastField::explosive_density] = {explosive.density, -1};
      plan.fields[BlastField::detonation_velocity] = {explosive.detonation_velocity, -1};
      plan.fields[BlastField::gurney_constant] = {explosive.gurney_constant, -1};
      plan.is_anfo = explosive.is_anfo;
      return;
    }
    return node.error(
        context.diagnostics,
        fmt::format("unknown explosive `{}`{}; or give a map with its density and detonation_velocity", *name,
                    suggestion(*name, names)));
  }
  decode_fields(context, node, "blast.explosive", "explosive.", plan);
  const auto velocity = plan.fields.find(BlastField::detonation_velocity);
  plan.gurney_follows = velocity != plan.fields.end() && !plan.fields.contains(BlastField::gurney_constant);
  if (plan.gurney_follows) plan.fields[BlastField::gurney_constant] = third_of(context, velocity->second);
}

/// The values that a field takes in a run, where they have no end without the negligible tail.
struct Span {
  double low = 0, high = 0;
};

Span range_of(const DecodeContext& context, const Number& number) {
  if (number.is_constant()) return {number.constant, number.constant};
  const Draw& draw = context.draws[number.draw];
  return {draw.likely_lowest(), draw.likely_highest()};
}

Span field_range(const DecodeContext& context, const BlastPlan& plan, BlastField field) {
  const auto found = plan.fields.find(field);
  return found == plan.fields.end() ? Span{} : range_of(context, found->second);
}

std::string metres(const Span& range) {
  if (range.low == range.high) return fmt::format("{:.6g} m", range.low);
  return fmt::format("{:.6g} to {:.6g} m", range.low, range.high);
}

/// Two of length, stemming and charge length determine the third; if all three are given, they must agree.
void check_lengths(DecodeContext& context, const Node& hole, const BlastPlan& plan) {
  using enum BlastField;
  const auto given = [&](BlastField field) { return plan.fields.contains(field); };
  const Span length = field_range(context, plan, hole_length),
             stemming = field_range(context, plan, hole_stemming),
             charge = field_range(context, plan, hole_charge_length);
  const auto left = [&](const char* what, double least) {
    if (least <= 0)
      hole.error(context.diagnostics,
                 fmt::format("the length ({}) leaves {:.6g} m for the {} at worst, expected above 0",
                             metres(length), least, what));
  };
  if (!given(hole_length)) return;
  if (!given(hole_charge_length) && given(hole_stemming)) left("charge", length.low - stemming.high);
  if (!given(hole_stemming) && given(hole_charge_length)) left("stemming", length.low - charge.high);
  if (!given(hole_stemming) || !given(hole_charge_length)) return;
  constexpr double rounding = 1e-9;
  const bool drawn = length.low < length.high || stemming.low < stemming.high || charge.low < charge.high;
  if (drawn || std::abs(length.low - stemming.low - charge.low) > rounding)
    hole.error(
        context.diagnostics,
        fmt::format(
            "length ({}), stemming ({}) and charge_length ({}) {}; give two of them, the third follows",
            metres(length), metres(stemming), metres(charge),
            drawn ? "are given and drawn apart" : "disagree, length = stemming + charge_length"));
}

/// Requires `burden`, or both `burden_crest` and `burden_toe` with what the depth of the charge needs.
void check_burdens(DecodeContext& context, const Node& blast, const BlastPlan& plan) {
  using enum BlastField;
  const auto given = [&](BlastField field) { return plan.fields.contains(field); };
  const bool crest = given(burden_crest), toe = given(burden_toe);
  const int lengths = given(hole_length) + given(hole_stemming) + given(hole_charge_length);
  if (given(burden) && (crest || toe))
    blast.error(context.diagnostics,
                "has `burden` and that at the crest or toe, expected either `burden` or both others");
  else if (crest != toe)
    blast.error(context.diagnostics,
                fmt::format("`{}` is missing, `{}` alone gives no burden of the charge",
                            crest ? "burden_toe" : "burden_crest", crest ? "burden_crest" : "burden_toe"));
  else if (crest && lengths < 2)
    blast.error(context.diagnostics,
                "burdens at crest and toe need two of hole.length, hole.stemming and hole.charge_length");
  if (given(hole_deviation) && !crest)
    blast.error(
        context.diagnostics,
        "`hole.deviation` changes the burden along the hole, which needs burden_crest and burden_toe");
}

/// Completes the blast with all medians, and reports contradictions in it.
void complete_plan(DecodeContext& context, const Node& node, BlastPlan& plan) {
  try {
    plan.sources = {given_fields(plan)};
    complete(plan.typical, &plan.sources.front());
    plan.design = design_of(plan.typical, plan.pattern);
  } catch (const std::invalid_argument& fault) {
    return context.diagnostics.error(node.key_at, "", fault.what());  // the text already begins with the path
  }
  if (!context.forced_fields.empty()) return;  // a branch is not as designed
  if (const std::string text = disagreement(plan.typical, plan.design); !text.empty())
    context.diagnostics.warning(node.key_at, node.path, text);
}

}  // namespace

double middle_of(const DecodeContext& context, const Number& number) {
  return number.is_constant() ? number.constant : context.draws[number.draw].quantile(0.5);
}

BlastSources given_fields(const BlastPlan& plan) {
  BlastSources sources;
  for (const auto& [field, value] : plan.fields) sources.give(field, Giver::blast);
  if (plan.gurney_follows)
    sources.compute(BlastField::gurney_constant, sources[BlastField::detonation_velocity]);
  return sources;
}

BlastPlan decode_blast(DecodeContext& context, const Node& node) {
  BlastPlan plan;
  const std::size_t errors_before = context.diagnostics.errors_given();
  const auto is_sound = [&] {
    return context.is_sound(node.path) && context.diagnostics.errors_given() == errors_before;
  };
  if (const auto explosive = node.find("explosive")) decode_explosive(context, *explosive, plan);
  if (const auto hole = node.find("hole")) decode_fields(context, *hole, "blast.hole", "hole.", plan);
  decode_fields(context, node, "blast", "", plan);
  if (const auto rows = node.find("rows")) {
    const Section section = decode_section(context, *rows, "blast.rows");
    const double holes = section.constant("count") * section.constant("holes");
    constexpr double most_holes = 1e6;
    if (holes > most_holes)
      rows->error(context.diagnostics,
                  fmt::format("has {:.6g} holes, must be at most {:.6g}", holes, most_holes));
    else if (context.is_sound(rows->path))
      plan.pattern = {section.integer("count"),       section.integer("holes"),
                      section.constant("distance"),   section.constant("delay_row"),
                      section.constant("delay_hole"), section.constant("delay_in_hole")};
  }
  plan.has_mathematical_azimuths = node.find("azimuths").has_value();
  decode_holes(context, node, plan);
  if (const auto face = node.find("face"); face && !plan.has_holes())
    face->error(context.diagnostics, "gives the burdens of `holes`, the blast has none");
  if (!is_sound()) return plan;  // checks of derived values would mislead
  if (plan.has_holes()) {
    complete_holes(context, node, plan);
    return plan;
  }
  for (const auto& [field, value] : plan.fields) plan.typical[field] = middle_of(context, value);
  plan.typical.is_anfo = plan.is_anfo;
  if (const auto hole = node.find("hole")) check_lengths(context, *hole, plan);
  check_burdens(context, node, plan);
  if (is_sound()) complete_plan(context, node, plan);
  return plan;
}

void check_hole(DecodeContext& context, const Node& blast, const BlastPlan& plan,
                const TerrainPlan& terrain) {
  const std::optional<Node> hole = blast.find("hole");
  const bool has_length = plan.fields.contains(BlastField::hole_length);
  if (plan.has_holes()) return;  // their lengths are measured
  if (!hole || !plan.provides(BlastField::hole_charge_length) || !terrain.model.plugin) return;
  if (terrain.model.plugin->spec.name != "benches") return;
  const int index = terrain.model.plugin->spec.find("height");
  if (index < 0) return;
  const Span height = range_of(context, terrain.model.values[index].numbers[0]);
  const Span stemming = field_range(context, plan, BlastField::hole_stemming);
  const Span charge = field_range(context, plan, BlastField::hole_charge_length);
  const Span subdrilling = field_range(context, plan, BlastField::hole_subdrilling);
  const Span length = has_length ? field_range(context, plan, BlastField::hole_length)
                                 : Span{stemming.low + charge.low, stemming.high + charge.high};
  if (has_length && length.high > height.low + subdrilling.low)
    return context.diagnostics.error(
        hole->key_at, hole->path,
        fmt::format("length ({}) is longer than bench height ({}) + subdrilling ({})", metres(length),
                    metres(height), metres(subdrilling)));
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
