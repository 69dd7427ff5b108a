#include "scenario/sweep_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "document/node.h"
#include "document/table_lines.h"
#include "document/table_text.h"
#include "document/workbook.h"
#include "scenario/decode.h"
#include "units/units.h"

namespace flyrock {

namespace {

constexpr std::size_t most_rows = 10'000;

/// "blast.burden [m]": a path, and the unit of its bare numbers.
struct Head {
  std::string path, unit;
};

Head head_of(const std::string& cell) {
  const std::size_t open = cell.find_first_of("[(");
  if (open == std::string::npos) return {cell, ""};
  const std::size_t close = std::min(cell.find_first_of("])", open), cell.size());
  const std::string_view text = cell;
  return {std::string(without_blanks(text.substr(0, open))),
          std::string(without_blanks(text.substr(open + 1, close - open - 1)))};
}

Value value_of_cell(const std::string& cell, const std::string& unit, const Location& at) {
  Value value;
  value.at = at;
  const auto number = parse_number(cell);
  if (!number)
    value.data = cell;
  else if (unit.empty())
    value.data = *number;
  else
    value.data = cell + " " + unit;
  return value;
}

/// The rows of a table as a list of maps, as the scenario would write them.
std::optional<List> read_rows_of_table(const Node& table, const std::string& file, Diagnostics& diagnostics) {
  TableText text;
  try {
    text = read_table_text(file);
  } catch (const TableTextFault& fault) {
    if (fault.source)
      diagnostics.error({fault.source, fault.line, 1}, table.path, fault.what());
    else
      table.error(diagnostics, fault.what());
    return std::nullopt;
  }
  const std::shared_ptr<const Source>& source = text.source;
  const std::size_t errors_before = diagnostics.errors_given();
  List rows;
  std::vector<Head> heads;
  char separator = text.is_sheet ? '\t' : ',';
  for (std::size_t i = 0; i < source->lines.size(); ++i) {
    const std::string& line = source->lines[i];
    const Location at{source, static_cast<int>(i) + 1, 1};
    if (without_blanks(line).empty() || line.starts_with('#')) continue;
    if (heads.empty()) {
      if (!text.is_sheet) separator = separator_of(line);
      for (const TableField& cell : fields_apart_by(separator, line)) heads.push_back(head_of(cell.text));
      continue;
    }
    const std::vector<TableField> cells = fields_apart_by(separator, line);
    if (cells.size() != heads.size()) {
      diagnostics.error(
          at, table.path,
          fmt::format("has {} values, expected {} as there are heads", cells.size(), heads.size()));
      continue;
    }
    Map row;
    for (std::size_t k = 0; k < cells.size(); ++k)
      row.push_back({heads[k].path, at, value_of_cell(cells[k].text, heads[k].unit, at)});
    Value value;
    value.at = at;
    value.data = std::move(row);
    rows.push_back(std::move(value));
  }
  if (diagnostics.errors_given() != errors_before) return std::nullopt;
  if (rows.empty()) {
    table.error(diagnostics,
                fmt::format("{} has no rows, expected a line of paths and a line for each point", file));
    return std::nullopt;
  }
  return rows;
}

/// The path with indices, and with the names of elements, of what stands at a path.
Node find_node(const Value& root, const std::string& path) {
  Node node = Node::root(root);
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    const std::string step = path.substr(begin, end - begin);
    begin = end + 1;
    std::optional<Node> next = node.find(step);
    for (Node& item : node.items()) {
      const auto name = item.find("name");
      if (item.key == step || (name && name->value->text() && *name->value->text() == step))
        next = std::move(item);
    }
    if (!next) return node;
    node = std::move(*next);
  }
  return node;
}

bool is_sweep(const Value& value) { return value.find("sweep") != nullptr; }

class RowReader {
 public:
  RowReader(Value& root, Diagnostics& diagnostics) : root_(root), diagnostics_(diagnostics) {}

  void read(const std::vector<Node>& rows, SweepRows& found) {
    for (const Node& row : rows) {
      if (!row.expect_map(diagnostics_)) return;
      read_row(row, found);
    }
    const bool any_label = std::any_of(found.labels.begin(), found.labels.end(),
                                       [](const std::string& label) { return !label.empty(); });
    if (!any_label) found.labels.clear();
    for (auto& [path, column] : columns_) found.columns.push_back(std::move(column));
    std::sort(found.columns.begin(), found.columns.end(),
              [](const SweptValue& a, const SweptValue& b) { return a.path < b.path; });
  }

