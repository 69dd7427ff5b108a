#pragma once
// The folder that a run writes.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "batch/chunk_files.h"
#include "batch/folder_lock.h"
#include "cli/command.h"
#include "cli/request.h"
#include "report/result_writer.h"
#include "report/tables.h"

namespace flyrock::cli {

/// What becomes of a folder that has something in it.
enum class Existing {
  refused,
  continued,  ///< --resume: chunks of the same scenario stay, one of another scenario is refused
  replaced    ///< --force
};

class ResultFolder {
 public:
  /// Names the folder of a scenario and writes nothing. Throws UsageError where it is not to be used so,
  /// InputError where it is no folder or another run is writing it.
  ResultFolder(std::filesystem::path path, const LoadedScenario& scenario, Existing existing);

  /// Whether the results of all trials of the scenario stand; the exit code that the run ended with. Throws
  /// UnreadableFile where they are not what the run wrote.
  std::optional<int> complete(const Plan& plan) const;

  /// Makes the folder and holds it, removes tables of an earlier run, and its chunks where they are not
  /// continued, and writes the manifest. Other files stay. Throws InputError where the folder cannot be
  /// written or held.
  void open(const LoadedScenario& scenario, const Request& request);
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path chunks() const { return path_ / "chunks"; }
  /// Where steps that did not converge are kept.
  std::filesystem::path hard_problems() const { return path_ / "hard_problems"; }
  std::filesystem::path report() const { return path_ / "report.html"; }

  /// Finishes the tables and the report of what `writer` has seen, and logs it. Throws FileError.
  Results build(ResultWriter& writer, const std::vector<Rows>& rows, const RunFacts& facts,
                std::vector<Profile> terrains, RunLog log) const;
  /// Removes the chunks, once the results stand. Throws FileError.
  void tidy() const;

 private:
  std::filesystem::path path_;
  bool continued_ = false;
  std::optional<FolderLock> lock_;  ///< from open() on
};

/// The hash of the scenario in the manifest of a result folder, or an empty text where there is none, or a
/// broken one of a folder that was made half. Throws InputError where it is of a format that this flyrock
/// does not read, or a run is writing it, and UnreadableFile where it is damaged.
std::string scenario_hash_in(const std::filesystem::path& folder);

/// The path of a result folder whose tables stand, as the run wrote them: their checksums are compared.
/// Throws InputError or UnreadableFile where it is none.
std::filesystem::path finished_result(const std::string& folder);

}  // namespace flyrock::cli
