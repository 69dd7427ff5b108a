#pragma once
// What a head of a table says: the name of a column, and the unit of its numbers.

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "units/units.h"

namespace flyrock {

/// A column that a table may have.
struct TableColumn {
  std::string name;
  Dimension dimension;                 ///< of its numbers
  bool is_text = false;                ///< names in place of numbers
  bool required = false;               ///< the table must have it, and a value in each line
  std::vector<std::string> also = {};  ///< other names
  bool is_common = true;               ///< it also has the names that every table knows, as `easting` of x
};

/// A unit, and how messages write it.
struct HeadUnit {
  Unit unit;
  std::string text;  ///< "kg/m"; empty: the head has none, and its numbers are SI
};

/// The unit at the end of a head, in any case of its letters: "_kg_per_m", " (m)", " [m]", " {m}", ", m", "
/// in m",
/// "-m", ".m", "_m_s" for m/s, " in metres". Of several readings the one with the dimension counts; nothing
/// where none has it.
std::optional<HeadUnit> unit_of_head(std::string_view end, const Dimension& dimension);

/// The column that a head names.
struct HeadMatch {
  const TableColumn* column = nullptr;  ///< null: none
  HeadUnit unit;
  std::size_t name = 0;  ///< 0: by the column's own name; else by another name, the earlier the better
  /// No column, but the head begins with a name of this one, and goes on with what is no unit of its numbers.
  const TableColumn* begun = nullptr;
  std::string rest;  ///< what it goes on with
};

/// Reads a head: a name of a column, in which case, blanks, `_`, `-` and `.` do not count, then nothing or a
/// unit. The longest name counts. `mapped` columns have heads of their own and are left out.
HeadMatch match_head(std::string_view head, std::span<const TableColumn> columns,
                     const std::map<std::string, std::string>& mapped);

/// The unit of any head that was named for a column: that of its longest end that is one.
HeadUnit unit_at_end(std::string_view head, const Dimension& dimension);

}  // namespace flyrock
