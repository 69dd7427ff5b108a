#pragma once
// Numbers of a quantity of a series over its steps, or over its impacts: mean, max, min, final, at a time.

#include <string>
#include <vector>

namespace flyrock {

/// The mean counts each step with its length, impacts alike. `at` is the step that contains the time.
struct OverSteps {
  std::string of_time;  ///< mean, max, min, final, at
  double time = 0;      ///< s, for `at`
  bool is_of_impacts = false;

  /// A quantity at the end of a step.
  struct Instant {
    double time = 0, step = 0;  ///< s; an impact has no duration
    double value = 0;
  };
  struct Answer {
    double value = 0;
    std::string fault;  ///< why there is no value
  };
  /// `whose`: "a and b have no contact", for faults.
  Answer of(const std::vector<Instant>& instants, const std::string& whose) const;
};

}  // namespace flyrock
