#pragma once
// Columns of tables, described as parameters are: limits of their cells, and other heads.

#include <map>
#include <string>
#include <vector>

#include "document/table.h"
#include "plugin/spec.h"

namespace flyrock {

/// The columns of a table, none of them required.
std::vector<TableColumn> table_columns(const std::vector<ParamSpec>& specs);

/// The heads that `columns: { mass: HEAD }` of a section gives.
std::map<std::string, std::string> heads_of(const Node& section);

/// Why a number of a table is not what its column takes; empty if it is.
std::string fault_of_cell(const ParamSpec& column, double value);

}  // namespace flyrock
