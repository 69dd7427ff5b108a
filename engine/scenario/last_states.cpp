#include "scenario/last_states.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "document/table.h"
#include "record/tables.h"

namespace flyrock {

namespace fs = std::filesystem;

namespace {

bool is_in_file(const Column& column, int dimension) {
  return column.name && (!column.in_space || dimension == 3);
}

/// Numbers are SI: the units in their heads are parts of the names.
std::vector<TableColumn> file_columns(int dimension) {
  std::vector<TableColumn> columns;
  const auto add = [&](const char* name, bool is_text) {
    columns.push_back(
        {.name = name, .dimension = {}, .is_text = is_text, .required = true, .is_common = false});
  };
  add("point", false);
  add("trial", false);
  visit_last_states([&](const Column& column, auto get) {
    const LastStateRecord any;
    using Member = std::decay_t<decltype(member_of(any, get))>;
    if (is_in_file(column, dimension)) add(column.name, !std::is_same_v<Member, double>);
  });
  return columns;
}

LastState state_in(const TextTable& table, std::size_t row, int dimension) {
  LastStateRecord record;
  visit_last_states([&](const Column& column, auto get) {
    if (!is_in_file(column, dimension)) return;
    auto& member = member_of(record, get);
    using Member = std::decay_t<decltype(member)>;
    if constexpr (std::is_same_v<Member, double>)
      member = table.number(row, column.name).value_or(0);
    else if constexpr (std::is_same_v<Member, std::string>)
      member = table.text(row, column.name);
  });
  return record.last;
}

/// "points 0 to 3"
std::string range_text(const char* what, double greatest) {
  return greatest == 0 ? fmt::format("{} 0 only", what) : fmt::format("{}s 0 to {}", what, greatest);
}

/// Reports that no row is of this point, or of this trial of it.
void refuse_absent(DecodeContext& context, const Node& start, const TextTable& table, int point, int trial) {
  double last_point = 0, last_trial = 0;
  bool has_point = false;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double of_row = table.number(row, "point").value_or(0);
    last_point = std::max(last_point, of_row);
    if (of_row != point) continue;
    has_point = true;
    last_trial = std::max(last_trial, table.number(row, "trial").value_or(0));
  }
  const char* key = has_point ? "trial" : "point";
  const Node where = find_given(start, key).value_or(*start.find("from"));
  where.error(context.diagnostics, has_point ? fmt::format("there is no trial {} of point {}, the run has {}",
                                                           trial, point, range_text("trial", last_trial))
                                             : fmt::format("there is no point {}, the run has {}", point,
                                                           range_text("point", last_point)));
}

}  // namespace

std::map<std::string, std::shared_ptr<const LastState>> read_last_states(DecodeContext& context,
                                                                         const Node& start,
                                                                         const std::string& folder, int point,
                                                                         int trial) {
  std::map<std::string, std::shared_ptr<const LastState>> states;
  const Node from = *start.find("from");
  const std::string name = (fs::path(folder) / last_states_name).string();
  const fs::path path = fs::path(context.folder) / name;
  std::error_code code;
  if (!fs::is_regular_file(path, code)) {
    from.error(
        context.diagnostics,
        fs::is_directory(path.parent_path(), code)
            ? fmt::format("the folder `{}` has no {}: expected the result of a run that is complete; an "
                          "older version wrote none, run its scenario again",
                          folder, last_states_name)
            : fmt::format("there is no folder `{}`, expected the result folder of a run", folder));
    return states;
  }
  context.files[name] = path.string();
  const std::vector<TableColumn> columns = file_columns(context.dimension);
  std::map<std::string, std::string> heads;  // as the run writes them
  for (const TableColumn& column : columns) heads[column.name] = column.name;
  const auto table = read_table(path.string(), columns, heads, from, context.diagnostics);
  if (!table) return states;
  for (std::size_t row = 0; row < table->rows(); ++row)
    if (table->number(row, "point") == point && table->number(row, "trial") == trial)
      states[std::string(table->text(row, "body"))] =
          std::make_shared<const LastState>(state_in(*table, row, context.dimension));
  if (states.empty()) refuse_absent(context, start, *table, point, trial);
  return states;
}

}  // namespace flyrock
