#pragma once

#include <limits>

namespace flyrock {

/// A number that the rocks of a run do not give: there are too few of them, or none.
inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace flyrock
