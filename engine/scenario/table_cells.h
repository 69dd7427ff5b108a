#pragma once
// Columns of tables, described as parameters are: limits of their cells, and other heads.

#include <map>
#include <string>
#include <vector>

#include "document/table.h"
#include "scenario/decode_context.h"

namespace flyrock {

/// The columns of a table, none of them required.
std::vector<TableColumn> table_columns(const std::vector<ParamSpec>& specs);

/// The heads that `columns: { mass: HEAD }` of a section gives.
std::map<std::string, std::string> heads_of(const Node& section);

/// Reads a table of the scenario, and keeps a line of what was read for `check`. `what` says what it is of:
/// "holes". `where` names the file.
std::optional<TextTable> read_table_of(DecodeContext& context, const std::string& what,
                                       const std::string& path, std::span<const TableColumn> columns,
                                       const std::map<std::string, std::string>& heads, const Node& where);

/// Why a number of a table is not what its column takes; empty if it is.
std::string fault_of_cell(const TextTable& table, const ParamSpec& column, double value);

/// Warns of values that are unusual, once for each column.
void warn_of_unusual_cells(DecodeContext& context, const TextTable& table,
                           const std::vector<ParamSpec>& columns, const Node& where);

}  // namespace flyrock
