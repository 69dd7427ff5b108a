#pragma once
// Sheets of workbooks, .xlsx (ECMA-376) and .ods (OpenDocument 1.2), as the lines of a table.

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace flyrock {

/// `holes.xlsx#Sheet`: the file, and the sheet of it, or the layer (`pit.gpkg#joints`). Only names of
/// workbooks and of GeoPackages have parts.
struct SheetName {
  std::string file, sheet;
};
SheetName sheet_name(const std::string& text);

/// Whether a file that begins like this is an archive, as workbooks are.
bool is_workbook(std::string_view begin);

/// What is wrong with a workbook.
struct WorkbookFault : std::runtime_error {
  WorkbookFault(int of_row, const std::string& text) : std::runtime_error(text), row(of_row) {}
  int row;  ///< from 1; 0: the workbook as a whole, and the text follows "the file holes.xlsx"
};

struct Sheet {
  std::string name;
  std::vector<std::string> lines;  ///< a row each: its fields apart by tabs, in quotes where they hold one
  std::size_t hidden_rows = 0;     ///< rows with values that the sheet does not show, among the lines
};

/// Reads a sheet; without a name the only one. Each cell is the text that a table would have there: numbers
/// as they are stored and not as they are shown, but shares as 25%, dates and times as 2026-11-28 and
/// 07:30:00, so that none is taken for a number. All rows have the fields of the longest. Throws
/// WorkbookFault: for a file that is cut, damaged or protected, a sheet that is not there, merged cells
/// (which of their rows has the value?) and formulas that were never computed.
Sheet read_sheet(std::string_view bytes, const std::string& name);

}  // namespace flyrock
