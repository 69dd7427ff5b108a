#pragma once
// The keys of a scenario that a run does not read: of `run` in one line, because many lines would hide a
// warning that matters; of `check` all of them.

#include <string>
#include <vector>

namespace flyrock::cli {

/// "not used: blast.spacing, blast.hole.stemming and 3 more change nothing (the report says why)" from
/// entries such as "blast.spacing (bench_fit does not read it)". Empty if there are no entries.
std::string not_used_line(const std::vector<std::string>& entries);

/// A line for each entry: "not used: blast.spacing (bench_fit does not read it)".
std::string not_used_list(const std::vector<std::string>& entries);

}  // namespace flyrock::cli
