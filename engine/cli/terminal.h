#pragma once
// What a command writes on stderr: messages and progress; and how it is interrupted.

#include <fmt/format.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "batch/run.h"
#include "record/trial_watch.h"

namespace flyrock::cli {

/// Writes a text to stderr, or as much as it takes: a message that is lost on a closed stderr, or on a full
/// disk, must not end a run.
void write_to_stderr(const std::string& text);

/// Writes a formatted message to stderr.
template <class... Values>
void tell(fmt::format_string<Values...> text, Values&&... values) {
  write_to_stderr(fmt::format(text, std::forward<Values>(values)...));
}

/// The progress of a run with rate and remaining time on stderr. On a terminal it is a bar, drawn at most ten
/// times a second. If a trial takes longer than two seconds, a separate thread shows each second for how
/// long. Elsewhere, as in the log of a batch system, it is a line at each tenth of the trials, at most once a
/// second, and after a minute without one.
class ProgressBar {
 public:
  /// `trial`: the one that is watched while it is long; null: none is.
  ProgressBar(bool wanted, std::uint64_t trials, const TrialWatch* trial = nullptr);
  ~ProgressBar();  ///< clears the bar
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(const RunProgress& progress);
  /// Writes lines to stderr in place of the bar. The bar returns with the next progress.
  void write(const std::vector<std::string>& lines) const;

 private:
  using Clock = std::chrono::steady_clock;
  void watch(std::stop_token stop);
  bool is_due(Clock::time_point now) const;
  void draw(Clock::time_point now);

  const TrialWatch* trial_;
  bool visible_, bar_;  ///< bar_: stderr is a terminal
  std::mutex mutex_;    ///< guards the members below
  RunProgress progress_;
  std::uint64_t tenths_ = 0;  ///< tenths of the trials in the last line
  Clock::time_point start_ = Clock::now(), drawn_{}, last_trial_ = start_;
  std::condition_variable_any ended_;
  std::jthread watcher_;  ///< last, because it reads the others
};

/// "[####......] 4 of 10 trials, 20 rocks/s, 0:07 left", and how far the present trial is if it is long:
/// "this trial for 0:05 by now, t = 2.3 of 60 s, 97 of 100 move, step 4 ms". Times in s.
std::string progress_text(const RunProgress& progress, double since_start, double since_last_trial,
                          const TrialWatch* trial);

/// Says what an interrupted run has kept.
void tell_interrupted(std::uint64_t kept, std::uint64_t trials, const std::string& folder);

/// `text` in bold if stdout is a terminal and NO_COLOR is not set.
std::string bold(const std::string& text);

/// Whether Ctrl-C was pressed, or the program was asked to end (SIGTERM), after catch_interrupt(). The second
/// time ends the program at once.
bool was_interrupted();
void catch_interrupt();

}  // namespace flyrock::cli
