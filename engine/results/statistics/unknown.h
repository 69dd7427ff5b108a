#pragma once
// A number that is not known.

#include <limits>

namespace flyrock {

/// A number that is unknown because a run has too few rocks, or none.
inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace flyrock
