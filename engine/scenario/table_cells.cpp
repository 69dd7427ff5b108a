#include "scenario/table_cells.h"

#include <fmt/format.h>

#include <cmath>

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

std::string fault_of_cell(const ParamSpec& column, double value) {
  if (const std::string fault = limit_fault(column, value, value); !fault.empty()) {
    const bool is_angle = column.dimension == dimension::angle;
    return fmt::format("is {}, {}{}", with_unit(value, column), fault,
                       is_angle ? fmt::format("; write angles with their unit: `{}_deg`", column.name) : "");
  }
  if (column.type == ParamType::integer && value != std::round(value))
    return fmt::format("is {:.6g}, expected a whole number", value);
  return {};
}

}  // namespace flyrock
