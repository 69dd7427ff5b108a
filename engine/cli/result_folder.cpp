#include "cli/result_folder.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <nlohmann/json.hpp>

#include "cli/terminal.h"
#include "files/safe_file.h"
#include "host/share.h"
#include "load/checksums.h"

namespace flyrock::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* manifest_name = "manifest.json";
constexpr const char* run_log_name = "run.log";  ///< written last
constexpr std::array result_names = {run_log_name, checksums_name,   "summary.json", "rocks.csv",
                                     "results.db", last_states_name, "report.html"};

/// Whether a run has finished in the folder.
bool stands(const fs::path& folder) {
  std::error_code code;
  return fs::exists(folder / run_log_name, code);
}

/// The result of `read` for a JSON file. Throws UnreadableFile if the file is not JSON, or if `read` does not
/// find what it needs.
template <class Read>
auto read_json(const fs::path& file, Read read) {
  try {
    return read(nlohmann::json::parse(read_file(file)));
  } catch (const nlohmann::json::exception&) {
    throw UnreadableFile(fmt::format("{} is damaged: it is not what a run writes", file.string()));
  }
}

/// Refuses a folder that another process is writing. It is neither read nor replaced.
void refuse_written(const fs::path& folder) {
  if (const std::string writer = FolderLock::writer(folder); !writer.empty())
    throw InputError(fmt::format("{}: {}", folder.string(), writer));
}

}  // namespace

std::string scenario_hash_in(const fs::path& folder) {
  refuse_written(folder);
  const fs::path file = folder / manifest_name;
  std::error_code code;
  if (!fs::is_regular_file(file, code) || fs::is_empty(file, code)) return "";
  const auto read_hash = [&](const nlohmann::json& manifest) {
    const int format = manifest.at("format");
    if (format != result_format)
      throw InputError(fmt::format(
          "{} was written by flyrock {} in format {}, this one has format {}: run the scenario again, "
          "with --force or -o DIR",
          folder.string(), manifest.value("flyrock", "?"), format, result_format));
    return manifest.at("scenario_sha256").get<std::string>();
  };
  try {
    return read_json(file, read_hash);
  } catch (const UnreadableFile&) {
    if (stands(folder)) throw;
    return "";  // the folder is incomplete
  }
}

fs::path finished_result(const std::string& folder) {
  const fs::path path(folder);
  if (scenario_hash_in(path).empty())
    throw InputError(
        fmt::format("{} is not a result folder: it has no manifest.json, or a damaged one", folder));
  if (!stands(path))
    throw InputError(
        fmt::format("{} has no results yet: `flyrock run --resume` goes on with a run that was interrupted, "
                    "`flyrock merge` puts shards together",
                    folder));
  check_checksums(path);
  return path;
}

ResultFolder::ResultFolder(fs::path path, const LoadedScenario& scenario, Existing existing)
    : path_(std::move(path)) {
  std::error_code code;
  if (!fs::exists(path_, code)) return;
  if (!fs::is_directory(path_, code))
    throw InputError(fmt::format("{} is a file, expected a folder", path_.string()));
  refuse_written(path_);
  if (existing == Existing::refused && !fs::is_empty(path_, code))
    throw UsageError(
        fmt::format("{} exists; --resume goes on with an unfinished run, --force replaces the results in "
                    "it, -o DIR names another folder",
                    path_.string()));
  if (existing != Existing::continued) return;
  const std::string hash = scenario_hash_in(path_);
  if (hash.empty() && stands(path_))
    throw InputError(fmt::format(
        "{} holds results without a manifest.json: their scenario is unknown; --force replaces them",
        path_.string()));
  if (!hash.empty() && hash != scenario.hash)
    throw UsageError(
        fmt::format("{} holds a run of another scenario, seed, number of trials or version of flyrock; "
                    "--force replaces it, -o DIR names another folder",
                    path_.string()));
  continued_ = !hash.empty();
}

std::optional<int> ResultFolder::complete(const Plan& plan) const {
  const auto is_there = [&](const char* name) {
    std::error_code code;
    return fs::is_regular_file(path_ / name, code) && !fs::is_empty(path_ / name, code);
  };
  if (!continued_ || !std::all_of(result_names.begin(), result_names.end(), is_there)) return std::nullopt;
  check_checksums(path_);
  return read_json(path_ / "summary.json", [&](const nlohmann::json& summary) -> std::optional<int> {
    if (!summary.at("complete").get<bool>()) return std::nullopt;
    for (const auto& point : summary.at("points"))
      if (point.at("trials") != plan.points.front().trials) return std::nullopt;
    if (summary.at("fault_count") > 0) return faults;
    for (const auto& expectation : summary.at("expectations"))
      if (expectation.at("passed") == false) return expectation_failed;
    return done;
  });
}

void ResultFolder::open(const LoadedScenario& scenario, const Request& request) {
  try {
    make_folder(path_);
    lock_.emplace(path_);
    if (!lock_->warning().empty()) tell("warning: {}\n", lock_->warning());
    for (const char* name : result_names) fs::remove(path_ / name);
    if (!continued_) remove_chunks(chunks()), fs::remove_all(hard_problems());
    make_folder(chunks());
    write_request(chunks(), request);
    write_file(path_ / manifest_name, manifest_json(scenario));
  } catch (const FileError& error) {
    throw InputError(error.what());
  } catch (const fs::filesystem_error& error) {
    throw InputError(fmt::format("cannot write in {}: {}", path_.string(), error.code().message()));
  }
}

Results ResultFolder::build(ResultWriter& writer, const std::vector<Rows>& rows, const RunFacts& facts,
                            std::vector<TerrainPicture> terrains, RunLog log) const {
  const auto start = std::chrono::steady_clock::now();
  Results results = writer.finish(rows, facts, std::move(terrains), fs::path(share_folder()) / "report");
  write_checksums(path_);
  log.finish_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  struct rusage usage {};
  ::getrusage(RUSAGE_SELF, &usage);
  log.peak_memory = usage.ru_maxrss;
  write_file(path_ / run_log_name, run_log(log));
  return results;
}

void ResultFolder::tidy() const {
  remove_request(chunks());
  remove_chunks(chunks());
}

}  // namespace flyrock::cli
