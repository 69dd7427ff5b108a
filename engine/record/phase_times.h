#pragma once
// Wall time by phase of the engine, for the log of a run. It never enters a result.

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

}  // namespace flyrock
