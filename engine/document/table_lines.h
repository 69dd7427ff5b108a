#pragma once
// The lines of a table as text: what separates their fields, and where each field stands.

#include <string>
#include <string_view>
#include <vector>

namespace flyrock {

/// A field of a line, without its quotes.
struct TableField {
  std::string text;
  int at = 1;  ///< from 1
};

/// `text` without the blanks at its ends.
std::string_view without_blanks(std::string_view text);

/// The separator of a line of heads: a semicolon, a tab or a comma, the first of these that it has; a blank
/// where nothing else is and no unit stands in brackets.
char separator_of(std::string_view heads);

/// The separator that a line such as `sep=;` of a spreadsheet names; 0 if the line is none.
char named_separator(std::string_view line);

/// Cuts a line at its separators. A field in double quotes may hold them; "" is a quote in it.
std::vector<TableField> fields_apart_by(char separator, std::string_view line);

/// A text as a field of a line whose fields are apart by tabs.
std::string field_between_tabs(std::string text);

/// The numbers of a line without heads: apart by semicolons if it has one, else by commas or blanks. Where
/// blanks alone give the right count, a comma between digits is one of decimals.
std::vector<TableField> bare_fields(std::string_view line, std::size_t expected);

/// Whether the last field of a line begins with a quote that the line does not close: it goes on in the next.
bool opens_quote(std::string_view line);

/// What a file of these bytes is if it is no table in UTF-8, and what to do; empty if nothing says so.
std::string other_format(std::string_view bytes);

}  // namespace flyrock
