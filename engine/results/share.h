#pragma once
// A share: k of n rocks, with its confidence interval.

#include <cstdint>

#include "results/sample.h"

namespace flyrock {

/// The exact interval of a binomial share. At its lower end, k or more of n have the probability (1 -
/// confidence) / 2; at its upper end, k or fewer have it. It contains the true share with at least this
/// confidence. For k = 0 the lower end is 0 and the upper end is 1 - ((1 - confidence) / 2)^(1/n). NaN for n
/// = 0. Source: Clopper and Pearson 1934.
Interval share_interval(std::uint64_t k, std::uint64_t n, double confidence);

/// A number of rocks divided by the number of all of them (NaN for 0 of 0), and its interval with
/// stated_confidence.
struct Share : Bounded {
  Interval interval;
};

/// The share k of n. `open` more rocks may still count. The share is then a lower bound, and the upper end of
/// the interval is that of k + open.
Share share_of(std::uint64_t k, std::uint64_t n, std::uint64_t open = 0);

/// The share of the other rocks. Where `share` is a lower bound, that of the others is an upper bound.
struct Complement {
  double value;
  bool is_upper_bound;
  Interval interval;
};
Complement complement_of(const Share& share);

}  // namespace flyrock
