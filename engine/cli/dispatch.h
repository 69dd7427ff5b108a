#pragma once
// The words of a command line to one command.

#include "cli/command.h"

namespace flyrock::cli {

/// Does what the words after `flyrock` ask for, and turns every exception into a line on stderr and an exit
/// code.
int dispatch(const Arguments& arguments);

}  // namespace flyrock::cli
