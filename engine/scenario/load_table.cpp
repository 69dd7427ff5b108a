#include "scenario/load_table.h"

#include <fmt/format.h>

#include "scenario/normalise_number.h"
#include "scenario/normalise_param.h"

namespace flyrock {

namespace {

constexpr std::string_view table_key = "table";

/// What a row has after its time: a number, or a vector where the table takes one.
ParamSpec value_of_row(const ParamSpec& spec, const Node& value) {
  ParamSpec of_row = spec;
  if (spec.name != "gravity" || !value.is_list()) return of_row;
  of_row.type = ParamType::vector;
  of_row.min = -*spec.max;
  return of_row;
}

Value normalise_row(DecodeContext& context, const Node& row, const ParamSpec& spec) {
  ParamSpec time;
  time.name = "time";
  time.unit = "s";
  time.dimension = dimension::time;
  time.min = 0;
  const std::vector<Node> items = row.is_list() ? row.items() : std::vector<Node>();
  if (items.size() != 2) {
    row.error(context.diagnostics, fmt::format("expected a time and {}: [t, v]", expected_text(spec)));
    return {};
  }
  List pair{normalise_number(context, items[0], time, {}),
            normalise_param(context, items[1], value_of_row(spec, items[1]), {})};
  return list_value(std::move(pair));
}

const List& rows_of(const Value& table) { return *table.find(table_key)->list(); }

Vec3 vector_of(const Value& value) {
  Vec3 vector = Vec3::Zero();
  if (!value.list()) return {si_of(value), 0, 0};
  for (std::size_t k = 0; k < value.list()->size(); ++k)
    vector[static_cast<int>(k)] = si_of((*value.list())[k]);
  return vector;
}

}  // namespace

bool is_over_time(const Value& value) { return value.find(table_key) != nullptr; }

Value normalise_over_time(DecodeContext& context, const Node& node, const ParamSpec& spec) {
  node.refuse_unknown_keys({std::string(table_key)}, context.diagnostics);
  const Node table = *node.find(table_key);
  const std::vector<Node> rows = table.is_list() ? table.items() : std::vector<Node>();
  if (rows.size() < 2) {
    table.error(
        context.diagnostics,
        fmt::format("expected at least two rows, each a time and {}: [[t, v], [t, v]]", expected_text(spec)));
    return {};
  }
  const std::size_t errors = context.diagnostics.errors_given();
  List normalised;
  for (const Node& row : rows) {
    normalised.push_back(normalise_row(context, row, spec));
    if (normalised.size() < 2 || context.diagnostics.errors_given() > errors) continue;
    const double before = si_of(normalised[normalised.size() - 2].list()->front());
    const Node time = row.items().front();
    if (si_of(normalised.back().list()->front()) > before) continue;
    time.error(context.diagnostics, fmt::format("is {}, must be after the time of the row before, {} s",
                                                shown(*time.value), shortest(before)));
  }
  if (context.diagnostics.errors_given() > errors) return {};
  Map map;
  put(map, table, list_value(std::move(normalised)));
  return map_value(std::move(map));
}

std::vector<double> start_of_table(const Value& table, const ParamSpec& spec) {
  const Value& first = rows_of(table).front().list()->back();
  if (!first.list()) return {si_of(first)};
  std::vector<double> components;
  for (const Value& component : *first.list()) components.push_back(si_of(component));
  if (spec.type == ParamType::vector) return components;
  return {-components.back()};
}

std::shared_ptr<const OverTime> decode_over_time(const std::optional<Node>& node) {
  if (!node || !is_over_time(*node->value)) return nullptr;
  std::vector<OverTime::Row> rows;
  for (const Value& row : rows_of(*node->value))
    rows.push_back({.time = si_of(row.list()->front()), .value = vector_of(row.list()->back())});
  return std::make_shared<const OverTime>(std::move(rows));
}

std::shared_ptr<const OverTime> decode_gravity_over_time(const std::optional<Node>& node, int dimension) {
  const auto table = decode_over_time(node);
  if (!table) return nullptr;
  std::vector<OverTime::Row> rows = table->rows();
  const List& given = rows_of(*node->value);
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (!given[k].list()->back().list()) rows[k].value = -rows[k].value.x() * Vec3::Unit(dimension - 1);
  return std::make_shared<const OverTime>(std::move(rows));
}

}  // namespace flyrock
