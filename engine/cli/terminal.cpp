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

std::uint64_t tenths_of(const RunProgress& progress) {
  return progress.total == 0 ? 0 : 10 * progress.done / progress.total;
}

}  // namespace

void write_to_stderr(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

std::string progress_text(const RunProgress& progress, double since_start, double since_last_trial,
                          const TrialWatch* trial) {
  constexpr double long_trial = 2;  // s
  const double share = static_cast<double>(progress.done) / static_cast<double>(progress.total);
  const auto filled = static_cast<std::size_t>(30 * share);
  std::string text = fmt::format("[{}{}] {} of {} trials", std::string(filled, '#'),
                                 std::string(30 - filled, '.'), progress.done, progress.total);
  if (progress.done > progress.kept) {  // chunks of an earlier run took no time in this one
    const double left = since_start * static_cast<double>(progress.total - progress.done) /
                        static_cast<double>(progress.done - progress.kept);
    text += fmt::format(", {:.0f} rocks/s, {} left", static_cast<double>(progress.rocks) / since_start,
                        clock_time(left));
  }
  if (since_last_trial < long_trial) return text;
  text += fmt::format(", this trial for {} by now", clock_time(since_last_trial));
  if (trial && trial->time > 0 && trial->bodies > 1)
    text +=
        fmt::format(", t = {:.3g} of {:.3g} s, {} of {} move, step {:.2g} ms", trial->time.load(),
                    trial->stop_time.load(), trial->moving.load(), trial->bodies.load(), 1e3 * trial->step);
  return text;
}

ProgressBar::ProgressBar(bool wanted, std::uint64_t trials, const TrialWatch* trial)
    : trial_(trial), visible_(wanted), bar_(::isatty(STDERR_FILENO) != 0) {
  progress_.total = trials;
  if (!bar_) drawn_ = start_;
  if (visible_) watcher_ = std::jthread([this](std::stop_token stop) { watch(std::move(stop)); });
}

ProgressBar::~ProgressBar() {
  if (!visible_) return;
  watcher_ = {};  // stops and joins
  if (bar_) write_to_stderr("\r\033[K");
}

void ProgressBar::show(const RunProgress& progress) {
  if (!visible_) return;
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  progress_ = progress;
  last_trial_ = now;
  if (is_due(now)) draw(now);
}

/// Whether this progress is worth drawing again.
bool ProgressBar::is_due(Clock::time_point now) const {
  if (bar_) return now - drawn_ >= std::chrono::milliseconds(100) || progress_.done == progress_.total;
  return now - drawn_ >= std::chrono::seconds(1) && tenths_of(progress_) > tenths_;
}

void ProgressBar::watch(std::stop_token stop) {
  constexpr std::chrono::seconds each(1);
  const std::chrono::seconds silence(bar_ ? 1 : 60);
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    ended_.wait_for(lock, stop, each, [] { return false; });
    const Clock::time_point now = Clock::now();
    if (!stop.stop_requested() && now - drawn_ >= silence) draw(now);
  }
}

void ProgressBar::draw(Clock::time_point now) {
  const auto seconds = [&](Clock::time_point since) {
    return std::chrono::duration<double>(now - since).count();
  };
  drawn_ = now;
  tenths_ = tenths_of(progress_);
  const std::string text = progress_text(progress_, seconds(start_), seconds(last_trial_), trial_);
  write_to_stderr(bar_ ? fmt::format("\r{}\033[K", text) : text + '\n');
}

void ProgressBar::write(const std::vector<std::string>& lines) const {
  for (const std::string& line : lines) tell("{}{}\n", visible_ && bar_ ? "\r\033[K" : "", line);
}

void tell_interrupted(std::uint64_t kept, std::uint64_t trials, const std::string& folder) {
  if (kept == 0)
    tell("interrupted after 0 of {} trials: none was complete, nothing is kept, --resume begins anew\n",
         trials);
  else
    tell("interrupted after {} of {} trials; what was done is kept in {}, --resume goes on\n", kept, trials,
         folder);
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
  for (const int signal : {SIGINT, SIGTERM}) ::sigaction(signal, &action, nullptr);
}

}  // namespace flyrock::cli
