#pragma once
// How far the trial is that runs now, for who waits for it.

#include <atomic>

namespace flyrock {

/// Written by the run of a trial, read by another thread: each number by itself, for people only.
struct TrialWatch {
  std::atomic<double> time = 0;       ///< s, simulated; 0: no trial has begun
  std::atomic<double> stop_time = 0;  ///< s
  std::atomic<double> step = 0;       ///< s, the last one
  std::atomic<int> moving = 0, bodies = 0;
};

}  // namespace flyrock
