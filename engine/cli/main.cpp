// flyrock: the program. Each command has its own file; dispatch.cpp finds the command.

#include <csignal>

#include "cli/dispatch.h"

int main(int count, char** words) {
  std::signal(SIGXFSZ,
              SIG_IGN);  // so that a file above the size limit is an error like a full disk and does not end
                         // the program
  return flyrock::cli::dispatch({words + 1, words + count});
}
