#pragma once
// The file of a table as lines: of a text, or of a sheet of a workbook.

#include <memory>
#include <stdexcept>
#include <string>

#include "document/location.h"

namespace flyrock {

struct TableText {
  std::shared_ptr<const Source> source;
  bool is_sheet = false;  ///< its fields are apart by tabs (document/workbook.h)
  std::size_t hidden_rows = 0;
};

/// Why a file is no table.
struct TableTextFault : std::runtime_error {
  TableTextFault(const std::string& text, std::shared_ptr<const Source> of, int at_line)
      : std::runtime_error(text), source(std::move(of)), line(at_line) {}
  std::shared_ptr<const Source> source;  ///< null: the text names the file
  int line;                              ///< from 1
};

/// Reads a text in UTF-8, or a sheet: `holes.xlsx#Sheet`. Throws TableTextFault.
TableText read_table_text(const std::string& path);

}  // namespace flyrock
