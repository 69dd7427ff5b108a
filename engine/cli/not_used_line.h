#pragma once
// The keys of a scenario that a run does not read, in one line, because many lines would hide a warning that
// matters.

#include <string>
#include <vector>

namespace flyrock::cli {

/// "not used: blast.spacing, blast.hole.stemming and 3 more change nothing (`flyrock check --strict` says
/// why)" from entries such as "blast.spacing (bench_fit does not read it)". `hint` says where the reasons
/// are. Empty if there are no entries.
std::string not_used_line(const std::vector<std::string>& entries, const std::string& hint);

}  // namespace flyrock::cli
