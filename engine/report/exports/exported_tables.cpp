#include "report/exports/exported_tables.h"

#include <fmt/format.h>

#include "report/tables/record_tables.h"

namespace flyrock {

namespace {

/// The tables that are not made of rows of trials, and the view of inputs with their paths.
constexpr const char* other_tables[] = {
    "points", "sweep", "parts",     "ground",    "grounds", "ground_vertices", "ground_triangles", "inputs",
    "stems",  "zones", "envelopes", "map_grids", "maps",    "expectations"};

}  // namespace

std::string ExportedTable::select(const std::string& columns) const {
  return fmt::format("SELECT {} FROM {} ORDER BY {}", columns, name,
                     is_view ? "point, trial, rock" : "rowid");
}

std::vector<ExportedTable> exported_tables() {
  std::vector<ExportedTable> tables;
  for (const std::string name : other_tables) tables.push_back({name, name == "inputs"});
  visit_tables(none_of_the_records, [&](const Table& table, const auto&, auto) {
    if (table.name != std::string_view("drawn")) tables.push_back({table.name, table.many_rows != nullptr});
  });
  return tables;
}

}  // namespace flyrock
