#pragma once
// The result folder of a run.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "batch/chunk_files.h"
#include "cli/command.h"
#include "cli/request.h"
#include "files/folder_lock.h"
#include "report/result_writer.h"
#include "report/tables/tables.h"

namespace flyrock::cli {

/// What happens to a folder that is not empty.
enum class Existing {
  refused,
  continued,  ///< --resume: chunks of the same scenario are kept; a folder of another scenario is refused
  replaced    ///< --force
};

class ResultFolder {
 public:
  /// Chooses the folder of a scenario; writes nothing. Throws UsageError if `existing` does not allow it,
  /// InputError if it is not a folder or another run writes it.
  ResultFolder(std::filesystem::path path, const LoadedScenario& scenario, Existing existing);

  /// The exit code of the run, if the results of all trials of the scenario are in the folder. Throws
  /// UnreadableFile if they are not what the run wrote.
  std::optional<int> complete(const Plan& plan) const;

  /// Makes and locks the folder and writes the manifest. Removes tables of an earlier run, and its chunks
  /// unless they are continued. Other files stay. Throws InputError if the folder cannot be written or
  /// locked.
  void open(const LoadedScenario& scenario, const Request& request);
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path chunks() const { return path_ / "chunks"; }
  /// The folder for steps that did not converge.
  std::filesystem::path hard_problems() const { return path_ / "hard_problems"; }
  std::filesystem::path report() const { return path_ / "report.html"; }

  /// Finishes the tables and the report from what `writer` has seen, and writes the log. Throws FileError.
  Results build(ResultWriter& writer, const std::vector<Rows>& rows, const RunFacts& facts,
                std::vector<TerrainPicture> terrains, RunLog log) const;
  /// Removes the chunks, after the results are written. Throws FileError.
  void tidy() const;

 private:
  std::filesystem::path path_;
  bool continued_ = false;
  std::optional<FolderLock> lock_;  ///< held after open()
};

/// The scenario hash in the manifest of a result folder. Empty if there is no manifest, or a broken one in an
/// incomplete folder. Throws InputError if this flyrock does not read its format or a run writes it, and
/// UnreadableFile if it is damaged.
std::string scenario_hash_in(const std::filesystem::path& folder);

/// The path of a result folder with complete tables. Their checksums are compared. Throws InputError or
/// UnreadableFile if it is not such a folder.
std::filesystem::path finished_result(const std::string& folder);

}  // namespace flyrock::cli
