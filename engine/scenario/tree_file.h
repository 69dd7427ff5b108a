#pragma once
// Trees in a text file: a table (document/table.h) of places, diameters and heights.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "document/node.h"
#include "geometry/forest.h"

namespace flyrock {

/// The trees of a file, its heads that are no columns, and what was read (TextTable::summary).
struct TreeFile {
  std::vector<Stem> stems;
  std::vector<std::string> other_heads;
  std::string summary;
};

/// Reads a tree a line: its place `x`, `y`, its diameter at breast height `dbh`, its `height` and its
/// `species`, a key of `strengths`, which are the factors on the energy that a tree takes. Without the
/// column, or with no `strengths`, they are 1. `heads`: other heads by column. Reports what is wrong, and
/// diameters and heights whose median no wood has, because their unit is another one; then returns nothing.
std::optional<TreeFile> read_trees(const std::string& path, const std::map<std::string, double>& strengths,
                                   const std::map<std::string, std::string>& heads, const Node& where,
                                   Diagnostics& diagnostics);

}  // namespace flyrock
