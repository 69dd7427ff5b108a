#include "document/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "document/printable.h"
#include "document/table_lines.h"
#include "document/wording.h"

namespace flyrock {

namespace {

constexpr std::size_t most_errors = 20;

/// As programs write numbers: +1.5, 007, 1E3.
std::optional<double> number_of(std::string_view text) {
  std::string plain(text);
  std::size_t at = plain.starts_with('-') || plain.starts_with('+') ? 1 : 0;
  while (at + 1 < plain.size() && plain[at] == '0' && plain[at + 1] >= '0' && plain[at + 1] <= '9')
    plain.erase(at, 1);
  if (plain.starts_with('+')) plain.erase(0, 1);
  return parse_number(plain);
}

/// No head begins with a digit.
bool begins_with_number(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t+-.");
  return first != std::string_view::npos && line[first] >= '0' && line[first] <= '9';
}

/// Rows below the records of a spreadsheet that sum them up.
bool is_summary(std::string_view name) {
  constexpr std::array words = {"total",   "totals", "subtotal", "sum", "mean",
                                "average", "avg",    "median",   "std", "stdev"};
  while (name.ends_with(':') || name.ends_with('.')) name.remove_suffix(1);
  return std::find(words.begin(), words.end(), lower(without_blanks(name))) != words.end();
}

/// The column that a head nobody asked for may have meant.
std::string meant_column(std::string_view head, const std::vector<std::string>& columns) {
  std::string_view name = without_blanks(head.substr(0, head.find_first_of("([{,")));
  while (!name.empty()) {
    if (const std::string hint = did_you_mean(lower(name), columns); !hint.empty()) return hint;
    const std::size_t last = name.find_last_of(" _-.");
    name = last == std::string_view::npos ? std::string_view() : name.substr(0, last);
  }
  return {};
}

std::vector<std::string> texts(const std::vector<TableField>& fields) {
  std::vector<std::string> result;
  for (const TableField& field : fields) result.push_back(field.text);
  return result;
}

}  // namespace

const TextTable::Cell* TextTable::cell(std::size_t row, std::string_view column) const {
  const auto found = columns_.find(column);
  return found == columns_.end() ? nullptr : &found->second.cells.at(row);
}

bool TextTable::has(std::string_view column) const { return columns_.contains(column); }

std::optional<double> TextTable::number(std::size_t row, std::string_view column) const {
  const Cell* found = cell(row, column);
  return found && found->is_number ? std::optional(found->number) : std::nullopt;
}

std::string_view TextTable::text(std::size_t row, std::string_view column) const {
  const Cell* found = cell(row, column);
  return found ? std::string_view(found->text) : std::string_view();
}

Location TextTable::at(std::size_t row, std::string_view column) const {
  const Cell* found = cell(row, column);
  return {source_, lines_.at(row), found ? found->at : 1};
}

std::string_view TextTable::head(std::string_view column) const {
  const auto found = columns_.find(column);
  return found == columns_.end() ? column : std::string_view(found->second.head);
}

Location TextTable::head_at(std::string_view column) const {
  const auto found = columns_.find(column);
  return found == columns_.end() ? Location{source_, 1, 1}
                                 : Location{source_, found->second.line, found->second.at};
}

std::string_view TextTable::unit(std::string_view column) const {
  const auto found = columns_.find(column);
  return found == columns_.end() ? std::string_view() : std::string_view(found->second.unit.text);
}

std::string TextTable::shown(std::string_view column, double si) const {
  const HeadUnit& unit = columns_.find(column)->second.unit;
  const std::string name = unit.text.empty() ? si_unit(unit.unit.dimension) : unit.text;
  return fmt::format("{:.10g}{}{}", si / unit.unit.factor, name == "1" ? "" : " ", name == "1" ? "" : name);
}

std::string TextTable::summary() const {
  std::vector<std::pair<std::string, const Column*>> in_order;
  for (const auto& [name, column] : columns_) in_order.emplace_back(name, &column);
  std::sort(in_order.begin(), in_order.end(),
            [](const auto& a, const auto& b) { return a.second->place < b.second->place; });
  std::string text = fmt::format("{} row{}", rows_, rows_ == 1 ? "" : "s");
  if (hidden_rows_ > 0) text += fmt::format(", {} of them hidden in the sheet", hidden_rows_);
  const char* separator = "; ";
  for (const auto& [name, column] : in_order) {
    if (column->is_text) continue;
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (const Cell& one : column->cells) {
      if (!one.is_number) continue;
      least = std::min(least, one.number);
      greatest = std::max(greatest, one.number);
    }
    text += fmt::format("{}{} ", separator, name);
    separator = ", ";
    if (least > greatest)
      text += "empty";
    else if (least == greatest)
      text += shown(name, least);
    else
      text += fmt::format("{:.10g} to {}", least / column->unit.unit.factor, shown(name, greatest));
  }
  separator = "; not read: ";
  for (const std::string& head : ignored_) {
    text += fmt::format("{}`{}`{}", separator, printable(head), meant_column(head, known_));
    separator = ", ";
  }
  return text;
}

class TextTableReader {
 public:
  TextTableReader(std::span<const TableColumn> columns, const std::map<std::string, std::string>& heads,
                  const Node& where, Diagnostics& diagnostics, TableForm form)
      : columns_(columns), heads_(heads), where_(where), diagnostics_(diagnostics), form_(form) {}

