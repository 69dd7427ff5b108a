// The measured holes of a blast, from a table or from a list.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "document/table.h"
#include "geometry/bearing.h"
#include "scenario/decode_face.h"
#include "scenario/decode_sections.h"
#include "scenario/leaning_holes.h"
#include "scenario/normalise.h"
#include "scenario/table_cells.h"

namespace flyrock {

namespace {

constexpr const char* hole_list = "blast.holes: list";

/// The field of the blast that a column of holes gives; nothing for its name, row, place and time.
std::optional<BlastField> field_of_column(std::string_view column) {
  for (const BlastFieldInfo& info : blast_fields())
    if (info.path == column || info.path == "hole." + std::string(column)) return info.field;
  return std::nullopt;
}

/// A hole and where it is written, with what its columns say in another way.
struct LocatedHole {
  Hole hole;
  Location at;
  Vec3 toe = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
};

void set_column(LocatedHole& to, const ParamSpec& column, double value) {
  Hole& hole = to.hole;
  if (column.name == "row") hole.row = static_cast<int>(value);
  if (column.name == "x") hole.x = value;
  if (column.name == "y") hole.y = value;
  if (column.name == "z") hole.z = value;
  if (column.name == "time") hole.time = value;
  if (column.name == "toe_x") to.toe.x() = value;
  if (column.name == "toe_y") to.toe.y() = value;
  if (column.name == "toe_z") to.toe.z() = value;
  if (const auto field = field_of_column(column.name)) hole.own[*field] = value;
}

/// "hole 7"
std::string called(const Hole& hole) { return "hole " + hole.name; }

// A table.

std::vector<TableColumn> columns_of_holes() {
  std::vector<TableColumn> columns = table_columns(section_spec(hole_list).keys);
  for (TableColumn& column : columns) {
    const auto field = field_of_column(column.name);
    if (field) column.also = {std::string(blast_fields()[static_cast<std::size_t>(*field)].name)};
    if (column.name == "hole") column.also = {"name"};
    if (column.name == "linear_charge") column.also.insert(column.also.end(), {"charge", "charge_weight"});
    if (column.name == "burden_crest") column.also.emplace_back("crest_burden");
    if (column.name == "burden_toe") column.also.emplace_back("toe_burden");
    if (column.name == "diameter") column.also.emplace_back("dia");
    if (column.name == "toe_x") column.also = {"x_toe", "toe_easting", "toe_east"};
    if (column.name == "toe_y") column.also = {"y_toe", "toe_northing", "toe_north"};
    if (column.name == "toe_z") column.also = {"z_toe", "toe_rl", "toe_elevation"};
  }
  return columns;
}

/// Most tables that say `azimuth` mean a bearing.
void refuse_azimuths(DecodeContext& context, const Node& node, const TextTable& table,
                     const BlastPlan& plan) {
  if (!table.has("azimuth") || plan.has_mathematical_azimuths) return;
  context.diagnostics.error(
      table.head_at("azimuth"), node.path,
      fmt::format(
          "`{}`: expected `bearing_deg`, which counts clockwise from north; or, where it counts from +x "
          "towards +y, `azimuths: mathematical` in `blast`",
          table.head("azimuth")));
}

/// The azimuth of a hole from its bearing.
void put_bearing(DecodeContext& context, const Node& node, LocatedHole& to, std::optional<double> bearing) {
  if (!bearing) return;
  if (!std::isnan(to.hole.own[BlastField::hole_azimuth]))
    context.diagnostics.error(
        to.at, node.path,
        fmt::format("{} has both a bearing and an azimuth, expected one of them", called(to.hole)));
  to.hole.own[BlastField::hole_azimuth] = azimuth_of_bearing(*bearing, context.north);
}

std::vector<LocatedHole> read_hole_table(DecodeContext& context, const Node& node, BlastPlan& plan) {
  std::vector<LocatedHole> holes;
  const Section section = decode_section(context, node, "blast.holes");
  const std::map<std::string, std::string> heads = heads_of(node);
  const auto file = node.find("file");
  if (!file || !file->value->text()) return holes;  // reported
  const std::vector<TableColumn> columns = columns_of_holes();
  const auto table = read_table_of(context, "holes", section.text("file"), columns, heads, *file);
  if (!table) return holes;
  refuse_azimuths(context, node, *table, plan);
  plan.other_heads = table->ignored();
  for (std::size_t row = 0; row < table->rows(); ++row) {
    LocatedHole& to = holes.emplace_back();
    to.at = table->at(row, "hole");
    const std::string_view name = table->text(row, "hole");
    to.hole.name = name.empty() ? std::to_string(row + 1) : std::string(name);
    for (const ParamSpec& column : section_spec(hole_list).keys) {
      const std::optional<double> value = table->number(row, column.name);
      if (!value) continue;
      if (const std::string fault = fault_of_cell(*table, column, *value); !fault.empty())
        context.diagnostics.error(table->at(row, column.name), node.path,
                                  fmt::format("`{}` of {} {}", column.name, called(to.hole), fault));
      else
        set_column(to, column, *value);
    }
    put_bearing(context, node, to, table->number(row, "bearing"));
  }
  warn_of_unusual_cells(context, *table, section_spec(hole_list).keys, node);
  return holes;
}

// A list.

std::vector<LocatedHole> read_hole_list(DecodeContext& context, const Node& node) {
  std::vector<LocatedHole> holes;
  for (const Node& item : node.items()) {
    if (!item.value->map()) continue;  // reported
    const Section section = decode_section(context, item, hole_list);
    LocatedHole& to = holes.emplace_back();
    to.at = item.key_at;
    to.hole.name = section.given("hole") ? section.text("hole") : std::to_string(holes.size());
    for (const ParamSpec& column : section_spec(hole_list).keys)
      if (column.type != ParamType::text && section.given(column.name))
        set_column(to, column, section.constant(column.name));
    put_bearing(context, item, to,
                section.given("bearing") ? std::optional(section.constant("bearing")) : std::nullopt);
  }
  return holes;
}

void refuse_equal_holes(DecodeContext& context, const Node& node, const std::vector<LocatedHole>& holes) {
  std::map<std::string, int> line_of;
  for (const LocatedHole& hole : holes)
    if (const auto [first, is_new] = line_of.emplace(hole.hole.name, hole.at.line); !is_new)
      context.diagnostics.error(
          hole.at, node.path,
          fmt::format("the name `{}` is that of an earlier hole (line {})", hole.hole.name, first->second));
}

/// What says the same in two ways.
void refuse_two_ways(DecodeContext& context, const Node& node, const LocatedHole& located) {
  using enum BlastField;
  const Blast& own = located.hole.own;
  const auto has = [&](BlastField field) { return !std::isnan(own[field]); };
  const auto fail = [&](const std::string& text) {
    context.diagnostics.error(located.at, node.path, fmt::format("{} {}", called(located.hole), text));
  };
  if (has(hole_dip) && has(hole_deviation)) fail("has both `dip` and `deviation`, expected one of them");
  constexpr double rounding = 5e-3;  // m, of lengths written to the centimetre
  if (has(hole_length) && has(hole_stemming) && has(hole_charge_length) &&
      std::abs(own[hole_length] - own[hole_stemming] - own[hole_charge_length]) > rounding)
    fail(fmt::format(
        "has length {:.6g} m, stemming {:.6g} m and charge_length {:.6g} m, which disagree: length = "
        "stemming + charge_length",
        own[hole_length], own[hole_stemming], own[hole_charge_length]));
}

/// Length, dip and azimuth of a hole whose toe is given beside its collar.
void put_toe(DecodeContext& context, const Node& node, LocatedHole& located) {
  using enum BlastField;
  Hole& hole = located.hole;
  Vec3 toe = located.toe;
  if (!(toe.array() == toe.array()).any()) return;
  const bool in_plane = context.dimension == 2;
  if (in_plane) toe.y() = hole.y = 0;  // not read
  const auto fail = [&](const std::string& text) {
    context.diagnostics.error(located.at, node.path, fmt::format("{} {}", called(hole), text));
  };
  const Vec3 down = toe - Vec3(hole.x, hole.y, hole.z);
  if (!down.allFinite())
    return fail("needs `x`, `y` and `z` of its collar and `toe_x`, `toe_y` and `toe_z` of its toe");
  for (const auto& [field, name] :
       {std::pair(hole_length, "length"), std::pair(hole_dip, "dip"), std::pair(hole_azimuth, "bearing"),
        std::pair(hole_deviation, "deviation")})
    if (!std::isnan(hole.own[field]))
      return fail(fmt::format("has both a toe and a `{}`, expected one", name));
  if (!(down.z() < 0)) return fail("has its toe above its collar");
  hole.own[hole_length] = down.norm();
  hole.own[hole_dip] = std::atan2(-down.z(), down.head<2>().norm());
  if (down.head<2>().norm() > 0) hole.own[hole_azimuth] = std::atan2(down.y(), down.x());
}

/// A place in 3D has both coordinates.
void refuse_half_places(DecodeContext& context, const Node& node, const LocatedHole& located) {
  const Hole& hole = located.hole;
  if (context.dimension == 3 && std::isnan(hole.x) != std::isnan(hole.y))
    context.diagnostics.error(located.at, node.path,
                              fmt::format("{} has an `{}` and no `{}`", called(hole),
                                          std::isnan(hole.x) ? "y" : "x", std::isnan(hole.x) ? "x" : "y"));
}

double lowest_of(const DecodeContext& context, const Number& number) {
  return number.is_constant() ? number.constant : context.draws[number.draw].likely_lowest();
}

/// A number that must be above 0 and may not be when the scatter is added. What follows from others, as a
/// burden from those at crest and toe, counts with its median.
void check_scatter(DecodeContext& context, const Node& blast, const BlastPlan& plan) {
  const std::optional<Node> scatter = blast.find("scatter");
  if (!scatter) return;
  for (const ParamSpec& column : section_spec(hole_list).keys) {
    const auto field = field_of_column(column.name);
    const auto added = field ? plan.scatter.find(*field) : plan.scatter.end();
    if (added == plan.scatter.end() || !column.above) continue;
    for (std::size_t i = 0; i < plan.holes.size(); ++i) {
      const double own = plan.pattern.measured[i].own[*field];
      const auto given = plan.fields.find(*field);
      const double least = !std::isnan(own)             ? own
                           : given != plan.fields.end() ? lowest_of(context, given->second)
                                                        : plan.holes[i][*field];
      const double low = least + lowest_of(context, added->second);
      if (low > *column.above || std::isnan(low)) continue;
      scatter->find(column.name)
          ->error(context.diagnostics,
                  fmt::format("takes `{}` of {} from {} down to {}, must stay above {}: give it a `min`",
                              column.name, called(plan.pattern.measured[i]), with_unit(least, column),
                              with_unit(low, column), with_unit(*column.above, column)));
      break;
    }
  }
}

/// The hole with the median of each field that all holes have.
Blast median_hole(const std::vector<Blast>& holes) {
  Blast median = holes.front();
  for (std::size_t f = 0; f < median.values.size(); ++f) {
    std::vector<double> values;
    for (const Blast& hole : holes)
      if (!std::isnan(hole.values[f])) values.push_back(hole.values[f]);
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    median.values[f] = n < holes.size() ? std::numeric_limits<double>::quiet_NaN()
                                        : (values[(n - 1) / 2] + values[n / 2]) / 2;
  }
  return median;
}

}  // namespace

std::vector<int> holes_named(Diagnostics& diagnostics, const Node& list, const std::vector<Hole>& holes,
                             bool are_rows) {
  std::vector<bool> is_chosen(holes.size(), false);
  std::vector<std::string> names;
  for (const Hole& hole : holes) names.push_back(are_rows ? std::to_string(hole.row) : hole.name);
  for (const Node& item : list.items()) {
    const double* number = item.value->number();
    if (!number && !item.value->text()) continue;  // reported
    const std::string name = number ? shortest(*number) : *item.value->text();
    bool is_known = false;
    for (std::size_t h = 0; h < holes.size(); ++h)
      if (names[h] == name) is_chosen[h] = is_known = true;
    if (!is_known)
      item.error(diagnostics, fmt::format("there is no {} `{}`{}", are_rows ? "row" : "hole", name,
                                          did_you_mean(name, names)));
  }
  std::vector<int> chosen;
  for (std::size_t h = 0; h < holes.size(); ++h)
    if (is_chosen[h]) chosen.push_back(static_cast<int>(h));
  return chosen;
}

Value normalise_holes(DecodeContext& context, const Node& node) {
  if (node.value->map() && !node.value->map()->empty()) {
    node.refuse_unknown_keys(section_spec("blast.holes").key_names(), context.diagnostics);
    Map map = normalise_params(context, node, section_spec("blast.holes").keys, {});
    put_columns(context, map, node, "blast.holes.columns");
    return map_value(std::move(map));
  }
  if (!node.value->list()) {
    node.error(context.diagnostics,
               fmt::format("expected `{{ file: TABLE }}` or a list of holes, found {}", shown(*node.value)));
    return {};
  }
  List list;
  for (const Node& item : node.items()) {
    Value hole;
    if (item.expect_map(context.diagnostics)) {
      item.refuse_unknown_keys(section_spec(hole_list).key_names(), context.diagnostics);
      // A name may be a number.
      Value copy = *item.value;
      if (Value* name = copy.find("hole"); name && name->number()) name->data = shortest(*name->number());
      Node named = item;
      named.value = &copy;
      hole = map_value(normalise_params(context, named, section_spec(hole_list).keys, {}));
    }
    hole.at = item.value->at;
    list.push_back(std::move(hole));
  }
  if (list.empty()) node.error(context.diagnostics, "is empty, expected at least one hole");
  return list_value(std::move(list));
}

void decode_holes(DecodeContext& context, const Node& blast, BlastPlan& plan) {
  const std::optional<Node> node = blast.find("holes"), scatter = blast.find("scatter");
  if (scatter && !node) scatter->error(context.diagnostics, "is added to `holes`, the blast has none");
  if (!node || node->value->is_null()) return;
  if (const auto rows = blast.find("rows"))
    rows->error(context.diagnostics, "has rows, and `holes` has measured ones; expected one of them");
  std::vector<LocatedHole> holes =
      node->value->list() ? read_hole_list(context, *node) : read_hole_table(context, *node, plan);
  constexpr std::size_t most_holes = 100'000;
  if (holes.size() > most_holes)
    node->error(context.diagnostics,
                fmt::format("has {} holes, must be at most {}", holes.size(), most_holes));
  refuse_equal_holes(context, *node, holes);
  for (LocatedHole& located : holes) {
    refuse_half_places(context, *node, located);
    put_toe(context, *node, located);
    refuse_two_ways(context, *node, located);
    plan.pattern.measured.push_back(std::move(located.hole));
    plan.hole_places.push_back(located.at);
  }
  if (const std::string leaning = leaning_text(plan.pattern.measured, context.north); !leaning.empty()) {
    if (node->value->list()) context.tables.push_back(fmt::format("holes: {} holes", holes.size()));
    if (!context.tables.empty()) context.tables.back() += leaning;
  }
  for (const BlastField field : context.forced_fields)
    if (const auto given = plan.fields.find(field); given != plan.fields.end()) plan.forced.insert(*given);
  if (!scatter || !scatter->value->map()) return;
  const Section section = decode_section(context, *scatter, "blast.scatter");
  for (const ParamSpec& spec : section_spec("blast.scatter").keys)
    if (const auto added = section.optional_number(spec.name)) {
      if (const auto field = field_of_column(spec.name)) plan.scatter[*field] = *added;
      if (spec.name == "time") plan.time_scatter = *added;
    }
}

void complete_holes(DecodeContext& context, const Node& blast, BlastPlan& plan) {
  Blast common;
  for (const auto& [field, value] : plan.fields) common[field] = middle_of(context, value);
  common.is_anfo = plan.is_anfo;
  const std::size_t errors_before = context.diagnostics.errors_given();
  const std::unique_ptr<const FaceOfBlast> face = read_face(context, blast, plan);
  if (context.diagnostics.errors_given() != errors_before) return;
  for (std::size_t i = 0; i < plan.pattern.measured.size(); ++i) {
    const Hole& hole = plan.pattern.measured[i];
    Blast& completed = plan.holes.emplace_back(common);
    BlastSources& sources = plan.sources.emplace_back(given_fields(plan));
    put_own(hole, completed, &sources);
    for (const BlastFieldInfo& info : blast_fields())
      if (!std::isnan(hole.own[info.field])) plan.columns.insert(info.field);
    try {
      complete(completed, &sources);
      if (face) face->put_burden(i, completed, plan);
      for (const auto& [field, value] : plan.forced)
        force(field, middle_of(context, value), completed, &sources);
      if (!plan.forced.empty()) complete(completed, &sources);
      plan.hole_designs.push_back(design_of(completed, Pattern{}));
    } catch (const std::invalid_argument& fault) {
      context.diagnostics.error(plan.hole_places[i], blast.path + ".holes",
                                fmt::format("{}: {}", called(hole), fault.what()));
    }
  }
  if (context.diagnostics.errors_given() != errors_before) return;
  if (face) {
    warn_of_gaps(context, blast, plan);
    std::vector<std::size_t> away;
    for (std::size_t i = 0; i < plan.holes.size(); ++i)
      if (!plan.face->curves[i].depth.empty() && face->leans_away(plan.pattern.measured[i], plan.holes[i]))
        away.push_back(i);
    if (context.forced_fields.empty()) warn_of_holes_away(context, blast, plan, away);
  }
  check_scatter(context, blast, plan);
  plan.typical = median_hole(plan.holes);
  plan.design = design_of_holes(plan.hole_designs, plan.pattern);
  plan.design.linear_charge = plan.typical[BlastField::hole_linear_charge];
  if (!context.forced_fields.empty()) return;  // a branch is not as designed
  if (const std::string text = disagreement(plan.typical, plan.design); !text.empty())
    context.diagnostics.warning(blast.key_at, blast.path, text);
}

}  // namespace flyrock
