#pragma once
// Tables in text files and sheets of workbooks, one record a line: holes, rocks, measured places.

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "document/node.h"
#include "document/table_head.h"
#include "document/table_text.h"

namespace flyrock {

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
  /// The head of a column as the file writes it, and where it stands.
  std::string_view head(std::string_view column) const;
  Location head_at(std::string_view column) const;
  /// The unit of a column, "kg/m"; empty: its head has none.
  std::string_view unit(std::string_view column) const;
  /// An SI number in the unit of its column, with it: "12.4 m".
  std::string shown(std::string_view column, double si) const;
  /// Heads that no column asked for.
  const std::vector<std::string>& ignored() const { return ignored_; }
  /// What was read: "3 rows, 1 of them hidden in the sheet; burden 1.9 to 3 m, time 0 to 34 ms; not read:
  /// `note`".
  std::string summary() const;

 private:
  friend class TextTableReader;
  struct Cell {
    std::string text;
    double number = 0;
    bool is_number = false;
    int at = 1;  ///< from 1
  };
  struct Column {
    std::vector<Cell> cells;
    std::string head;
    int line = 1, at = 1;  ///< of the head
    HeadUnit unit;
    bool is_text = false;
    std::size_t place = 0;  ///< among the heads
  };

  const Cell* cell(std::size_t row, std::string_view column) const;

  std::shared_ptr<const Source> source_;
  std::size_t rows_ = 0, hidden_rows_ = 0;
  std::vector<int> lines_;  ///< of the rows, from 1
  std::map<std::string, Column, std::less<>> columns_;
  std::vector<std::string> ignored_;
  std::vector<std::string> known_;  ///< the columns that were asked for
};

/// Reads a table of a text file, or of a sheet (`holes.xlsx#Sheet`, document/workbook.h): a line of heads,
/// then a record a line. Values are apart by commas, semicolons, tabs or blanks, whichever the heads are, and
/// may stand in double quotes; except with commas 1,5 is 1.5, if no number of the table has a point. A head
/// is the name of a column, or another name of it, alone (SI units) or with a unit (document/table_head.h);
/// the order is free. `heads` gives other heads by name of column: { "mass": "weight_t" }. An empty cell is a
/// value that is not there, and a row of empty cells is none.
///
/// What may mean something else is an error: a head that begins with a name and goes on with what is no unit;
/// a first line without a known head but a name; times and angles without a unit; two decimal signs; a row
/// without a place (`x`) or a `distance` where others have a place; a row that is a total or a mean.
///
/// Reports all that is wrong with its line and column, at most 20 places; then, or if `where`, the value that
/// names the file, is at fault, returns nothing.
std::optional<TextTable> read_table(const std::string& path, std::span<const TableColumn> columns,
                                    const std::map<std::string, std::string>& heads, const Node& where,
                                    Diagnostics& diagnostics, TableForm form = TableForm::heads);
/// The same of lines that were read elsewhere, with a line of heads.
std::optional<TextTable> read_table(const TableText& text, std::span<const TableColumn> columns,
                                    const std::map<std::string, std::string>& heads, const Node& where,
                                    Diagnostics& diagnostics);

}  // namespace flyrock