  std::optional<TextTable> read(const std::string& path) {
    try {
      return read(read_table_text(path), path);
    } catch (const TableTextFault& fault) {
      source_ = fault.source;
      if (source_)
        fail_at(fault.line, 1, fault.what());
      else
        where_.error(diagnostics_, fault.what());
      return std::nullopt;
    }
  }

  std::optional<TextTable> read(const TableText& text, const std::string& path) {
    const std::size_t before = diagnostics_.errors_given();
    source_ = text.source;
    is_sheet_ = text.is_sheet;
    line_ = next_line_ = 1;
    if (read_heads()) {
      while (next_record())
        if (!without_blanks(record_).empty()) read_row();
      check_rows();
    }
    if (errors_ > most_errors)
      where_.error(diagnostics_,
                   fmt::format("{} has {} more errors like these", path, errors_ - most_errors));
    if (diagnostics_.errors_given() > before) return std::nullopt;
    table_.source_ = source_;
    table_.hidden_rows_ = text.hidden_rows;
    table_.known_ = names_of(columns_);
    return std::move(table_);
  }

 private:
  struct Use {
    const TableColumn* column = nullptr;
    TextTable::Column* to = nullptr;
  };

  void fail(int at, const std::string& text) { fail_at(static_cast<int>(line_), at, text); }

  void fail_at(int line, int at, const std::string& text) {
    if (++errors_ <= most_errors) diagnostics_.error({source_, line, at}, where_.path, text);
  }

  /// The text of a line, without its comment, and with plain blanks.
  std::string content(std::size_t line) const {
    std::string text = source_->lines[line - 1];
    if (form_ == TableForm::points) text.resize(std::min(text.find('#'), text.size()));
    constexpr std::string_view no_break = "\xc2\xa0";
    for (std::size_t at; (at = text.find(no_break)) != std::string::npos;) text.replace(at, 2, " ");
    return text;
  }

  /// Goes to the next line, with those into which a quote of it goes on. False at the end of the file.
  bool next_record() {
    if (next_line_ > source_->lines.size()) return false;
    line_ = next_line_++;
    record_ = content(line_);
    if (form_ == TableForm::points) return true;
    while (opens_quote(record_) && next_line_ <= source_->lines.size())
      record_ += " " + content(next_line_++);
    if (opens_quote(record_)) fail(1, "the line opens a quote that is never closed");
    return true;
  }

  char separator_of_line(std::string_view line) const { return is_sheet_ ? '\t' : separator_of(line); }

  bool read_heads() {
    while (next_record() && without_blanks(record_).empty() && next_line_ <= source_->lines.size()) {
    }
    const char named = form_ == TableForm::heads && !is_sheet_ ? named_separator(record_) : '\0';
    if (named != '\0') next_record();
    if (form_ == TableForm::points && begins_with_number(record_)) {
      take_bare_columns();
      return true;
    }
    separator_ = named != '\0' ? named : separator_of_line(record_);
    for (const auto& [name, head] : heads_)
      if (without_blanks(record_) == head && !is_sheet_)
        separator_ = ',';  // one column, whose head has blanks
    const std::vector<TableField> heads = fields_apart_by(separator_, record_);
    if (known_heads(heads) == 0)
      if (const std::size_t line = line_of_heads(); line > 0) {
        fail(1, fmt::format("line {} has no known head, line {} has: delete the lines above line {}", line_,
                            line, line));
        return false;
      }
    const std::size_t before = errors_;
    take_heads(heads);
    bool is_missing = false;
    for (const TableColumn& column : columns_)
      if (column.required && !table_.has(column.name)) {
        fail(1, missing(column));
        is_missing = true;
      }
    for (const auto& [name, head] : heads_)
      if (std::none_of(heads.begin(), heads.end(),
                       [&](const TableField& field) { return field.text == head; }))
        fail(1, fmt::format("no head is `{}`, which `columns` names for `{}`{}", printable(head), name,
                            suggestion(head, texts(heads))));
    if (!is_missing && errors_ == before && known_heads(heads) == 0)
      fail(1, fmt::format("no head of a value is known, expected heads such as {}", examples()));
    return errors_ == before;
  }

