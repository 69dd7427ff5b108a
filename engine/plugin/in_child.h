#pragma once
// Tries in a child process what may end the process.

#include <functional>
#include <optional>

namespace flyrock {

/// Whether a child process (fork) comes to the end of `work`: without a signal, an exit or an exception, and
/// in `seconds` of processor time, if any are given. The child writes to no terminal.
bool succeeds_in_child(const std::function<void()>& work, std::optional<unsigned> seconds = {});

}  // namespace flyrock
