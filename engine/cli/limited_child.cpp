#include "cli/limited_child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <stdexcept>

#include "cli/command.h"

namespace flyrock::cli {

namespace fs = std::filesystem;

namespace {

void limit_to(int resource, std::uintmax_t most) {
  const rlimit limit{static_cast<rlim_t>(most), static_cast<rlim_t>(most)};
  ::setrlimit(resource, &limit);
}

void limit_child(const ChildLimits& limits) {
  limit_to(RLIMIT_CORE, 0);
  limit_to(RLIMIT_FSIZE, limits.output);
  const rlimit time{limits.seconds, limits.seconds + 1};  // SIGXCPU, then SIGKILL
  ::setrlimit(RLIMIT_CPU, &time);
#if !defined(__SANITIZE_ADDRESS__)  // the sanitizer maps terabytes of addresses
  limit_to(RLIMIT_AS, limits.memory);
#endif
  for (const int signal : {SIGXCPU, SIGXFSZ, SIGSEGV, SIGABRT}) std::signal(signal, SIG_DFL);
}

/// The part of the child. What is printed goes to the log.
[[noreturn]] void be_child(const ChildLimits& limits, const fs::path& log, const std::function<int()>& work) {
  const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) ::dup2(file, stream);
  limit_child(limits);
  int code = bad_input;
  try {
    code = work();
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "error: it needs more than {:.0f} MB of memory\n",
               1e-6 * static_cast<double>(limits.memory));
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
  }
  std::fflush(nullptr);
  ::_exit(code);
}

std::uintmax_t bytes_in(const fs::path& folder) {
  std::uintmax_t bytes = 0;
  std::error_code code;
  for (fs::recursive_directory_iterator at(folder, code), end; !code && at != end; at.increment(code)) {
    std::error_code gone;
    const std::uintmax_t size = at->is_regular_file(gone) ? at->file_size(gone) : 0;
    if (!gone) bytes += size;
  }
  return bytes;
}

std::string ended_by(int signal, const ChildLimits& limits) {
  if (signal == SIGXCPU || signal == SIGKILL)
    return fmt::format("it took more than {} s of processor time", limits.seconds);
  if (signal == SIGXFSZ)
    return fmt::format("it wrote more than {:.0f} MB of results", 1e-6 * static_cast<double>(limits.output));
  return fmt::format("flyrock ended with signal {}", signal);
}

}  // namespace

ChildEnd run_limited(const ChildLimits& limits, const fs::path& log, const fs::path& folder,
                     const std::function<int()>& work) {
  constexpr useconds_t pause = 20'000;  // microseconds between two looks
  constexpr int looks_at_files = 10;
  std::fflush(nullptr);  // the child must not write what waits here
  const pid_t child = ::fork();
  if (child == 0) be_child(limits, log, work);
  if (child < 0) throw std::runtime_error("no process can be made");
  const auto begin = std::chrono::steady_clock::now();
  ChildEnd end;
  rusage used{};
  int status = 0;
  for (int look = 0;; ++look) {
    const pid_t found = ::wait4(child, &status, WNOHANG, &used);
    if (found == child || (found < 0 && errno != EINTR)) break;
    const bool is_late = std::chrono::steady_clock::now() - begin > std::chrono::seconds(10 * limits.seconds);
    if (end.why.empty() && is_late) end.why = fmt::format("it did not end within {} s", 10 * limits.seconds);
    if (end.why.empty() && look % looks_at_files == 0 && bytes_in(folder) > limits.output)
      end.why = ended_by(SIGXFSZ, limits);
    if (!end.why.empty()) ::kill(child, SIGKILL);
    ::usleep(pause);
  }
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  end.seconds = seconds(used.ru_utime) + seconds(used.ru_stime);
  if (!end.why.empty()) return end;
  if (WIFEXITED(status))
    end.code = WEXITSTATUS(status);
  else
    end.why = ended_by(WTERMSIG(status), limits);
  return end;
}

}  // namespace flyrock::cli
