#pragma once
// The runout for the report: a histogram, and the share of rocks that go farther than x.

#include <nlohmann/json_fwd.hpp>

#include "results/statistics/statistics.h"

namespace flyrock {

/// The counts of a histogram of runout (where the weights of rocks differ, their sums), separately for known
/// and for censored runouts, and the share of rocks that went farther than x. A million rocks take no more
/// memory than a thousand. Computed from the rocks of one group, shown in passes.
class RunoutData {
 public:
  explicit RunoutData(const RunoutExtent& extent);

  void add(const Bounded& runout, double weight);
  bool needs_another_pass();
  nlohmann::ordered_json data() const;

 private:
  std::uint64_t count_;
  bool is_weighted_;  ///< the weights differ
  double weight_;     ///< of all: their number without weights
  double step_;
  bool binned_ = false;                   ///< first pass is done
  std::vector<double> known_, censored_;  ///< for each step
  double least_censored_ = infinite;
  std::vector<double> ranks_;  ///< of the points of the curve
  Selection curve_;
};

}  // namespace flyrock
