#pragma once
// The labs of the course: their list, their files, and how many of their expectations hold.

#include <filesystem>
#include <string>
#include <vector>

namespace flyrock::cli {

struct Lab {
  std::string week, name, question;

  std::filesystem::path page() const;
  std::filesystem::path scenario() const;
};

/// The rows of the table in the course's README: `| 1 | [name](name.md) | question |`.
std::vector<Lab> labs();

/// Throws UsageError, which names the nearest one.
const Lab& lab_named(const std::string& name, const std::vector<Lab>& list);

/// How many expectations of a result hold. A run with fewer trials than its scenario has does not judge those
/// that need all.
struct Verdicts {
  std::size_t held = 0, judged = 0, not_judged = 0;
};

/// Those in the summary.json of a result folder.
Verdicts verdicts_in(const std::filesystem::path& folder);

/// Whether a run with this exit code left no results in its folder.
bool ended_without_results(int code, const std::filesystem::path& folder);

}  // namespace flyrock::cli
