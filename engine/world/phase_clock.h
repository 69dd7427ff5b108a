#pragma once
// Wall time by phase of the engine, for the log of a run. It never enters a result.

#include <chrono>
#include <cstdint>

namespace flyrock {

/// Nanoseconds.
struct PhaseTimes {
  std::int64_t flight = 0, detect = 0, solve = 0, other = 0;

  void add(const PhaseTimes& times) {
    flight += times.flight;
    detect += times.detect;
    solve += times.solve;
    other += times.other;
  }
};

/// Adds the wall time of its scope to one phase. Does nothing if there is no clock.
class PhaseTimer {
 public:
  PhaseTimer(PhaseTimes* times, std::int64_t PhaseTimes::*phase) : times_(times), phase_(phase) {
    if (times_) start_ = std::chrono::steady_clock::now();
  }
  ~PhaseTimer() {
    if (times_) times_->*phase_ += (std::chrono::steady_clock::now() - start_).count();
  }
  PhaseTimer(const PhaseTimer&) = delete;
  PhaseTimer& operator=(const PhaseTimer&) = delete;

 private:
  PhaseTimes* times_;
  std::int64_t PhaseTimes::*phase_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace flyrock
