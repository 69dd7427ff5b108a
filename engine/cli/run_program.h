#pragma once
// Calls external programs, if they are installed.

#include <string>
#include <vector>

namespace flyrock::cli {

/// Runs a program found by PATH with its arguments and waits for it. False if there is no such program, or if
/// it ends with another code than 0. `is_quiet`: what it writes goes nowhere.
bool run_program(const std::vector<std::string>& words, bool is_quiet = false);

/// Whether PATH leads to a program of this name.
bool has_program(const std::string& name);

}  // namespace flyrock::cli
