#pragma once
// Progress output on a terminal; none in a pipe.

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "batch/run.h"

namespace flyrock::cli {

/// A progress bar with rate and remaining time on stderr, only if stderr is a terminal and at most ten times
/// a second. If a trial takes longer than two seconds, a separate thread shows each second for how long.
class ProgressBar {
 public:
  explicit ProgressBar(bool wanted, std::uint64_t trials);
  ~ProgressBar();  ///< clears its line
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(const RunProgress& progress);
  /// Writes lines to stderr in place of the bar. The bar returns with the next progress.
  void write(const std::vector<std::string>& lines) const;

 private:
  using Clock = std::chrono::steady_clock;
  void watch(std::stop_token stop);
  void draw(Clock::time_point now);

  bool visible_;
  std::mutex mutex_;  ///< guards the members below
  RunProgress progress_;
  Clock::time_point start_ = Clock::now(), drawn_{}, last_trial_ = start_;
  std::condition_variable_any ended_;
  std::jthread watcher_;  ///< last, because it reads the others
};

/// "[####......] 4 of 10 trials, 20 rocks/s, 0:07 left", and the duration of the present trial if it is long.
/// Times in s.
std::string progress_text(const RunProgress& progress, double since_start, double since_last_trial);

/// `text` in bold if stdout is a terminal and NO_COLOR is not set.
std::string bold(const std::string& text);

/// Whether Ctrl-C was pressed after catch_interrupt(). A second Ctrl-C ends the program at once.
bool was_interrupted();
void catch_interrupt();

}  // namespace flyrock::cli