  /// The number of heads that are columns, but names.
  std::size_t known_heads(const std::vector<TableField>& heads) const {
    return static_cast<std::size_t>(std::count_if(heads.begin(), heads.end(), [&](const TableField& head) {
      const TableColumn* column = mapped_column(head.text);
      if (!column) column = match_head(head.text, columns_, heads_).column;
      return column && !column->is_text;
    }));
  }

  /// The first line after this one that has known heads; 0: none of the next hundred.
  std::size_t line_of_heads() const {
    constexpr std::size_t most = 100;
    for (std::size_t line = next_line_; line <= source_->lines.size() && line < next_line_ + most; ++line) {
      const std::string text = content(line);
      if (known_heads(fields_apart_by(separator_of_line(text), text)) > 0) return line;
    }
    return 0;
  }

  std::string examples() const {
    std::vector<std::string> names;
    constexpr std::size_t few = 6;
    for (const TableColumn& column : columns_)
      if (!column.is_text && names.size() < few) names.push_back(column.name);
    return choice_text(names);
  }

  /// The line is the first record, which is read next.
  void take_bare_columns() {
    is_bare_ = true;
    separator_ = is_sheet_ ? '\t' : ' ';
    for (const TableColumn& column : columns_) use(column, {column.name, 1}, {{1, column.dimension}, ""});
    next_line_ = line_;
  }

  std::string missing(const TableColumn& column) const {
    const std::string unit = column.is_text ? "" : si_unit(column.dimension);
    const std::string example =
        unit.empty() || unit == "1" ? "" : fmt::format(" (in {}, or `{}` with a unit)", unit, column.name);
    return fmt::format("no column is `{}`{}{}", column.name, example,
                       table_.ignored_.empty() ? "" : did_you_mean(column.name, table_.ignored_));
  }

  /// The column for which `columns` names a head.
  const TableColumn* mapped_column(std::string_view head) const {
    for (const auto& [name, mapped] : heads_)
      if (head == mapped)
        for (const TableColumn& column : columns_)
          if (column.name == name) return &column;
    return nullptr;
  }

  /// Finds the column of each head. Of several names of a column of texts the first of its list counts, as
  /// `hole` before `id`.
  void take_heads(const std::vector<TableField>& heads) {
    std::vector<HeadMatch> matches;
    for (const TableField& head : heads) {
      HeadMatch match;
      if ((match.column = mapped_column(head.text)) != nullptr)
        match.unit = unit_at_end(head.text, match.column->dimension);
      else
        match = match_head(head.text, columns_, heads_);
      matches.push_back(std::move(match));
    }
    for (std::size_t i = 0; i < heads.size(); ++i) {
      HeadMatch& match = matches[i];
      const auto is_better = [&](const HeadMatch& other) {
        return other.column == match.column && other.name < match.name;
      };
      if (match.column && match.column->is_text && std::any_of(matches.begin(), matches.end(), is_better))
        match.column = nullptr;
      if (match.begun) fail(heads[i].at, unknown_rest(heads[i].text, match));
      if (match.column && table_.has(match.column->name)) {
        fail(heads[i].at,
             fmt::format("`{}` is a second column of `{}`", printable(heads[i].text), match.column->name));
        match.column = nullptr;
      }
      if (match.column)
        use(*match.column, heads[i], match.unit);
      else
        uses_.emplace_back();
      if (!match.column && !heads[i].text.empty()) table_.ignored_.push_back(heads[i].text);
    }
  }

  std::string unknown_rest(const std::string& head, const HeadMatch& match) const {
    const TableColumn& column = *match.begun;
    const std::string cure =
        form_ == TableForm::heads
            ? fmt::format("; `columns: {{ {}: HEAD }}` says which head it is", column.name)
            : std::string();
    if (column.is_text || column.dimension == dimension::none)
      return fmt::format(
          "`{}` begins with `{}` and goes on with `{}`, expected the name alone, or another name{}",
          printable(head), column.name, printable(match.rest), cure);
    const std::string unit = column.dimension == dimension::angle ? "deg" : si_unit(column.dimension);
    return fmt::format(
        "`{}` begins as `{}` does, but `{}` is no unit like {}: expected `{} [{}]`, or another name{}",
        printable(head), column.name, printable(match.rest), unit, column.name, unit, cure);
  }

