#include "cli/result_folder.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "batch/safe_file.h"
#include "host/share.h"
#include "report/database.h"
#include "report/html.h"
#include "report/report_data.h"

namespace flyrock::cli {

namespace fs = std::filesystem;

namespace {

/// A file of a result folder as JSON; null where it is missing or no JSON, as in a folder that was made half.
nlohmann::json json_in(const fs::path& file) {
  std::error_code code;
  if (!fs::is_regular_file(file, code)) return nullptr;
  return nlohmann::json::parse(read_file(file), nullptr, false);
}

}  // namespace

std::string scenario_hash_in(const fs::path& folder) {
  const nlohmann::json manifest = json_in(folder / "manifest.json");
  return manifest.is_object() ? manifest.value("scenario_sha256", "") : "";
}

ResultFolder::ResultFolder(fs::path path, const LoadedScenario& scenario, Existing existing) : path_(std::move(path)) {
  std::error_code code;
  if (!fs::exists(path_, code)) return;
  if (!fs::is_directory(path_, code)) throw UsageError(fmt::format("{} is a file, expected a folder", path_.string()));
  if (existing == Existing::refused && !fs::is_empty(path_, code))
    throw UsageError(fmt::format("{} exists; --resume goes on with an unfinished run, --force replaces the results in "
                                 "it, -o DIR names another folder",
                                 path_.string()));
  if (existing != Existing::continued) return;
  const std::string hash = scenario_hash_in(path_);
  if (!hash.empty() && hash != scenario.hash)
    throw UsageError(fmt::format("{} holds a run of another scenario, seed, number of trials or version of flyrock; "
                                 "--force replaces it, -o DIR names another folder",
                                 path_.string()));
  continued_ = !hash.empty();
}

std::optional<int> ResultFolder::complete(const Plan& plan) const {
  if (!continued_ || !fs::exists(path_ / "run.log")) return std::nullopt;  // written when all else is there
  const nlohmann::json summary = json_in(path_ / "summary.json");
  if (!summary.is_object() || !summary.at("complete").get<bool>()) return std::nullopt;
  for (const auto& point : summary.at("points"))
    if (point.at("trials") != plan.points.front().trials) return std::nullopt;
  if (summary.at("fault_count") > 0) return faults;
  for (const auto& expectation : summary.at("expectations"))
    if (expectation.at("passed") == false) return expectation_failed;
  return done;
}

void ResultFolder::open(const LoadedScenario& scenario, const Request& request) {
  for (const char* name : {"run.log", "summary.json", "rocks.csv", "results.db", "report.html"}) fs::remove(path_ / name);
  if (!continued_) remove_chunks(chunks());
  make_folder(chunks());
  write_request(chunks(), request);
  write_file(path_ / "manifest.json", manifest_json(scenario));
}

Results ResultFolder::build(const LoadedScenario& scenario, const std::vector<ChunkFile>& files,
                            const RunFacts& facts, std::vector<Profile> terrains, const RunLog& log) const {
  const Plan& plan = scenario.plan;
  FileWriter csv(path_ / "rocks.csv");
  csv.write(rocks_csv_header(plan));
  ResultDatabase database(path_ / "results.db", plan);
  const auto see = [&](int point, const TrialRecords& chunk) {
    csv.write(rocks_csv_rows(plan, point, chunk.rocks));
    database.add(point, chunk);
  };
  const std::vector<Rows> rows = rows_in(files, static_cast<int>(plan.points.size()), scenario.hash);
  Results results = make_results(plan, rows, facts, see);
  for (std::size_t p = 0; p < terrains.size(); ++p) results.points[p].terrain = std::move(terrains[p]);
  csv.commit();
  database.finish(results);
  write_file(path_ / "summary.json", summary_json(plan, results));
  write_file(report(), report_html(report_data(plan, results, rows), fs::path(share_folder()) / "report"));
  write_file(path_ / "run.log", run_log(log));
  return results;
}

void ResultFolder::tidy() const {
  remove_request(chunks());
  remove_chunks(chunks());
}

}  // namespace flyrock::cli
