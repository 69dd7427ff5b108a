#pragma once
// Places along a line whose distances are independent draws from one distribution (a renewal process).

#include <optional>
#include <vector>

#include "random/distribution.h"

namespace flyrock {

/// The mean of a distribution, from its quantiles.
double mean_of(const Distribution& law);

/// More are refused.
inline constexpr std::size_t most_places = 100000;

/// The places from `low` to `high`, ascending. One of them is at `origin`. Without an origin the process is
/// stationary: a place in any interval is as likely as in any other of the same length, so that there are
/// 1/mean of them in a unit of length. The gap that holds the middle is then drawn with a probability in
/// proportion to its length. The law must not be negative. Throws std::length_error if it meets more than
/// `most_places` on its way from the origin (or the middle) through the interval.
std::vector<double> places_with_spacing(const Distribution& law, std::optional<double> origin, double low,
                                        double high, RandomStream& rng);

}  // namespace flyrock
