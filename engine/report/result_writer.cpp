#include "report/result_writer.h"

#include <future>
#include <nlohmann/json.hpp>

#include "report/ground_pictures.h"
#include "report/html.h"
#include "report/motion_data.h"
#include "report/tables.h"
#include "results/cell_size.h"

namespace flyrock {

ResultWriter::ResultWriter(const std::filesystem::path& folder, const LoadedScenario& scenario)
    : folder_(folder),
      plan_(scenario.plan),
      csv_(folder / "rocks.csv"),
      database_(folder / "results.db", plan_),
      tally_(plan_),
      report_(scenario) {
  csv_.write(rocks_csv_header(plan_));
}

void ResultWriter::see(int point, const TrialRecords& chunk) {
  csv_.write(rocks_csv_rows(plan_, point, chunk.rocks));
  database_.add(point, chunk);
  tally_.see(point, chunk);
  report_.see(point, chunk);
}

Results ResultWriter::finish(const std::vector<Rows>& rows, const RunFacts& facts,
                             std::vector<TerrainPicture> terrains, const std::filesystem::path& assets) {
  const auto beside = [](auto work) { return std::async(std::launch::async, std::move(work)); };
  std::future<void> closed = beside([&] {
    database_.index();
    report_.close();
  });
  Results results = tally_.finish(rows, facts);
  for (std::size_t p = 0; p < terrains.size(); ++p) results.points[p].terrain = std::move(terrains[p]);
  for (std::string& warning : cell_warnings(results.points)) results.warnings.push_back(std::move(warning));
  closed.get();
  const GroundPictures grounds = ground_pictures(results.points);
  nlohmann::ordered_json drawn = report_.finish(results, grounds, rows);
  const std::string stored = drawn.dump();
  // Runs in parallel, because the database is the largest file and writing it takes a while.
  std::future<void> database = beside([&] { database_.finish(results, grounds, stored); });
  csv_.commit();
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
