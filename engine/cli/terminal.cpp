#include "cli/terminal.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace flyrock::cli {

namespace {

volatile std::sig_atomic_t interrupt_flag = 0;

std::string clock_time(double seconds) {
  const auto whole = static_cast<long>(seconds + 0.5);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

ProgressBar::ProgressBar(bool wanted) : visible_(wanted && ::isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
  if (visible_) fmt::print(stderr, "\r\033[K");
}

void ProgressBar::show(const RunProgress& progress) {
  if (!visible_) return;
  const Clock::time_point now = Clock::now();
  if (now - last_ < std::chrono::milliseconds(100) && progress.done < progress.total) return;
  last_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double share = static_cast<double>(progress.done) / static_cast<double>(progress.total);
  // Chunks of an earlier run took no time of this one.
  const double left = seconds * static_cast<double>(progress.total - progress.done) /
                      static_cast<double>(std::max<std::uint64_t>(1, progress.done - progress.kept));
  const auto filled = static_cast<std::size_t>(30 * share);
  fmt::print(stderr, "\r[{}{}] {} of {} trials, {:.0f} rocks/s, {} left\033[K", std::string(filled, '#'),
             std::string(30 - filled, '.'), progress.done, progress.total,
             static_cast<double>(progress.rocks) / seconds, clock_time(left));
  std::fflush(stderr);
}

std::string bold(const std::string& text) {
  const char* no_color = std::getenv("NO_COLOR");
  if (::isatty(STDOUT_FILENO) == 0 || (no_color && *no_color)) return text;
  return "\033[1m" + text + "\033[0m";
}

bool was_interrupted() { return interrupt_flag != 0; }

void catch_interrupt() {
  struct sigaction action {};
  action.sa_handler = [](int) { interrupt_flag = 1; };
  action.sa_flags = SA_RESETHAND | SA_RESTART;
  ::sigaction(SIGINT, &action, nullptr);
}

}  // namespace flyrock::cli
