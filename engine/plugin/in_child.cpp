#include "plugin/in_child.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

namespace flyrock {

bool succeeds_in_child(const std::function<void()>& work, std::optional<unsigned> seconds) {
  constexpr int succeeded = 86;  // a code that nothing but the last line of the child gives
  const pid_t child = ::fork();
  if (child == 0) {
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, stream);
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(signal, SIG_DFL);
    const rlimit no_core{}, processor_time{seconds.value_or(0), seconds.value_or(0)};
    ::setrlimit(RLIMIT_CORE, &no_core);
    if (seconds) ::setrlimit(RLIMIT_CPU, &processor_time);
    [&]() noexcept { work(); }();
    ::_exit(succeeded);
  }
  int status = 0;
  while (child > 0 && ::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  // Where no process can be made, the work is not tried.
  return child < 0 || (WIFEXITED(status) && WEXITSTATUS(status) == succeeded);
}

}  // namespace flyrock
