#pragma once
// How the percentiles of the runout settle as more rocks are run.

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "results/statistics/statistics.h"

namespace flyrock {

/// The percentiles of the first n rocks of a group, with their intervals, for up to 24 counts n. The counts
/// grow in equal ratios up to all rocks. See read_in_passes().
class Convergence {
 public:
  /// `count`: the number of rocks without faults that will be shown.
  explicit Convergence(std::uint64_t count);

  void add(const Bounded& runout, std::uint64_t trial, double weight);
  bool needs_another_pass();

  /// { n: [...], p50: { value, lower, upper, censored: [...] }, p95: ..., p99: ... }
  nlohmann::ordered_json data() const;

 private:
  struct Start {
    std::uint64_t count;  ///< rocks
    Sample sample;
  };
  std::vector<Start> starts_;
  std::uint64_t seen_ = 0;  ///< rocks, in this pass
};

}  // namespace flyrock
