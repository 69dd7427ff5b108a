#pragma once
// The tables of a result that exports write, as docs/results.md lists them.

#include <string>
#include <vector>

namespace flyrock {

struct ExportedTable {
  std::string name;
  /// A view returns the rows of a rock in the order in which they were written
  /// (report/tables/record_tables.h).
  bool is_view = false;

  /// A query of these columns of all rows, in their order.
  std::string select(const std::string& columns) const;
};

std::vector<ExportedTable> exported_tables();

}  // namespace flyrock
