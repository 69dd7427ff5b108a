#pragma once
// Rounds numbers for plots, because few digits keep the page small.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>

namespace flyrock {

/// Four significant digits; null if the number is not finite.
nlohmann::ordered_json rounded(double value);

/// The nearest whole number of thousandths: metres become millimetres.
std::int64_t thousandth(double value);

}  // namespace flyrock
