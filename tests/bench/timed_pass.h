#pragma once
// The time of a short piece of work, from rounds that are far apart.

#include <algorithm>
#include <ctime>
#include <functional>
#include <stdexcept>
#include <vector>

namespace flyrock {

/// A pass makes many calls and returns the sum of their answers. It must return the same sum each time.
/// Because the sum is compared, the compiler cannot drop a call. Measure a round of each of many passes in
/// turn: then a time at which the machine is slow falls into one round of each, and the median leaves it out.
class TimedPass {
 public:
  TimedPass(int calls, std::function<double()> pass)
      : calls_(calls), pass_(std::move(pass)), answer_(pass_()) {
    while (seconds_of_repeats() < round_time) repeats_ *= 2;
  }

  void measure_round() {
    check(pass_());  // warms up the caches
    seconds_.push_back(seconds_of_repeats());
  }

  /// The median of the rounds, for one call.
  double nanoseconds() const {
    std::vector<double> sorted = seconds_;
    std::sort(sorted.begin(), sorted.end());
    return 1e9 * sorted[sorted.size() / 2] / repeats_ / calls_;
  }
  double answer() const { return answer_; }

 private:
  static constexpr double round_time = 2e-3;  // s, at least: the clock counts microseconds

  void check(double answer) const {
    if (answer != answer_) throw std::runtime_error("two passes over the same placements differ");
  }

  /// Processor time, because other programs take none of it.
  double seconds_of_repeats() const {
    const std::clock_t start = std::clock();
    for (int i = 0; i < repeats_; ++i) check(pass_());
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  }

  int calls_, repeats_ = 1;
  std::function<double()> pass_;
  double answer_;
  std::vector<double> seconds_;
};

}  // namespace flyrock