  void use(const TableColumn& column, const TableField& head, const HeadUnit& unit) {
    TextTable::Column& to = table_.columns_[column.name];
    to = {{}, head.text, static_cast<int>(line_), head.at, unit, column.is_text, uses_.size()};
    uses_.push_back({&column, &to});
  }

  void read_row() {
    const std::vector<TableField> fields =
        is_bare_ && !is_sheet_ ? bare_fields(record_, uses_.size()) : fields_apart_by(separator_, record_);
    if (std::all_of(fields.begin(), fields.end(), [](const TableField& f) { return f.text.empty(); })) return;
    if (fields.size() != uses_.size()) return fail(1, wrong_count(fields.size()));
    table_.lines_.push_back(static_cast<int>(line_));
    ++table_.rows_;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (uses_[i].column) uses_[i].to->cells.push_back(read_cell(fields[i], uses_[i]));
      if (is_summary(fields[i].text) && (!uses_[i].column || uses_[i].column->is_text) &&
          is_first_text(fields, i))
        fail(fields[i].at, fmt::format("the row `{}` sums up others, and is no record: delete it",
                                       printable(fields[i].text)));
    }
  }

  /// Whether all fields before one are empty.
  static bool is_first_text(const std::vector<TableField>& fields, std::size_t index) {
    return std::all_of(fields.begin(), fields.begin() + static_cast<std::ptrdiff_t>(index),
                       [](const TableField& field) { return field.text.empty(); });
  }

  std::string wrong_count(std::size_t found) const {
    if (is_bare_) {
      const std::vector<std::string> names = names_of(columns_);
      return fmt::format("expected {} numbers, {} and {}, found {}{}", names.size() == 2 ? "two" : "three",
                         fmt::join(names.begin(), names.end() - 1, ", "), names.back(), found,
                         found == 2 * names.size() ? ": with commas in decimals, separate the numbers by "
                                                     "semicolons"
                                                   : "");
    }
    return fmt::format("the line has {} value{}, the heads are {}{}", found, found == 1 ? "" : "s",
                       uses_.size(), separator_hint(found));
  }

  /// Where another separator than that of the heads explains the line.
  std::string separator_hint(std::size_t found) const {
    constexpr std::pair<char, const char*> names[] = {
        {',', "commas"}, {';', "semicolons"}, {'\t', "tabs"}, {' ', "blanks"}};
    const auto name_of = [&](char separator) {
      const auto known = std::find_if(std::begin(names), std::end(names),
                                      [&](const auto& one) { return one.first == separator; });
      return known == std::end(names) ? fmt::format("`{}`", separator) : std::string(known->second);
    };
    if (separator_ == ',' && found == 2 * uses_.size())
      return ": with commas in decimals, separate the values by semicolons";
    for (const auto& [other, name] : names)
      if (other != separator_ && uses_.size() > 1 && fields_apart_by(other, record_).size() == uses_.size())
        return fmt::format(": its values are apart by {}, the heads by {}", name, name_of(separator_));
    return "";
  }

  TextTable::Cell read_cell(const TableField& field, const Use& use) {
    TextTable::Cell cell{field.text, 0, false, field.at};
    if (field.text.empty()) {
      if (use.column->required) fail(field.at, fmt::format("`{}` is empty", use.column->name));
    } else if (!use.column->is_text) {
      const bool is_share = field.text.ends_with('%') && use.column->dimension == dimension::none;
      std::string text = in_decimal_points(field);
      if (is_share) text.pop_back();
      const auto number = number_of(text);
      if (!number) fail(field.at, no_number(field.text, *use.column));
      cell.is_number = number.has_value();
      cell.number = is_share ? number.value_or(0) / 100
                             : Quantity{number.value_or(0), true, use.to->unit.unit, "", false}.si();
      needs_unit(cell, use);
    }
    return cell;
  }

  std::string no_number(const std::string& text, const TableColumn& column) const {
    if (table_.rows_ == 1 && unit_of_head(text, column.dimension) && column.dimension != dimension::none)
      return fmt::format("`{}` is a unit, expected it in the head of its column: `{} [{}]`", printable(text),
                         column.name, unit_of_head(text, column.dimension)->text);
    return fmt::format(
        "`{}` is not a number, expected `{}`{}", printable(text), column.name,
        is_sheet_ && is_date(text) ? ": the format of the cell is a date, expected one of numbers" : "");
  }

