#pragma once
// Numbers as a plot needs them: few digits keep the page small.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>

namespace flyrock {

/// Four significant digits; null where the number is not finite.
nlohmann::ordered_json rounded(double value);

/// The nearest whole thousandth: metres as millimetres.
std::int64_t thousandth(double value);

}  // namespace flyrock
