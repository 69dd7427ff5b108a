#pragma once
// The folder that a run writes.

#include <filesystem>
#include <string>

#include "cli/command.h"
#include "report/tables.h"

namespace flyrock::cli {

class ResultFolder {
 public:
  /// Names the folder and writes nothing. Throws UsageError where it exists with something in it and `force` is
  /// not set, or where it is a file.
  ResultFolder(std::filesystem::path path, bool force);

  /// Makes the folder, removes the results of an earlier run that are in it and writes the manifest. Other
  /// files stay. Throws FileError.
  void open(const LoadedScenario& scenario);
  std::filesystem::path chunks() const { return path_ / "chunks"; }
  std::filesystem::path report() const { return path_ / "report.html"; }

  /// Writes tables and report. Throws FileError.
  void write(const LoadedScenario& scenario, const Results& results, const RunLog& log) const;

 private:
  std::filesystem::path path_;
};

}  // namespace flyrock::cli
