// flyrock: the program. Each command has its own file; dispatch.cpp finds the command.

#include <fcntl.h>

#include <csignal>

#include "cli/dispatch.h"

namespace {

/// Opens the standard files that the caller has closed, so that no file of a result takes the number of one
/// and gets the messages of the program. Messages to a closed stderr get lost; to write to a closed stdout
/// fails, because a command's output is not there.
void open_standard_files() {
  constexpr int modes[] = {O_RDONLY, O_RDONLY, O_WRONLY};
  for (int file = 0; file < 3; ++file)
    if (::fcntl(file, F_GETFD) == -1 && ::open("/dev/null", modes[file]) != file) return;
}

}  // namespace

int main(int count, char** words) {
  open_standard_files();
  std::signal(SIGXFSZ,
              SIG_IGN);  // so that a file above the size limit is an error like a full disk and does not end
                         // the program
  return flyrock::cli::dispatch({words + 1, words + count});
}
