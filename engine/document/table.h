#pragma once
// Tables in text files, one record a line: holes, rocks, measured places.

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "document/node.h"
#include "units/units.h"

namespace flyrock {

/// A column that a table may have.
struct TableColumn {
  std::string name;
  Dimension dimension;                 ///< of its numbers
  bool is_text = false;                ///< names in place of numbers
  bool required = false;               ///< the table must have it, and a value in each line
  std::vector<std::string> also = {};  ///< other names, where no column has them with this unit
};

/// How a table begins.
enum class TableForm {
  heads,  ///< with a line of heads
  /// `#` begins a comment. A first line of numbers means that there are no heads: each line then has the
  /// columns in their order, apart by commas, blanks or semicolons.
  points
};

/// The cells of a table, numbers in SI units.
class TextTable {
 public:
  std::size_t rows() const { return rows_; }
  bool has(std::string_view column) const;
  /// Nothing if there is no such column, or if the cell is empty.
  std::optional<double> number(std::size_t row, std::string_view column) const;
  /// Empty if there is no such column. A whole number is text too.
  std::string_view text(std::size_t row, std::string_view column) const;
  /// Where a cell stands; the begin of its line if there is no such column.
  Location at(std::size_t row, std::string_view column) const;
  /// Heads that no column asked for.
  const std::vector<std::string>& ignored() const { return ignored_; }

 private:
  friend class TextTableReader;
  struct Cell {
    std::string text;
    double number = 0;
    bool is_number = false;
    int at = 1;  ///< from 1
  };

  const Cell* cell(std::size_t row, std::string_view column) const;

  std::shared_ptr<const Source> source_;
  std::size_t rows_ = 0;
  std::vector<int> lines_;  ///< of the rows, from 1
  std::map<std::string, std::vector<Cell>, std::less<>> columns_;
  std::vector<std::string> ignored_;
};

/// Reads a table: a line of heads, then a record a line. Values are apart by commas, semicolons, tabs or
/// blanks, whichever the heads are, and may stand in double quotes; except with commas 1,5 is 1.5. A head is
/// the name of a column, alone (SI units) or with a unit: `mass_kg`, `vx_m_s`, `charge_kg_per_m`, `mass [t]`;
/// the order is free. `heads` gives other heads by name of column: { "mass": "weight_t" }. An empty cell is a
/// value that is not there. Reports all that is wrong with its line and column, at most 20 places; then, or
/// if `where`, the value that names the file, is at fault, returns nothing.
std::optional<TextTable> read_table(const std::string& path, std::span<const TableColumn> columns,
                                    const std::map<std::string, std::string>& heads, const Node& where,
                                    Diagnostics& diagnostics, TableForm form = TableForm::heads);

}  // namespace flyrock
