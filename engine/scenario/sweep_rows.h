#pragma once
// `sweep: { rows: [{ PATH: VALUE }] }` or `{ table: FILE }`: points of a sweep that set several paths at
// once. A row is a point; its `label`, if it has one, names it.

#include <optional>
#include <string>
#include <vector>

#include "document/diagnostics.h"
#include "scenario/sweep.h"

namespace flyrock {

struct SweepRows {
  /// What the rows set, each path with one value a row; all rows set the same paths. Sorted by path.
  std::vector<SweptValue> columns;  ///< without slots: set_path() puts the values
  std::vector<std::string> labels;  ///< of each row; empty: none is given
  bool product = false;             ///< each row at each point of the sweeps elsewhere
  Location at;
  std::string file;  ///< of a table, as written; empty: rows
  std::string path_of_file;

  std::size_t count() const { return columns.empty() ? 0 : columns.front().values.size(); }
};

/// The rows of the section `sweep` of a tree; nothing without any. Puts the values of the first row into the
/// tree, so that all paths are there. Reports rows that differ in their paths, paths that take no sweep, and
/// a path that is swept elsewhere. A table has a line of paths, each with its unit in brackets or none
/// (`blast.burden [m]`), then a line for each row; values are apart by commas, semicolons or tabs. `folder`:
/// of the scenario.
std::optional<SweepRows> read_sweep_rows(Value& root, const std::string& folder, Diagnostics& diagnostics);

}  // namespace flyrock
