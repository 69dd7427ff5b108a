#pragma once
// The start and the end of commands that build results.

#include "batch/chunk.h"
#include "cli/command.h"
#include "report/tables/tables.h"
#include "results/results.h"

namespace flyrock::cli {

/// Prints to stderr the rocks that failed and, after the words `early_end`, why a run ended early.
void print_faults(const Results& results, const char* early_end = "error: the run ended early");

/// The exit code of a run that has ended: done, expectation_failed or faults.
int exit_code(const Results& results);

/// A log with the present time and place.
RunLog start_log();

/// Trials of all points in `chunks`.
std::uint64_t trials_in(const std::vector<ChunkRange>& chunks);
/// Trials of each point in `chunks`.
std::vector<std::uint64_t> trials_of(const std::vector<ChunkRange>& chunks, std::size_t points);

}  // namespace flyrock::cli
