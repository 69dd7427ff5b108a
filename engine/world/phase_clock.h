#pragma once
// Measures the wall time of a phase.

#include <chrono>

#include "record/phase_times.h"

namespace flyrock {

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
