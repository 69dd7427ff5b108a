#pragma once
// The commit of the sources. It is no part of what a run computes from: rocks.csv and summary.json do not
// name it.

namespace flyrock {

/// "4e24b67ab1", followed by "+changes" if files differed from it; empty if the sources were no git
/// repository. The build writes this function (commit.cmake).
const char* source_commit();

}  // namespace flyrock
