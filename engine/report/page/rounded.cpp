#include "report/page/rounded.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace flyrock {

nlohmann::ordered_json rounded(double value, int digits) {
  constexpr double least = 1e-290;  // so that the power of ten below is finite
  if (!std::isfinite(value)) return nullptr;
  if (std::abs(value) < least) return 0;
  // Division by a power of ten rounds correctly for decimals with so few digits; multiplication does not.
  const int decimals = digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
  const double scale = std::pow(10, std::abs(decimals));
  return decimals > 0 ? std::round(value * scale) / scale : std::round(value / scale) * scale;
}

std::int64_t thousandth(double value) {
  constexpr double farthest = 1e15;  // differences of two such numbers fit into 64 bits
  return std::isnan(value) ? 0 : std::llround(std::clamp(1000 * value, -farthest, farthest));
}

nlohmann::ordered_json differences(const std::vector<double>& values) {
  auto list = nlohmann::ordered_json::array();
  std::int64_t before = 0;
  for (const double value : values) {
    list.push_back(thousandth(value) - before);
    before = thousandth(value);
  }
  return list;
}

nlohmann::ordered_json runs_of(const std::vector<int>& values) {
  auto runs = nlohmann::ordered_json::array();
  for (std::size_t i = 0, end = 0; i < values.size(); i = end) {
    for (end = i; end < values.size() && values[end] == values[i];) ++end;
    runs.push_back(end - i);
    runs.push_back(values[i]);
  }
  return runs;
}

}  // namespace flyrock
