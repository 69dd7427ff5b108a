#include "report/result_writer.h"

#include <algorithm>
#include <future>
#include <nlohmann/json.hpp>

#include "record/tables.h"
#include "report/page/html.h"
#include "report/page/motion_data.h"
#include "report/pictures/ground_pictures.h"
#include "report/tables/tables.h"
#include "results/say/cell_size.h"
#include "scenario/last_states.h"
#include "trial/make_forest.h"

namespace flyrock {

ResultWriter::ResultWriter(const std::filesystem::path& folder, const LoadedScenario& scenario)
    : folder_(folder),
      plan_(scenario.plan),
      csv_(folder / "rocks.csv"),
      last_states_(folder / last_states_name),
      database_(folder / "results.db", plan_),
      tally_(plan_),
      report_(scenario) {
  for (const Scenario& each : plan_.points) rows_left_.push_back(static_cast<std::size_t>(each.output.first));
}

void ResultWriter::begin(const TrialRecords& first) {
  const auto gives = [](const Scenario& point) { return point.gives_weights(); };
  const auto has = [](const RockRecord& rock) { return rock.weight != 1; };
  weighted_ = std::any_of(plan_.points.begin(), plan_.points.end(), gives) ||
              std::any_of(first.rocks.begin(), first.rocks.end(), has);
  csv_.write(rocks_csv_header(plan_, weighted_));
  last_states_.write(last_states_csv_header(plan_));
  database_.begin(weighted_);
  begun_ = true;
}

void ResultWriter::add(int point, const TrialRecords& chunk) {
  if (!begun_) begin(chunk);
  const bool all = plan_.points[static_cast<std::size_t>(point)].output.rocks;
  const TrialRecords first = all ? TrialRecords() : first_rows(point, chunk);
  const TrialRecords& shown = all ? chunk : first;
  csv_.write(rocks_csv_rows(plan_, point, shown.rocks, weighted_));
  last_states_.write(last_states_csv_rows(plan_, point, shown.last_states));
  database_.add(point, shown);
  tally_.add(point, chunk);
  report_.add(point, chunk, shown);
}

TrialRecords ResultWriter::first_rows(int point, const TrialRecords& chunk) {
  std::size_t& left = rows_left_.at(static_cast<std::size_t>(point));
  TrialRecords first;
  const std::size_t count = std::min(left, chunk.rocks.size());
  left -= count;
  if (count > 0) {
    first = chunk;
    first.rocks.resize(count);
    const RockRecord last = first.rocks.back();
    visit_tables(first, [&](const Table& table, auto& rows, auto) {
      std::erase_if(rows, [&](const auto& row) {
        if constexpr (requires { row.rock; })
          if (table.owner == RowOwner::rock)
            return std::pair(row.trial, row.rock) > std::pair(last.trial, last.rock);
        return row.trial > last.trial;
      });
    });
  }
  first.totals = {};
  first.totals.materials = chunk.totals.materials;
  return first;
}

Results ResultWriter::finish(const std::vector<Rows>& rows, const RunFacts& facts,
                             std::vector<TerrainPicture> terrains, const std::filesystem::path& assets) {
  if (!begun_) begin({});
  const auto beside = [](auto work) { return std::async(std::launch::async, std::move(work)); };
  std::future<void> closed = beside([&] {
    database_.index();
    report_.close();
  });
  Results results =
      tally_.finish(rows, facts, [&](std::size_t point, const std::vector<RunoutExtent>& runouts) {
        return report_.reader(point, runouts);
      });
  for (std::size_t p = 0; p < terrains.size(); ++p) results.points[p].terrain = std::move(terrains[p]);
  for (std::size_t p = 0; p < plan_.points.size(); ++p)
    if (const TerrainPicture& terrain = results.points[p].terrain; plan_.points[p].forest && terrain.ground)
      results.points[p].forest = make_forest(plan_.points[p], terrain.ground->ground());
  for (std::string& warning : cell_warnings(results.points)) results.warnings.push_back(std::move(warning));
  closed.get();
  const GroundPictures grounds = ground_pictures(results.points);
  nlohmann::ordered_json drawn = report_.finish(results, grounds);
  const std::string stored = drawn.dump();
  // Runs in parallel, because the database is the largest file and writing it takes a while.
  std::future<void> database = beside([&] { database_.finish(results, grounds, stored); });
  csv_.commit();
  last_states_.commit();
  write_file(folder_ / "summary.json", summary_json(plan_, results));
  const bool of_bodies = !plan_.points.front().bodies.empty();
  if (of_bodies) {
    database.get();
    add_motion(drawn, folder_ / "results.db");
  }
  write_file(folder_ / "report.html", report_html(drawn, assets));
  if (!of_bodies) database.get();
  return results;
}

}  // namespace flyrock
