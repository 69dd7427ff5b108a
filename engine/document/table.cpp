#include "document/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <memory>

#include "document/printable.h"
#include "document/wording.h"
#include "units/units.h"

namespace flyrock {

namespace {

constexpr std::string_view blanks = " \t\r";
constexpr std::size_t most_errors = 20;

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return text.substr(text.size());
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// A unit as heads write it: `kg_per_m`, `m_s` for m/s, `m/s`. The reading that has the dimension counts.
std::optional<Unit> unit_of_head(std::string_view text, const Dimension& dimension) {
  std::string plain(text);
  if (const std::size_t per = plain.find("_per_"); per != std::string::npos) plain.replace(per, 5, "/");
  std::vector<std::string> readings;
  for (std::size_t cut = plain.find('_'); cut != std::string::npos; cut = plain.find('_', cut + 1)) {
    readings.push_back(plain);
    readings.back()[cut] = '/';
  }
  readings.push_back(plain);
  for (std::string& reading : readings) {
    std::replace(reading.begin(), reading.end(), '_', ' ');
    if (const auto unit = parse_unit(reading); unit && unit->dimension == dimension) return unit;
  }
  return std::nullopt;
}

/// The unit that follows a name in a head: "_kg", " [kg]", " (kg)"; nothing where that is no unit.
std::optional<Unit> trailing_unit(std::string_view rest, const Dimension& dimension) {
  rest = trimmed(rest);
  if (rest.size() > 2 &&
      ((rest.front() == '[' && rest.back() == ']') || (rest.front() == '(' && rest.back() == ')')))
    rest = rest.substr(1, rest.size() - 2);
  else if (rest.starts_with('_'))
    rest.remove_prefix(1);
  else
    return std::nullopt;
  return unit_of_head(trimmed(rest), dimension);
}

/// The unit of any head: of its longest end that is one.
Unit unit_at_end(std::string_view head, const Dimension& dimension) {
  for (std::size_t i = 0; i < head.size(); ++i)
    if (head[i] == '_' || head[i] == '[' || head[i] == '(')
      if (const auto unit = trailing_unit(head.substr(i), dimension)) return *unit;
  return {1, dimension};
}

struct Field {
  std::string text;
  int at = 1;
};

/// Cuts a line at its separators. A field in double quotes may hold them; "" is a quote in it.
std::vector<Field> fields_of(std::string_view line, char separator) {
  std::vector<Field> fields;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    while (i < line.size() && line[i] != separator && blanks.find(line[i]) != std::string_view::npos) ++i;
    Field field{"", static_cast<int>(i) + 1};
    if (i < line.size() && line[i] == '"') {
      for (++i; i < line.size(); ++i) {
        if (line[i] == '"' && (i + 1 >= line.size() || line[i + 1] != '"')) break;
        if (line[i] == '"') ++i;
        field.text += line[i];
      }
      i = std::min(line.find(separator, i), line.size());
    } else {
      const std::size_t end = std::min(line.find(separator, i), line.size());
      field.text = trimmed(line.substr(i, end - i));
      i = end;
    }
    fields.push_back(std::move(field));
  }
  return fields;
}

/// Cuts a line at its blanks.
std::vector<Field> words_of(std::string_view line) {
  std::vector<Field> words;
  for (std::size_t i = line.find_first_not_of(blanks); i != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, i), line.size());
    words.push_back({std::string(line.substr(i, end - i)), static_cast<int>(i) + 1});
    i = line.find_first_not_of(blanks, end);
  }
  return words;
}

std::vector<Field> fields_apart_by(char separator, std::string_view line) {
  return separator == ' ' ? words_of(line) : fields_of(line, separator);
}

/// Blanks are separators where nothing else is and no unit stands in brackets.
char separator_of(std::string_view heads) {
  for (const char c : {';', '\t', ','})
    if (heads.find(c) != std::string_view::npos) return c;
  const bool has_brackets = heads.find_first_of("[(\"") != std::string_view::npos;
  return !has_brackets && words_of(heads).size() > 1 ? ' ' : ',';
}

/// A word such as 12,5: all its commas stand between digits.
bool has_decimal_comma(std::string_view word) {
  const auto is_digit = [&](std::size_t i) { return i < word.size() && word[i] >= '0' && word[i] <= '9'; };
  const std::size_t comma = word.find(',');
  return comma != std::string_view::npos && comma > 0 && is_digit(comma - 1) && is_digit(comma + 1) &&
         word.find(',', comma + 1) == std::string_view::npos;
}

/// The numbers of a line without heads: apart by semicolons if it has one, else by commas or blanks. Where
/// blanks alone give the right count, a comma between digits is one of decimals.
std::vector<Field> bare_fields(std::string_view line, std::size_t expected) {
  if (line.find(';') != std::string_view::npos) {
    std::vector<Field> fields = fields_of(line, ';');
    while (!fields.empty() && fields.back().text.empty()) fields.pop_back();
    return fields;
  }
  std::vector<Field> words = words_of(line);
  const bool is_plain = std::all_of(words.begin(), words.end(), [](const Field& word) {
    return word.text.find(',') == std::string::npos || has_decimal_comma(word.text);
  });
  if (words.size() == expected && is_plain) return words;
  std::vector<Field> fields;
  for (const Field& word : words)
    for (std::size_t i = 0; i < word.text.size();) {
      const std::size_t end = std::min(word.text.find(',', i), word.text.size());
      if (end > i) fields.push_back({word.text.substr(i, end - i), word.at + static_cast<int>(i)});
      i = end + 1;
    }
  return fields;
}

}  // namespace

