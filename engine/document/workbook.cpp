#include "document/workbook.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <set>

#include "document/printable.h"
#include "document/table_lines.h"
#include "document/wording.h"
#include "document/zip_archive.h"
#include "units/units.h"

namespace flyrock {

namespace {

constexpr std::size_t most_rows = 1'048'576, most_columns = 16'384, most_cells = 2'000'000;

/// Names without the prefix of their namespace, which programs choose as they like.
std::string_view local(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == name.npos ? name : name.substr(colon + 1);
}

pugi::xml_node child(pugi::xml_node node, std::string_view name) {
  for (const pugi::xml_node one : node.children())
    if (local(one.name()) == name) return one;
  return {};
}

std::string_view attribute(pugi::xml_node node, std::string_view name) {
  for (const pugi::xml_attribute one : node.attributes())
    if (local(one.name()) == name) return one.value();
  return {};
}

template <class Visit>
void for_each(pugi::xml_node node, std::string_view name, Visit visit) {
  for (const pugi::xml_node one : node.children())
    if (local(one.name()) == name) visit(one);
}

std::size_t count_of(std::string_view text, std::size_t otherwise) {
  std::size_t value = otherwise;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  return code == std::errc() && end == text.data() + text.size() ? value : otherwise;
}

/// The cells of a sheet while it is read; rows and columns count from 0.
class Cells {
 public:
  void put(std::size_t row, std::size_t column, std::string text) {
    if (text.empty()) return;
    if (row >= most_rows || column >= most_columns)
      throw WorkbookFault(0, fmt::format("has a cell in row {} and column {}, expected at most {} and {}",
                                         row + 1, column + 1, most_rows, most_columns));
    if (++count_ > most_cells)
      throw WorkbookFault(0,
                          fmt::format("has a sheet of more than {} cells: save it as CSV UTF-8", most_cells));
    if (row >= rows_.size()) rows_.resize(row + 1);
    rows_[row][column] = std::move(text);
    width_ = std::max(width_, column + 1);
  }

  void hide(std::size_t row, std::size_t count = 1) { hidden_.emplace_back(row, row + count); }

  std::size_t hidden_rows() const {
    std::size_t count = 0;
    for (const auto& [begin, end] : hidden_)
      for (std::size_t row = begin; row < std::min(end, rows_.size()); ++row) count += !rows_[row].empty();
    return count;
  }

  bool has(std::size_t row, std::size_t column) const {
    return row < rows_.size() && rows_[row].contains(column);
  }

  std::vector<std::string> lines() const {
    if (rows_.size() * width_ > 20 * most_cells)
      throw WorkbookFault(0,
                          fmt::format("has a sheet whose values lie in {} rows and {} columns, most of them "
                                      "empty: save the table alone",
                                      rows_.size(), width_));
    std::vector<std::string> result;
    for (const auto& row : rows_) {
      std::string& line = result.emplace_back();
      if (row.empty()) continue;
      for (std::size_t column = 0; column < width_; ++column) {
        if (column > 0) line += '\t';
        if (const auto found = row.find(column); found != row.end())
          line += field_between_tabs(found->second);
      }
    }
    return result;
  }

