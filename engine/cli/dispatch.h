#pragma once
// Gives the words of a command line to a command.

#include "cli/command.h"

namespace flyrock::cli {

/// Executes the words after `flyrock`. Turns every exception into a line on stderr and an exit code.
int dispatch(const Arguments& arguments);

}  // namespace flyrock::cli
