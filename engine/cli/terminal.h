#pragma once
// Progress on a terminal, and nothing of it in a pipe.

#include <chrono>

#include "batch/run.h"

namespace flyrock::cli {

/// A progress bar with rate and time left on stderr: only where that is a terminal, ten times a second at most.
class ProgressBar {
 public:
  explicit ProgressBar(bool wanted);
  ~ProgressBar();  ///< clears its line
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(const RunProgress& progress);

 private:
  using Clock = std::chrono::steady_clock;
  bool visible_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_{};
};

/// `text` in bold where stdout is a terminal and NO_COLOR is not set.
std::string bold(const std::string& text);

/// Whether Ctrl-C was pressed since catch_interrupt(). A second one ends the program at once.
bool was_interrupted();
void catch_interrupt();

}  // namespace flyrock::cli