 private:
  void read_row(const Node& row, SweepRows& found) {
    std::set<std::string> seen;
    found.labels.emplace_back();
    for (const Node& entry : row.entries()) {
      if (entry.key == "label") {
        if (entry.value->text())
          found.labels.back() = *entry.value->text();
        else
          entry.error(diagnostics_, "expected a text");
        continue;
      }
      if (is_sweep(*entry.value)) {
        entry.error(diagnostics_, "stands inside a row of a sweep, expected a value");
        continue;
      }
      const bool is_new = columns_.count(entry.key) == 0;
      if (is_new && found.labels.size() > 1) {
        diagnostics_.error(
            entry.key_at, entry.path,
            fmt::format("the first row does not set `{}`; expected the same paths in all rows", entry.key));
        continue;
      }
      if (is_new) columns_.emplace(entry.key, column_of(entry));
      columns_.at(entry.key).values.push_back(*entry.value);
      seen.insert(entry.key);
    }
    for (const auto& [path, column] : columns_)
      if (seen.count(path) == 0)
        row.error(diagnostics_, fmt::format("does not set `{}`, which the first row sets", path));
  }

  /// A path that a row sets.
  SweptValue column_of(const Node& entry) {
    SweptValue column{nullptr, entry.key, entry.key, entry.key_at, {}};
    if (!may_be_swept(entry.key)) {
      diagnostics_.error(
          entry.key_at, entry.path,
          fmt::format("`{}` takes no sweep, only numbers, choices and sections with a `type` are swept",
                      entry.key));
      return column;
    }
    if (const Node there = find_node(root_, entry.key);
        there.key == last_step(entry.key) && is_sweep(*there.value))
      diagnostics_.error(entry.key_at, entry.path, fmt::format("`{}` is swept at its place too", entry.key));
    set_path(root_, entry.key, *entry.value, entry.key_at, diagnostics_);
    const Node there = find_node(root_, entry.key);
    column.path = there.path;
    column.stream = there.stream;
    return column;
  }

  static std::string last_step(const std::string& path) { return path.substr(path.rfind('.') + 1); }

  Value& root_;
  Diagnostics& diagnostics_;
  std::map<std::string, SweptValue> columns_;  ///< by the path as written
};

}  // namespace

std::optional<SweepRows> read_sweep_rows(Value& root, const std::string& folder, Diagnostics& diagnostics) {
  const std::optional<Node> section = Node::root(root).find("sweep");
  if (!section || !section->value->map()) return std::nullopt;
  const auto table = section->find("table"), rows = section->find("rows"), product = section->find("product");
  if (!table && !rows) return std::nullopt;
  SweepRows found;
  found.at = section->key_at;
  if (table && rows) {
    rows->error(diagnostics, "expected one of `table` and `rows`");
    return std::nullopt;
  }
  if (product && product->value->boolean()) found.product = *product->value->boolean();
  // The tree changes while rows are read, so they are copied first.
  Value list;
  if (table) {
    if (!table->value->text()) {
      table->error(diagnostics, "expected the name of a file");
      return std::nullopt;
    }
    const std::string& name = *table->value->text();
    found.file = sheet_name(name).file;
    found.path_of_file = (std::filesystem::path(folder) / found.file).string();
    std::optional<List> read =
        read_rows_of_table(*table, (std::filesystem::path(folder) / name).string(), diagnostics);
    if (!read) return std::nullopt;
    list.data = std::move(*read);
    list.at = table->value->at;
  } else {
    if (!rows->expect_list(diagnostics)) return std::nullopt;
    list = *rows->value;
  }
  Node of_rows{&list, (table ? *table : *rows).key_at, table ? "sweep.table" : "sweep.rows", "", "rows"};
  const std::vector<Node> items = of_rows.items();
  if (items.empty() || items.size() > most_rows) {
    of_rows.error(diagnostics, fmt::format("has {} rows, expected 1 to {}", items.size(), most_rows));
    return std::nullopt;
  }
  RowReader(root, diagnostics).read(items, found);
  return found;
}

}  // namespace flyrock
