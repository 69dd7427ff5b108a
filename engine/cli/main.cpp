// flyrock: the program. One file a command; dispatch.cpp finds the command.

#include <csignal>

#include "cli/dispatch.h"

int main(int count, char** words) {
  std::signal(SIGXFSZ,
              SIG_IGN);  // a file that grows beyond a limit is an error like a full disk, not a sudden end
  return flyrock::cli::dispatch({words + 1, words + count});
}