 private:
  std::vector<std::map<std::size_t, std::string>> rows_;
  std::vector<std::pair<std::size_t, std::size_t>> hidden_;
  std::size_t width_ = 0, count_ = 0;
};

/// "C5" of column 2 and row 4.
std::string cell_name(std::size_t row, std::size_t column) {
  std::string letters;
  for (std::size_t left = column + 1; left > 0; left = (left - 1) / 26)
    letters.insert(letters.begin(), static_cast<char>('A' + (left - 1) % 26));
  return fmt::format("{}{}", letters, row + 1);
}

[[noreturn]] void refuse_merged(std::size_t row, std::size_t column) {
  throw WorkbookFault(static_cast<int>(row) + 1,
                      fmt::format("the cell {} is merged with others, so their rows or columns have no value "
                                  "of their own: unmerge them",
                                  cell_name(row, column)));
}

[[noreturn]] void refuse_formula(std::size_t row, std::size_t column) {
  throw WorkbookFault(static_cast<int>(row) + 1,
                      fmt::format("the formula of the cell {} was never computed: open the workbook in a "
                                  "spreadsheet program and save it",
                                  cell_name(row, column)));
}

/// The sheet of a name among all of a workbook.
std::size_t chosen(const std::vector<std::string>& names, const std::string& name) {
  std::vector<std::string> shown;
  for (const std::string& one : names) shown.push_back(printable(one, 60));
  if (names.empty()) throw WorkbookFault(0, "has no sheet");
  if (name.empty() && names.size() == 1) return 0;
  if (name.empty())
    throw WorkbookFault(0, fmt::format("has {} sheets, {}: write the one that is the table as `FILE#{}`",
                                       names.size(), choice_text(shown), shown.front()));
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw WorkbookFault(0, fmt::format("has no sheet `{}`{}", printable(name, 60), suggestion(name, shown)));
  return static_cast<std::size_t>(found - names.begin());
}

class XmlPart {
 public:
  XmlPart(const ZipArchive& archive, const std::string& name) : bytes_(archive.read(name)) {
    if (!document_.load_buffer_inplace(bytes_.data(), bytes_.size(),
                                       pugi::parse_default | pugi::parse_ws_pcdata_single))
      throw WorkbookFault(0, fmt::format("is damaged: its part `{}` is no complete XML", name));
  }
  pugi::xml_node root() const { return document_.document_element(); }