  /// Whether a text is a date of a sheet, 2026-11-28.
  static bool is_date(std::string_view text) {
    constexpr std::string_view form = "0000-00-00";
    if (text.size() < form.size()) return false;
    for (std::size_t i = 0; i < form.size(); ++i)
      if (form[i] == '-' ? text[i] != '-' : text[i] < '0' || text[i] > '9') return false;
    return true;
  }

  /// A number with a decimal point. A table has one decimal sign.
  std::string in_decimal_points(const TableField& field) {
    std::string text = field.text;
    const bool has_point = text.find('.') != std::string::npos;
    const std::size_t comma = has_point || separator_ == ',' ? std::string::npos : text.find(',');
    if (comma != std::string::npos) text[comma] = '.';
    if (!has_point && comma == std::string::npos) return text;
    Sign& own = signs_[has_point ? 0 : 1];
    const Sign& other = signs_[has_point ? 1 : 0];
    if (own.line > 0) return text;
    own = {field.text, static_cast<int>(line_)};
    if (other.line > 0)
      fail(field.at,
           fmt::format(
               "`{}` has a decimal {} and `{}` of line {} a {}, expected one sign in a table{}",
               printable(field.text), has_point ? "point" : "comma", printable(other.text), other.line,
               has_point ? "comma" : "point",
               is_sheet_ ? ": one of them is a text, make it a number in the spreadsheet program" : ""));
    return text;
  }

  /// A bare 17 of times is seconds or milliseconds, a bare 80 of angles degrees or radians.
  void needs_unit(const TextTable::Cell& cell, const Use& use) {
    const bool is_time = use.column->dimension == dimension::time;
    if (!is_time && use.column->dimension != dimension::angle) return;
    if (cell.number == 0 || !use.to->unit.text.empty()) return;
    const std::string& name = use.column->name;
    if (std::find(without_unit_.begin(), without_unit_.end(), name) != without_unit_.end()) return;
    without_unit_.push_back(name);
    fail_at(use.to->line, use.to->at,
            fmt::format("`{}` needs a unit: `{}_{}` or `{}_{}`?", printable(use.to->head), name,
                        is_time ? "ms" : "deg", name, is_time ? "s" : "rad"));
  }

  void check_rows() {
    if (table_.rows_ == 0 && errors_ == 0) return fail_at(1, 1, "the table has no line but its heads");
    const auto x = table_.columns_.find("x");
    if (errors_ > 0 || x == table_.columns_.end()) return;
    const std::vector<TextTable::Cell>& cells = x->second.cells;
    const auto is_placed = [](const TextTable::Cell& cell) { return cell.is_number; };
    if (std::none_of(cells.begin(), cells.end(), is_placed)) return;
    for (std::size_t row = 0; row < cells.size(); ++row)
      if (!is_placed(cells[row]) && !table_.number(row, "distance"))
        fail_at(table_.lines_[row], cells[row].at,
                "the row has no place `x`, others have: expected a place, or no row");
  }

  /// A number and where it was first seen.
  struct Sign {
    std::string text;
    int line = 0;
  };

  std::span<const TableColumn> columns_;
  const std::map<std::string, std::string>& heads_;
  const Node& where_;
  Diagnostics& diagnostics_;
  TableForm form_;
  bool is_bare_ = false;   ///< without heads
  bool is_sheet_ = false;  ///< of a workbook
  std::shared_ptr<const Source> source_;
  TextTable table_;
  std::vector<Use> uses_;
  std::string record_;                    ///< the line, without its comment
  std::size_t line_ = 1, next_line_ = 1;  ///< from 1
  char separator_ = ',';
  std::array<Sign, 2> signs_;              ///< the first number with a decimal point, and with a comma
  std::vector<std::string> without_unit_;  ///< columns that need a unit, each said once
  std::size_t errors_ = 0;
};

std::optional<TextTable> read_table(const std::string& path, std::span<const TableColumn> columns,
                                    const std::map<std::string, std::string>& heads, const Node& where,
                                    Diagnostics& diagnostics, TableForm form) {
  return TextTableReader(columns, heads, where, diagnostics, form).read(path);
}

std::optional<TextTable> read_table(const TableText& text, std::span<const TableColumn> columns,
                                    const std::map<std::string, std::string>& heads, const Node& where,
                                    Diagnostics& diagnostics) {
  return TextTableReader(columns, heads, where, diagnostics, TableForm::heads).read(text, text.source->name);
}

}  // namespace flyrock
