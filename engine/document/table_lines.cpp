#include "document/table_lines.h"

#include <algorithm>

#include "units/units.h"

namespace flyrock {

namespace {

constexpr std::string_view blanks = " \t\r";

std::vector<TableField> fields_of(std::string_view line, char separator) {
  std::vector<TableField> fields;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    while (i < line.size() && line[i] != separator && blanks.find(line[i]) != std::string_view::npos) ++i;
    TableField field{"", static_cast<int>(i) + 1};
    if (i < line.size() && line[i] == '"') {
      for (++i; i < line.size(); ++i) {
        if (line[i] == '"' && (i + 1 >= line.size() || line[i + 1] != '"')) break;
        if (line[i] == '"') ++i;
        field.text += line[i];
      }
      i = std::min(line.find(separator, i), line.size());
    } else {
      const std::size_t end = std::min(line.find(separator, i), line.size());
      field.text = without_blanks(line.substr(i, end - i));
      i = end;
    }
    fields.push_back(std::move(field));
  }
  return fields;
}

/// Cuts a line at its blanks.
std::vector<TableField> words_of(std::string_view line) {
  std::vector<TableField> words;
  for (std::size_t i = line.find_first_not_of(blanks); i != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, i), line.size());
    words.push_back({std::string(line.substr(i, end - i)), static_cast<int>(i) + 1});
    i = line.find_first_not_of(blanks, end);
  }
  return words;
}

/// A word such as 12,5: all its commas stand between digits.
bool has_decimal_comma(std::string_view word) {
  const auto is_digit = [&](std::size_t i) { return i < word.size() && word[i] >= '0' && word[i] <= '9'; };
  const std::size_t comma = word.find(',');
  return comma != std::string_view::npos && comma > 0 && is_digit(comma - 1) && is_digit(comma + 1) &&
         word.find(',', comma + 1) == std::string_view::npos;
}

}  // namespace

std::string_view without_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return text.substr(text.size());
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

char separator_of(std::string_view heads) {
  for (const char c : {';', '\t', ','})
    if (heads.find(c) != std::string_view::npos) return c;
  const bool has_brackets = heads.find_first_of("[({\"") != std::string_view::npos;
  return !has_brackets && words_of(heads).size() > 1 ? ' ' : ',';
}

char named_separator(std::string_view line) {
  line = without_blanks(line);
  if (line.size() > 2 && line.front() == '"' && line.back() == '"') line = line.substr(1, line.size() - 2);
  return line.size() == 5 && lower(line.substr(0, 4)) == "sep=" ? line[4] : '\0';
}

std::vector<TableField> fields_apart_by(char separator, std::string_view line) {
  return separator == ' ' ? words_of(line) : fields_of(line, separator);
}

std::string field_between_tabs(std::string text) {
  for (char& c : text)
    if (c == '\t' || c == '\n' || c == '\r') c = ' ';
  if (text.find('"') == text.npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::vector<TableField> bare_fields(std::string_view line, std::size_t expected) {
  if (line.find(';') != std::string_view::npos) {
    std::vector<TableField> fields = fields_of(line, ';');
    while (!fields.empty() && fields.back().text.empty()) fields.pop_back();
    return fields;
  }
  std::vector<TableField> words = words_of(line);
  const bool is_plain = std::all_of(words.begin(), words.end(), [](const TableField& word) {
    return word.text.find(',') == std::string::npos || has_decimal_comma(word.text);
  });
  if (words.size() == expected && is_plain) return words;
  std::vector<TableField> fields;
  for (const TableField& word : words)
    for (std::size_t i = 0; i < word.text.size();) {
      const std::size_t end = std::min(word.text.find(',', i), word.text.size());
      if (end > i) fields.push_back({word.text.substr(i, end - i), word.at + static_cast<int>(i)});
      i = end + 1;
    }
  return fields;
}

bool opens_quote(std::string_view line) {
  bool is_open = false, at_begin = true;
  for (const char c : line) {
    if (is_open)
      is_open = c != '"';  // a doubled quote closes and opens
    else
      is_open = c == '"' && at_begin;
    at_begin = c == ',' || c == ';' || c == '\t' || c == '"' || (at_begin && c == ' ');
  }
  return is_open;
}

std::string other_format(std::string_view bytes) {
  constexpr std::string_view compound_file = "\xd0\xcf\x11\xe0";
  constexpr std::string_view encrypted_part("E\0n\0c\0r\0y\0p\0t\0e\0d\0P\0a\0c\0k\0a\0g\0e\0", 32);
  if (bytes.starts_with(compound_file))
    return bytes.find(encrypted_part) != bytes.npos ? "is protected by a password: save it without one"
                                                    : "is a workbook of an old form (xls), expected .xlsx, "
                                                      ".ods or CSV UTF-8: save it as one of these";
  const std::string_view begin =
      bytes.substr(std::min(bytes.find_first_not_of("\xef\xbb\xbf \r\n\t"), bytes.size()));
  constexpr std::string_view not_tables[] = {"<", "{\\rtf", "%PDF", "ID;P", "TABLE\r\n0,1", "TABLE\n0,1"};
  for (const std::string_view other : not_tables)
    if (begin.starts_with(other))
      return "is no table of text, as its first line shows (a page, XML, DIF or SYLK), expected .xlsx, .ods "
             "or "
             "CSV UTF-8: save it as one of these";
  if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff"))
    return "is a text in UTF-16, expected UTF-8: save it as CSV UTF-8";
  return {};
}

}  // namespace flyrock
