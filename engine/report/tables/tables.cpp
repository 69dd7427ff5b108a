#include "report/tables/tables.h"

#include <fmt/format.h>

#include <concepts>
#include <iterator>
#include <nlohmann/json.hpp>

#include "batch/plan_chunks.h"
#include "report/commit.h"
#include "report/tables/csv.h"
#include "report/tables/hash_data.h"
#include "report/tables/shown_value.h"
#include "report/tables/summary_data.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

TableContent content_with(const Scenario& scenario, bool weights) {
  TableContent content = content_of(scenario);
  content.weights = weights;
  return content;
}

bool is_in_csv(const Column& column, const TableContent& content) {
  return column.name && column.in_csv && column.is_of(content) &&
         (!column.in_space || content.dimension == 3);
}

/// Appends a comma and a cell to a line.
struct AppendCell {
  std::string& csv;

  void operator()(double number) const { (csv += ',') += csv_number(number); }
  void operator()(std::string_view text) const { (csv += ',') += csv_text(std::string(text)); }
  template <std::integral Whole>
  void operator()(Whole number) const {
    fmt::format_to(std::back_inserter(csv), ",{}", +number);
  }
};

/// The point, then the columns that `visit_columns` visits.
template <class VisitColumns>
std::string csv_header(const TableContent& content, VisitColumns visit_columns) {
  std::string header = "point";
  visit_columns([&](const Column& column, auto) {
    if (is_in_csv(column, content)) (header += ',') += column.name;
  });
  return header + '\n';
}

template <class Row, class VisitColumns>
std::string csv_rows(const Scenario& scenario, int point, const std::vector<Row>& rows,
                     const TableContent& content, VisitColumns visit_columns) {
  const RecordNames names(scenario);
  std::string csv;
  for (const Row& row : rows) {
    csv += std::to_string(point);
    visit_columns([&](const Column& column, auto get) {
      if (is_in_csv(column, content)) shown_value(column, member_of(row, get), names, AppendCell{csv});
    });
    csv += '\n';
  }
  return csv;
}

constexpr auto rocks_columns = [](auto&& visit) { visit_rocks(visit); };
constexpr auto last_states_columns = [](auto&& visit) {
  visit(Column{.name = "trial"}, &LastStateRecord::trial);
  visit_last_states(visit);
};

/// The arguments of Lua files by name.
Json arguments_data(const std::vector<LuaArgument>& arguments) {
  Json data = Json::object();
  for (const LuaArgument& argument : arguments)
    std::visit([&](const auto& value) { data[argument.name] = value; }, argument.value);
  return data;
}

}  // namespace

std::string rocks_csv_header(const Plan& plan, bool weighted) {
  return csv_header(content_with(plan.points.front(), weighted), rocks_columns);
}

std::string rocks_csv_rows(const Plan& plan, int point, const std::vector<RockRecord>& rocks, bool weighted) {
  const Scenario& scenario = plan.points[static_cast<std::size_t>(point)];
  return csv_rows(scenario, point, rocks, content_with(scenario, weighted), rocks_columns);
}

std::string last_states_csv_header(const Plan& plan) {
  return csv_header(content_of(plan.points.front()), last_states_columns);
}

std::string last_states_csv_rows(const Plan& plan, int point, const std::vector<LastStateRecord>& states) {
  const Scenario& scenario = plan.points[static_cast<std::size_t>(point)];
  return csv_rows(scenario, point, states, content_of(scenario), last_states_columns);
}

std::string summary_json(const Plan& plan, const Results& results) {
  return summary_data(plan, results).dump(2) + '\n';
}

std::string manifest_json(const LoadedScenario& loaded) {
  const Scenario& first = loaded.plan.points.front();
  const Json manifest = {{"flyrock", FLYROCK_ENGINE_VERSION},
                         {"commit", source_commit()},
                         {"format", result_format},
                         {"scenario_sha256", loaded.hash},
                         {"seed", first.streams.seed},
                         {"trials", first.trials},
                         {"points", loaded.plan.points.size()},
                         {"outer", first.outer},
                         {"chunk_size", chunk_size(loaded.plan)},
                         {"arguments", arguments_data(loaded.session->arguments().asked())},
                         {"plugins", hash_data(loaded.sources)},
                         {"files", hash_data(loaded.files)},
                         {"scenario", Json::parse(to_json(loaded.plan.resolved))}};
  return manifest.dump(2) + '\n';
}

std::string run_log(const RunLog& log) {
  const PhaseTimes& t = log.times;
  const auto total = static_cast<double>(t.flight + t.detect + t.solve + t.other);
  std::string text = fmt::format(
      "started  {}\nhost     {}\nthreads  {}\ntrials   {}\nkept     {}\nrocks    {}\nseconds  {:.3f}\n",
      log.started, log.host, log.threads, log.trials, log.kept, log.rocks, log.seconds);
  if (log.seconds > 0) text += fmt::format("rocks/s  {:.1f}\n", static_cast<double>(log.rocks) / log.seconds);
  const auto share = [&](std::string_view name, std::int64_t time) {
    if (total > 0) text += fmt::format("{:<8} {:5.1f} %\n", name, 100 * static_cast<double>(time) / total);
  };
  share("flight", t.flight), share("detect", t.detect), share("solve", t.solve), share("other", t.other);
  const auto wall = [&](std::string_view name, double seconds) {
    text += fmt::format("{:<8} {:.3f} s, {:.1f} % of the wall time\n", name, seconds,
                        100 * seconds / (log.seconds + log.finish_seconds));
  };
  wall("store", log.store_seconds), wall("tables", log.table_seconds + log.finish_seconds);
  text += fmt::format("memory   {:.1f} MB at most\n", static_cast<double>(log.peak_memory) / 1000);
  return text;
}

}  // namespace flyrock
