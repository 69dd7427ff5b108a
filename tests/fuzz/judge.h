#pragma once
// Judges what a command printed and returned; the rules hold for any input.

#include <string>

#include "cli/command.h"

namespace flyrock::fuzz {

/// How the errors about a kind of input must begin.
enum class ErrorForm {
  placed,  ///< "file:line:column: error: "
  named    ///< "error: " or "file: error: ": for a binary file, a folder or the command line
};

/// Why the answer of a command is wrong; empty if it is not. Faults:
///   - an exit code that the command does not have, or 3 although no rock failed (an uncaught exception);
///   - bad input (2) without an error, or with an error that does not begin as it must;
///   - an error although the exit code means success;
///   - control characters, or the text of a library instead of one of flyrock.
std::string fault_of(const cli::Arguments& arguments, int code, const std::string& err, ErrorForm form);

}  // namespace flyrock::fuzz
