#pragma once
// What a command must have said and answered, whatever it was given.

#include <string>

#include "cli/command.h"

namespace flyrock::fuzz {

/// How the errors of a kind of input begin.
enum class ErrorForm {
  placed,  ///< "file:line:column: error: "
  named    ///< "error: " or "file: error: ": of a binary file, a folder or the command line
};

/// What is wrong with the answer of a command; an empty text where nothing is:
///   an exit code that the command does not have, or 3 where no rock failed (an exception that nobody
///   caught), bad input (2) without an error, or with one that does not begin as it must, an error although
///   the exit code says that all went well, control characters, or the text of a library instead of one of
///   flyrock.
std::string fault_of(const cli::Arguments& arguments, int code, const std::string& err, ErrorForm form);

}  // namespace flyrock::fuzz
