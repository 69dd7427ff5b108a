#pragma once
// Numbers as a plot needs them: few digits keep the page small.

#include <nlohmann/json.hpp>

namespace flyrock {

/// Four significant digits; null where the number is not finite.
nlohmann::ordered_json rounded(double value);

}  // namespace flyrock
