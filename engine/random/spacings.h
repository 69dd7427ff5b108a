#pragma once
// Places along a line whose distances are independent draws from one distribution (a renewal process).

#include <optional>
#include <vector>

#include "random/distribution.h"

namespace flyrock {

/// The mean of a distribution, from its quantiles.
double mean_of(const Distribution& law);

/// A number longer than all but `Distribution::negligible` of the draws would be drawn for ever.
inline constexpr std::size_t most_places = 100000;

/// The places from `low` to `high`, ascending. One of them is at `origin`. Without an origin the process is
/// stationary: a place in any interval is as likely as in any other of the same length, so that there are
/// 1/mean of them in a unit of length. The gap that holds the middle is then drawn with a probability in
/// proportion to its length. Stops at `most_places`, as an error of the caller. The law must not be negative.
std::vector<double> places_with_spacing(const Distribution& law, std::optional<double> origin, double low,
                                        double high, RandomStream& rng);

}  // namespace flyrock
