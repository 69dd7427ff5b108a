#pragma once
// What a scenario says and no run reads, in one line: many lines of it would hide a warning that matters.

#include <string>
#include <vector>

namespace flyrock::cli {

/// "not used: blast.spacing, blast.hole.stemming and 3 more change nothing (`flyrock check --strict` says
/// why)" from entries "blast.spacing (bench_fit does not read it)"; `hint` says where the reasons are. Empty
/// where there are no entries.
std::string not_used_line(const std::vector<std::string>& entries, const std::string& hint);

}  // namespace flyrock::cli
