#include "cli/result_folder.h"

#include <fmt/format.h>

#include "batch/safe_file.h"
#include "host/share.h"
#include "report/html.h"

namespace flyrock::cli {

namespace fs = std::filesystem;

ResultFolder::ResultFolder(fs::path path, bool force) : path_(std::move(path)) {
  std::error_code code;
  if (!fs::exists(path_, code)) return;
  if (!fs::is_directory(path_, code)) throw UsageError(fmt::format("{} is a file, expected a folder", path_.string()));
  if (!force && !fs::is_empty(path_, code))
    throw UsageError(fmt::format("{} exists; --force replaces the results in it, -o DIR names another folder",
                                 path_.string()));
}

void ResultFolder::open(const LoadedScenario& scenario) {
  make_folder(chunks());
  for (const char* name : {"manifest.json", "summary.json", "rocks.csv", "report.html", "run.log"})
    fs::remove(path_ / name);
  for (const fs::directory_entry& entry : fs::directory_iterator(chunks()))
    if (entry.path().extension() == ".chunk") fs::remove(entry.path());
  write_file(path_ / "manifest.json", manifest_json(scenario));
}

void ResultFolder::write(const LoadedScenario& scenario, const Results& results, const RunLog& log) const {
  write_file(path_ / "rocks.csv", rocks_csv(scenario.plan, results));
  write_file(path_ / "summary.json", summary_json(scenario.plan, results));
  write_file(report(), report_html(scenario.plan, results, fs::path(share_folder()) / "report"));
  write_file(path_ / "run.log", run_log(log));
}

}  // namespace flyrock::cli
