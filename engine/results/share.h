#pragma once
// A share: k of n rocks, and how well it is known.

#include <cstdint>

#include "results/sample.h"

namespace flyrock {

/// Source: Clopper and Pearson 1934, the exact interval of a binomial share: its lower end is the share with
/// which k or more of n come with a probability of (1 - confidence) / 2, its upper end that with which k or
/// fewer do. It holds at least that often; of 0 of n the lower end is 0 and the upper one 1 - ((1 -
/// confidence) / 2)^(1/n). NaN of none of 0.
Interval share_interval(std::uint64_t k, std::uint64_t n, double confidence);

/// A number of rocks over all of them, NaN of none of 0, and its interval with the confidence that all of a
/// summary have.
struct Share : Bounded {
  Interval interval;
};

/// The share k of n; `open` more of these may yet count, which makes it a lower bound: the upper end is that
/// of k + open.
Share share_of(std::uint64_t k, std::uint64_t n, std::uint64_t open = 0);

}  // namespace flyrock
