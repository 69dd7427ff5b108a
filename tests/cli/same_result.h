#pragma once
// Whether two result folders hold the same result.

#include "program.h"
#include "rows.h"

namespace flyrock::test {

/// Checks the files that must not differ.
inline void check_same(const Folder& folder, const std::string& a, const std::string& b) {
  for (const char* file : {"manifest.json", "summary.json", "rocks.csv", "last_states.csv", "report.html"}) {
    INFO(a << " and " << b << ": " << file);
    const std::string bytes = read(folder.path() / a / file);
    CHECK_FALSE(bytes.empty());
    CHECK(bytes == read(folder.path() / b / file));
  }
  const std::vector<std::string> rows = all_rows(folder.path() / a / "results.db");
  CHECK_FALSE(rows.empty());
  CHECK(rows == all_rows(folder.path() / b / "results.db"));
  CHECK_FALSE(folder.has(b + "/chunks"));
}

}  // namespace flyrock::test
