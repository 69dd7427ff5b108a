#include "scenario/table_cells.h"

#include <fmt/format.h>

#include <cmath>

#include "scenario/layer_table.h"
#include "scenario/normalise_number.h"

namespace flyrock {

std::vector<TableColumn> table_columns(const std::vector<ParamSpec>& specs) {
  std::vector<TableColumn> columns;
  for (const ParamSpec& spec : specs)
    columns.push_back(
        {.name = spec.name, .dimension = spec.dimension, .is_text = spec.type == ParamType::text});
  return columns;
}

std::map<std::string, std::string> heads_of(const Node& section) {
  std::map<std::string, std::string> heads;
  if (const auto columns = section.find("columns"))
    for (const Node& entry : columns->entries())
      if (const std::string* head = entry.value->text()) heads[entry.key] = *head;
  return heads;
}

std::optional<TextTable> read_table_of(DecodeContext& context, const std::string& what,
                                       const std::string& path, std::span<const TableColumn> columns,
                                       const std::map<std::string, std::string>& heads, const Node& where) {
  std::optional<TextTable> table = read_any_table(path, columns, heads, where, context.diagnostics);
  const std::string* name = where.value->text();
  if (table)
    context.tables.push_back(fmt::format("{} of {}: {}", what, name ? *name : path, table->summary()));
  return table;
}

namespace {

/// A column with the unit that its table has, for messages.
ParamSpec as_in(const TextTable& table, ParamSpec column) {
  if (const std::string_view unit = table.unit(column.name); !unit.empty()) column.unit = unit;
  return column;
}

}  // namespace

std::string fault_of_cell(const TextTable& table, const ParamSpec& column, double value) {
  if (column.name == "dip" && value < 0)
    return fmt::format("is {}: dip counts downwards from horizontal, expected 0 to 90 deg",
                       table.shown(column.name, value));
  if (const std::string fault = limit_fault(as_in(table, column), value, value); !fault.empty())
    return fmt::format("is {}, {}", table.shown(column.name, value), fault);
  if (column.type == ParamType::integer && value != std::round(value))
    return fmt::format("is {:.6g}, expected a whole number", value);
  return {};
}

void warn_of_unusual_cells(DecodeContext& context, const TextTable& table,
                           const std::vector<ParamSpec>& columns, const Node& where) {
  for (const ParamSpec& column : columns) {
    if (!column.usual) continue;
    std::size_t first = 0, count = 0;
    for (std::size_t row = 0; row < table.rows(); ++row)
      if (const auto value = table.number(row, column.name); value && !column.usual->holds(*value) &&
                                                             limit_fault(column, *value, *value).empty() &&
                                                             count++ == 0)
        first = row;
    if (count == 0) continue;
    const std::string more = count == 1 ? "" : fmt::format(" (and {} more rows)", count - 1);
    context.diagnostics.unusual(
        table.at(first, column.name), where.path,
        fmt::format("`{}`: {} is unusual, expected {} to {}{}", table.head(column.name),
                    table.shown(column.name, *table.number(first, column.name)),
                    with_unit(column.usual->least, as_in(table, column)),
                    with_unit(column.usual->greatest, as_in(table, column)), more));
  }
}

}  // namespace flyrock
