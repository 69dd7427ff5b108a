#pragma once
// The runout for the report: a histogram, and the share of rocks that go farther than x.

#include <nlohmann/json_fwd.hpp>

#include "results/statistics.h"

namespace flyrock {

/// The counts of a histogram of runout, separately for known and for censored runouts, and the share of rocks
/// that went farther than x. A million rocks take no more memory than a thousand. Computed from the rocks of
/// one group, shown in passes.
class RunoutData {
 public:
  /// `count` runouts from `least` to `greatest` [m].
  RunoutData(std::uint64_t count, double least, double greatest);

  void add(const Bounded& runout);
  bool needs_another_pass();
  nlohmann::ordered_json data() const;

 private:
  std::uint64_t count_;
  double step_;
  bool binned_ = false;                          ///< first pass is done
  std::vector<std::uint64_t> known_, censored_;  ///< counts for each step
  double least_censored_ = std::numeric_limits<double>::infinity();
  std::vector<std::uint64_t> ranks_;  ///< of the points of the curve
  Selection curve_;
};

}  // namespace flyrock
