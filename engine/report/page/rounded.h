#pragma once
// Shortens numbers for plots, because few digits keep the page small.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace flyrock {

/// So many significant digits; null if the number is not finite. A number below 1e-290 is 0.
nlohmann::ordered_json rounded(double value, int digits = 4);

/// The nearest whole number of thousandths: metres become millimetres.
std::int64_t thousandth(double value);

/// Whole thousandths: the first value, then the differences.
nlohmann::ordered_json differences(const std::vector<double>& values);

/// Lengths and values of runs: { 0, 0, 1, 1, 1 } becomes [2, 0, 3, 1].
nlohmann::ordered_json runs_of(const std::vector<int>& values);

}  // namespace flyrock