const TextTable::Cell* TextTable::cell(std::size_t row, std::string_view column) const {
  const auto found = columns_.find(column);
  return found == columns_.end() ? nullptr : &found->second.at(row);
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

class TextTableReader {
 public:
  TextTableReader(std::span<const TableColumn> columns, const std::map<std::string, std::string>& heads,
                  const Node& where, Diagnostics& diagnostics, TableForm form)
      : columns_(columns), heads_(heads), where_(where), diagnostics_(diagnostics), form_(form) {}

  std::optional<TextTable> read(const std::string& path) {
    const std::size_t before = diagnostics_.errors_given();
    if (read_lines(path) && read_heads()) {
      for (++line_; line_ <= source_->lines.size(); ++line_)
        if (!trimmed(content()).empty()) read_row();
      if (table_.rows_ == 0 && errors_ == 0) {
        line_ = 1;
        fail(1, "the table has no line but its heads");
      }
    }
    if (errors_ > most_errors)
      where_.error(diagnostics_,
                   fmt::format("{} has {} more errors like these", path, errors_ - most_errors));
    if (diagnostics_.errors_given() > before) return std::nullopt;
    table_.source_ = source_;
    return std::move(table_);
  }

 private:
  struct Use {
    const TableColumn* column = nullptr;
    std::vector<TextTable::Cell>* cells = nullptr;
    Unit unit;
  };

  void fail(int at, const std::string& text) {
    if (++errors_ <= most_errors)
      diagnostics_.error({source_, static_cast<int>(line_), at}, where_.path, text);
  }

  bool read_lines(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file || file.peek() == std::ifstream::traits_type::eof()) {
      where_.error(diagnostics_, file ? fmt::format("the file {} is empty", path)
                                      : fmt::format("cannot read the file {}", path));
      return false;
    }
    auto source = std::make_shared<Source>();
    source->name = path;
    for (std::string line; std::getline(file, line);) {
      if (!line.empty() && line.back() == '\r') line.pop_back();
      if (source->lines.empty() && line.starts_with("\xef\xbb\xbf")) line.erase(0, 3);
      source->lines.push_back(std::move(line));
    }
    source_ = std::move(source);
    for (line_ = 1; line_ <= source_->lines.size(); ++line_)
      if (const std::string fault = text_fault(source_->lines[line_ - 1]); !fault.empty()) {
        fail(1, fmt::format("the line {}, expected a table saved as UTF-8", fault));
        return false;
      }
    return true;
  }

  /// The text of the line, without its comment.
  std::string_view content() const {
    const std::string_view line = source_->lines[line_ - 1];
    return form_ == TableForm::points ? line.substr(0, line.find('#')) : line;
  }

  bool read_heads() {
    line_ = 1;
    while (line_ < source_->lines.size() && trimmed(content()).empty()) ++line_;
    const std::string_view line = content();
    if (form_ == TableForm::points && begins_with_number(line)) {
      take_bare_columns();
      return true;
    }
    separator_ = separator_of(line);
    for (const auto& [name, head] : heads_)
      if (trimmed(line) == head) separator_ = ',';  // one column, whose head has blanks
    const std::vector<Field> heads = fields_apart_by(separator_, line);
    const std::size_t before = errors_;
    for (const Field& head : heads) uses_.push_back(use_of(head));
    for (const TableColumn& column : columns_)
      if (column.required && !table_.has(column.name)) fail(1, missing(column));
    for (const auto& [name, head] : heads_)
      if (std::none_of(heads.begin(), heads.end(), [&](const Field& field) { return field.text == head; }))
        fail(1, fmt::format("no head is `{}`, which `columns` names for `{}`{}", printable(head), name,
                            suggestion(head, texts(heads))));
    return errors_ == before;
  }

  /// No head begins with a digit.
  static bool begins_with_number(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t+-.");
    return first != std::string_view::npos && line[first] >= '0' && line[first] <= '9';
  }

  /// The line is the first record, which is read next.
  void take_bare_columns() {
    bare_ = true;
    separator_ = ' ';
    for (const TableColumn& column : columns_)
      uses_.push_back({&column, &table_.columns_[column.name], {1, column.dimension}});
    --line_;
  }

  static std::vector<std::string> texts(const std::vector<Field>& fields) {
    std::vector<std::string> result;
    for (const Field& field : fields) result.push_back(field.text);
    return result;
  }

  std::string missing(const TableColumn& column) const {
    const std::string unit = column.is_text ? "" : si_unit(column.dimension);
    const std::string example =
        unit.empty() || unit == "1" ? "" : fmt::format(" (in {}, or `{}` with a unit)", unit, column.name);
    return fmt::format("no column is `{}`{}{}", column.name, example,
                       table_.ignored_.empty() ? "" : did_you_mean(column.name, table_.ignored_));
  }

  /// The column that a head names, with its unit; none for a head that nobody asked for.
  Use use_of(const Field& head) {
    for (const auto& [name, mapped] : heads_)
      if (head.text == mapped)
        for (const TableColumn& column : columns_)
          if (column.name == name) return taken(head, column, unit_at_end(head.text, column.dimension));
    const std::string text = lower(head.text);
    for (const TableColumn& column : columns_)
      if (text == column.name && !heads_.contains(column.name))
        return taken(head, column, {1, column.dimension});
    for (const TableColumn& column : columns_) {
      if (column.is_text || !text.starts_with(column.name) || heads_.contains(column.name)) continue;
      if (const auto unit =
              trailing_unit(std::string_view(head.text).substr(column.name.size()), column.dimension))
        return taken(head, column, *unit);
    }
    for (const TableColumn& column : columns_)
      if (const auto unit = unit_by_other_name(head.text, text, column)) return taken(head, column, *unit);
    table_.ignored_.push_back(head.text);
    return {};
  }

  /// The unit of a head that begins with another name of a column; nothing if it does not.
  std::optional<Unit> unit_by_other_name(std::string_view head, std::string_view lowered,
                                         const TableColumn& column) const {
    if (heads_.contains(column.name)) return std::nullopt;
    for (const std::string& name : column.also) {
      if (lowered == name) return Unit{1, column.dimension};
      if (!lowered.starts_with(name)) continue;
      if (const auto unit = trailing_unit(head.substr(name.size()), column.dimension)) return unit;
    }
    return std::nullopt;
  }

  Use taken(const Field& head, const TableColumn& column, const Unit& unit) {
    if (table_.has(column.name)) {
      fail(head.at, fmt::format("`{}` is a second column of `{}`", printable(head.text), column.name));
      return {};
    }
    return {&column, &table_.columns_[column.name], unit};
  }

  void read_row() {
    const std::vector<Field> fields =
        bare_ ? bare_fields(content(), uses_.size()) : fields_apart_by(separator_, content());
    if (fields.size() != uses_.size()) return fail(1, wrong_count(fields.size()));
    table_.lines_.push_back(static_cast<int>(line_));
    ++table_.rows_;
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (uses_[i].column) uses_[i].cells->push_back(read_cell(fields[i], uses_[i]));
  }

  std::string wrong_count(std::size_t found) const {
    if (bare_) {
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
      return std::find_if(std::begin(names), std::end(names),
                          [&](const auto& one) { return one.first == separator; })
          ->second;
    };
    if (separator_ == ',' && found == 2 * uses_.size())
      return ": with commas in decimals, separate the values by semicolons";
    for (const auto& [other, name] : names)
      if (other != separator_ && uses_.size() > 1 && fields_apart_by(other, content()).size() == uses_.size())
        return fmt::format(": its values are apart by {}, the heads by {}", name, name_of(separator_));
    return "";
  }

  TextTable::Cell read_cell(const Field& field, const Use& use) {
    TextTable::Cell cell{field.text, 0, false, field.at};
    if (field.text.empty()) {
      if (use.column->required) fail(field.at, fmt::format("`{}` is empty", use.column->name));
    } else if (!use.column->is_text) {
      std::string text = field.text;
      if (separator_ != ',' && text.find('.') == std::string::npos)
        if (const std::size_t comma = text.find(','); comma != std::string::npos) text[comma] = '.';
      const auto number = number_of(text);
      if (!number)
        fail(field.at,
             fmt::format("`{}` is not a number, expected `{}`", printable(field.text), use.column->name));
      cell.is_number = number.has_value();
      cell.number = Quantity{number.value_or(0), true, use.unit, ""}.si();
    }
    return cell;
  }

  /// As programs write numbers: +1.5, 007, 1E3.
  static std::optional<double> number_of(std::string_view text) {
    std::string plain(text);
    std::size_t at = plain.starts_with('-') || plain.starts_with('+') ? 1 : 0;
    while (at + 1 < plain.size() && plain[at] == '0' && plain[at + 1] >= '0' && plain[at + 1] <= '9')
      plain.erase(at, 1);
    if (plain.starts_with('+')) plain.erase(0, 1);
    return parse_number(plain);
  }

  std::span<const TableColumn> columns_;
  const std::map<std::string, std::string>& heads_;
  const Node& where_;
  Diagnostics& diagnostics_;
  TableForm form_;
  bool bare_ = false;  ///< without heads
  std::shared_ptr<const Source> source_;
  TextTable table_;
  std::vector<Use> uses_;
  std::size_t line_ = 1;  ///< from 1
  char separator_ = ',';
  std::size_t errors_ = 0;
};

std::optional<TextTable> read_table(const std::string& path, std::span<const TableColumn> columns,
                                    const std::map<std::string, std::string>& heads, const Node& where,
                                    Diagnostics& diagnostics, TableForm form) {
  return TextTableReader(columns, heads, where, diagnostics, form).read(path);
}

}  // namespace flyrock