 private:
  std::string bytes_;
  pugi::xml_document document_;
};

// ---------------------------------------------------------------------------------------------------- xlsx

bool is_true(std::string_view flag) { return flag == "1" || flag == "true"; }

/// Whether a format of numbers shows them as a date or a time: it has a letter of one outside of quotes,
/// brackets (colours, conditions) and after no backslash. [h]:mm, the time that has passed, is one as well.
bool is_date_format(std::string_view format) {
  for (std::size_t i = 0; i < format.size(); ++i) {
    const char c = format[i];
    if (c == '"')
      i = std::min(format.find('"', i + 1), format.size());
    else if (c == '\\' || c == '_' || c == '*')
      ++i;
    else if (c == '[') {
      const std::size_t end = std::min(format.find(']', i), format.size());
      if (format.substr(i + 1, end - i - 1).find_first_not_of("hHmMsS") == format.npos) return true;
      i = end;
    } else if (std::string_view("dDmMyYhHsS").find(c) != std::string_view::npos)
      return true;
    else if (lower(format.substr(i, 7)) == "general")
      i += 6;
  }
  return false;
}

/// Whether a format shows a number as a share of 100.
bool is_share_format(std::string_view format) {
  for (std::size_t i = 0; i < format.size(); ++i)
    if (format[i] == '"')
      i = std::min(format.find('"', i + 1), format.size());
    else if (format[i] == '\\')
      ++i;
    else if (format[i] == '%')
      return true;
  return false;
}

/// 0.25 as 25%, which is what the sheet shows and what its head may mean.
std::string share_text(double number) { return fmt::format("{:.15g}%", 100 * number); }

/// A day and time of day, counted in days from 1899-12-30 (or 1904-01-01).
std::string date_text(double days, bool from_1904) {
  using namespace std::chrono;
  constexpr double last_day = 2'958'466;  // of the year 9999
  if (!(days >= 0 && days < last_day)) return fmt::format("date {}", days);
  const auto whole = static_cast<int>(std::floor(days + 0.5 / 86400));
  const long seconds = std::max(std::lround((days - whole) * 86400), 0L);
  const std::string time = fmt::format("{:02}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
  if (whole == 0 && !from_1904) return time;
  const sys_days origin = from_1904 ? sys_days(year(1904) / 1 / 1) : sys_days(year(1899) / 12 / 30);
  const year_month_day date(origin + std::chrono::days(whole));
  const std::string day = fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                                      static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
  return seconds == 0 ? day : day + " " + time;
}

class Xlsx {
 public:
  explicit Xlsx(const ZipArchive& archive) : archive_(archive) {}

  Sheet read(const std::string& name) {
    const std::string book = book_part();
    const XmlPart workbook(archive_, book);
    from_1904_ = is_true(attribute(child(workbook.root(), "workbookPr"), "date1904"));
    std::vector<std::string> names, links;
    for_each(child(workbook.root(), "sheets"), "sheet", [&](pugi::xml_node sheet) {
      names.emplace_back(attribute(sheet, "name"));
      links.emplace_back(attribute(sheet, "id"));
    });
    const std::size_t index = chosen(names, name);
    const std::map<std::string, std::string> parts = links_of(book);
    const auto part = parts.find(links[index]);
    if (part == parts.end())
      throw WorkbookFault(0,
                          fmt::format("is damaged: the sheet `{}` has no part", printable(names[index], 60)));
    const std::string beside = book.substr(0, book.rfind('/') + 1);
    read_texts(beside + "sharedStrings.xml");
    read_styles(beside + "styles.xml");
    read_cells(XmlPart(archive_, part->second).root());
    return {names[index], cells_.lines(), cells_.hidden_rows()};
  }

 private:
  static std::string absolute(const std::string& part, const std::string& target) {
    if (target.starts_with('/')) return target.substr(1);
    std::string folder = part.substr(0, part.rfind('/') + 1);
    std::string_view rest = target;
    while (rest.starts_with("../") && !folder.empty()) {
      folder.pop_back();
      folder.resize(folder.rfind('/') + 1);
      rest.remove_prefix(3);
    }
    return folder + std::string(rest);
  }

  /// The parts to which a part links, by the ids of the links.
  std::map<std::string, std::string> links_of(const std::string& part) const {
    const std::size_t name = part.rfind('/') + 1;
    const XmlPart links(archive_, part.substr(0, name) + "_rels/" + part.substr(name) + ".rels");
    std::map<std::string, std::string> result;
    for_each(links.root(), "Relationship", [&](pugi::xml_node link) {
      result[std::string(attribute(link, "Id"))] = absolute(part, std::string(attribute(link, "Target")));
    });
    return result;
  }

  std::string book_part() const {
    constexpr const char* usual = "xl/workbook.xml";
    if (archive_.has(usual) || !archive_.has("_rels/.rels")) return usual;
    const XmlPart links(archive_, "_rels/.rels");
    std::string found = usual;
    for_each(links.root(), "Relationship", [&](pugi::xml_node link) {
      if (attribute(link, "Type").ends_with("/officeDocument"))
        found = absolute("", std::string(attribute(link, "Target")));
    });
    return found;
  }

  /// A text, or the pieces of a formatted one; what stands above it to help to read it is none of it.
  static std::string text_of(pugi::xml_node node) {
    std::string text;
    for (const pugi::xml_node one : node.children()) {
      if (local(one.name()) == "t") text += one.child_value();
      if (local(one.name()) == "r") text += text_of(one);
    }
    return text;
  }

  void read_texts(const std::string& part) {
    if (!archive_.has(part)) return;
    const XmlPart texts(archive_, part);
    for_each(texts.root(), "si", [&](pugi::xml_node text) { texts_.push_back(text_of(text)); });
  }

  void read_styles(const std::string& part) {
    if (!archive_.has(part)) return;
    const XmlPart styles(archive_, part);
    std::set<std::size_t> dates = {14, 15, 16, 17, 18, 19, 20, 21, 22, 45, 46, 47};  // of every workbook
    std::set<std::size_t> shares = {9, 10};
    for_each(child(styles.root(), "numFmts"), "numFmt", [&](pugi::xml_node format) {
      const std::size_t id = count_of(attribute(format, "numFmtId"), 0);
      const std::string_view code = attribute(format, "formatCode");
      dates.erase(id);
      shares.erase(id);
      if (is_date_format(code)) dates.insert(id);
      if (is_share_format(code)) shares.insert(id);
    });
    for_each(child(styles.root(), "cellXfs"), "xf", [&](pugi::xml_node style) {
      const std::size_t id = count_of(attribute(style, "numFmtId"), 0);
      is_date_.push_back(dates.contains(id));
      is_share_.push_back(shares.contains(id));
    });
  }

  void read_cells(pugi::xml_node sheet) {
    std::size_t row = 0;
    for_each(child(sheet, "sheetData"), "row", [&](pugi::xml_node line) {
      row = count_of(attribute(line, "r"), row + 1);
      if (row == 0) throw WorkbookFault(0, "is damaged: a row has the number 0");
      if (is_true(attribute(line, "hidden"))) cells_.hide(row - 1);
      std::size_t column = 0;
      for_each(line, "c", [&](pugi::xml_node cell) {
        column = column_of(attribute(cell, "r"), column + 1);
        cells_.put(row - 1, column - 1, cell_text(cell, row - 1, column - 1));
      });
    });
    for_each(child(sheet, "mergeCells"), "mergeCell", [&](pugi::xml_node merged) {
      const std::string_view range = attribute(merged, "ref");
      const std::string_view first = range.substr(0, range.find(':'));
      const std::size_t digits = std::min(first.find_first_of("0123456789"), first.size());
      const std::size_t at = count_of(first.substr(digits), 0), column = column_of(first, 0);
      if (at > 0 && column > 0 && cells_.has(at - 1, column - 1)) refuse_merged(at - 1, column - 1);
    });
  }

  /// The number of a column: 3 for "C5".
  static std::size_t column_of(std::string_view name, std::size_t otherwise) {
    std::size_t column = 0;
    for (const char c : name) {
      if (c < 'A' || c > 'Z' || column > most_columns) break;
      column = column * 26 + static_cast<std::size_t>(c - 'A') + 1;
    }
    return column == 0 ? otherwise : column;
  }

  std::string cell_text(pugi::xml_node cell, std::size_t row, std::size_t column) const {
    const std::string_view type = attribute(cell, "t");
    if (type == "inlineStr") return text_of(child(cell, "is"));
    const std::string value = child(cell, "v").child_value();
    if (value.empty() && child(cell, "f")) {
      if (type == "str") return {};  // its result is an empty text
      refuse_formula(row, column);
    }
    if (type == "b") return value == "1" ? "TRUE" : "FALSE";
    if (type == "s") {
      const std::size_t index = count_of(value, texts_.size());
      if (index >= texts_.size())
        throw WorkbookFault(static_cast<int>(row) + 1,
                            fmt::format("the text of the cell {} is missing, the workbook is damaged",
                                        cell_name(row, column)));
      return texts_[index];
    }
    if (!type.empty() && type != "n") return value;
    const auto number = parse_number(value);
    if (!number) return value;
    const std::size_t style = count_of(attribute(cell, "s"), 0);
    if (style < is_date_.size() && is_date_[style]) return date_text(*number, from_1904_);
    return style < is_share_.size() && is_share_[style] ? share_text(*number) : fmt::format("{}", *number);
  }

  const ZipArchive& archive_;
  bool from_1904_ = false;
  std::vector<std::string> texts_;
  std::vector<bool> is_date_, is_share_;  ///< of the styles
  Cells cells_;
};

// ----------------------------------------------------------------------------------------------------- ods

class Ods {
 public:
  explicit Ods(const ZipArchive& archive) : archive_(archive) {}

  Sheet read(const std::string& name) {
    constexpr const char* manifest = "META-INF/manifest.xml";
    if (archive_.has(manifest) && archive_.read(manifest).find("encryption-data") != std::string::npos)
      throw WorkbookFault(0, "is protected by a password: save it without one");
    const XmlPart content(archive_, "content.xml");
    const pugi::xml_node book = child(child(content.root(), "body"), "spreadsheet");
    if (!book) throw WorkbookFault(0, "is no workbook, expected .xlsx or .ods");
    std::vector<std::string> names;
    std::vector<pugi::xml_node> sheets;
    for_each(book, "table", [&](pugi::xml_node sheet) {
      names.emplace_back(attribute(sheet, "name"));
      sheets.push_back(sheet);
    });
    const std::size_t index = chosen(names, name);
    read_rows(sheets[index]);
    return {names[index], cells_.lines(), cells_.hidden_rows()};
  }

 private:
  /// Rows stand in groups and heads too.
  void read_rows(pugi::xml_node node) {
    for (const pugi::xml_node one : node.children()) {
      const std::string_view name = local(one.name());
      if (name == "table-row")
        read_row(one);
      else if (name == "table-rows" || name == "table-row-group" || name == "table-header-rows")
        read_rows(one);
    }
  }

  void read_row(pugi::xml_node line) {
    const std::size_t rows = std::max<std::size_t>(count_of(attribute(line, "number-rows-repeated"), 1), 1);
    const std::string_view visibility = attribute(line, "visibility");
    if (visibility == "collapse" || visibility == "filter") cells_.hide(row_, rows);
    std::size_t column = 0;
    for (const pugi::xml_node cell : line.children()) {
      const std::string_view kind = local(cell.name());
      if (kind != "table-cell" && kind != "covered-table-cell") continue;
      const std::size_t columns =
          std::max<std::size_t>(count_of(attribute(cell, "number-columns-repeated"), 1), 1);
      const std::string text = cell_text(cell, column);
      if (!text.empty()) {
        if (count_of(attribute(cell, "number-columns-spanned"), 1) > 1 ||
            count_of(attribute(cell, "number-rows-spanned"), 1) > 1)
          refuse_merged(row_, column);
        for (std::size_t r = 0; r < rows; ++r)
          for (std::size_t c = 0; c < columns; ++c) cells_.put(row_ + r, column + c, text);
      }
      column += std::min(columns, most_columns);
    }
    row_ += std::min(rows, most_rows);
  }

  static std::string text_of(pugi::xml_node node) {
    std::string text;
    for (const pugi::xml_node one : node.children()) {
      const std::string_view name = local(one.name());
      if (one.type() == pugi::node_pcdata || one.type() == pugi::node_cdata)
        text += one.value();
      else if (name == "s")
        text += std::string(std::min<std::size_t>(count_of(attribute(one, "c"), 1), 100), ' ');
      else if (name == "tab" || name == "line-break")
        text += ' ';
      else
        text += text_of(one);
    }
    return text;
  }

  std::string cell_text(pugi::xml_node cell, std::size_t column) const {
    const std::string_view type = attribute(cell, "value-type");
    if (type.empty() && !attribute(cell, "formula").empty()) refuse_formula(row_, column);
    if (type == "float" || type == "percentage" || type == "currency") {
      const std::string value(attribute(cell, "value"));
      const auto number = parse_number(value);
      if (!number) return value;
      return type == "percentage" ? share_text(*number) : fmt::format("{}", *number);
    }
    if (type == "date") return std::string(attribute(cell, "date-value"));
    if (type == "time") return std::string(attribute(cell, "time-value"));
    if (type == "boolean") return attribute(cell, "boolean-value") == "true" ? "TRUE" : "FALSE";
    std::string text;
    for_each(cell, "p", [&](pugi::xml_node paragraph) {
      if (!text.empty()) text += ' ';
      text += text_of(paragraph);
    });
    return text;
  }

  const ZipArchive& archive_;
  std::size_t row_ = 0;
  Cells cells_;
};

}  // namespace

SheetName sheet_name(const std::string& text) {
  for (const std::string_view ending : {".xlsx#", ".xlsm#", ".ods#", ".xls#", ".gpkg#"})
    if (const std::size_t at = lower(text).find(ending); at != text.npos) {
      const std::size_t mark = at + ending.size() - 1;
      return {text.substr(0, mark), text.substr(mark + 1)};
    }
  return {text, ""};
}

bool is_workbook(std::string_view begin) { return begin.starts_with("PK"); }

Sheet read_sheet(std::string_view bytes, const std::string& name) {
  try {
    const ZipArchive archive(bytes);
    return archive.has("content.xml") ? Ods(archive).read(name) : Xlsx(archive).read(name);
  } catch (const ZipFault& fault) {
    throw WorkbookFault(0, fault.what());
  }
}

}  // namespace flyrock
