#pragma once
// Runout as the report draws it: a histogram, and the share of rocks that go farther.

#include <nlohmann/json_fwd.hpp>

#include "results/statistics.h"

namespace flyrock {

/// The counts of a histogram of runout, the rocks whose runout is known beside those that are censored, and
/// the share of rocks that went farther than x. Both need no more room for a million rocks than for a
/// thousand. Made of the rocks of one group, shown in passes.
class RunoutData {
 public:
  /// `count` runouts from `least` to `greatest` [m].
  RunoutData(std::uint64_t count, double least, double greatest);

  void add(const Bounded& runout);
  bool again();
  nlohmann::ordered_json data() const;

 private:
  std::uint64_t count_;
  double step_;
  bool binned_ = false;                          ///< in the first pass
  std::vector<std::uint64_t> known_, censored_;  ///< of each step
  double least_censored_ = std::numeric_limits<double>::infinity();
  std::vector<std::uint64_t> ranks_;  ///< of the points of the curve
  Selection curve_;
};

}  // namespace flyrock
