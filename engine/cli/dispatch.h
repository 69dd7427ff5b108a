#pragma once
// Gives the words of a command line to a command.

#include <span>

#include "cli/command.h"

namespace flyrock::cli {

/// Executes the words after `flyrock`. Turns every exception into a line on stderr and an exit code.
int dispatch(const Arguments& arguments);

/// All commands, in the order of the help.
std::span<const Command> all_commands();

}  // namespace flyrock::cli
