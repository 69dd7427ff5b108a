#include <algorithm>
#include <cmath>

#include "report/report_data.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

constexpr double bins_wanted = 40;
constexpr std::size_t curve_points = 400;

/// The least of 1, 2, 5, 10, 20, ... and their fractions that is not below `width`.
double round_step(double width) {
  if (!(width > 0)) return 1;
  const double power = std::pow(10, std::floor(std::log10(width)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= width) return step * power;
  return 10 * power;
}

}  // namespace

Json runout_data(const std::vector<Bounded>& values) {
  std::vector<Bounded> sorted = values;
  std::sort(sorted.begin(), sorted.end(), [](const Bounded& a, const Bounded& b) {
    return a.value != b.value ? a.value < b.value : a.censored < b.censored;
  });
  const double farthest = sorted.empty() ? 0 : sorted.back().value;
  const double step = round_step(farthest / bins_wanted);
  const auto bins = static_cast<std::size_t>(farthest / step) + 1;
  std::vector<std::uint64_t> known(bins, 0), censored(bins, 0);
  for (const Bounded& v : sorted) {
    const auto bin = std::min(static_cast<std::size_t>(v.value / step), bins - 1);
    ++(v.censored ? censored : known)[bin];
  }

  // Share of rocks beyond x: at the value of rank i (from 0), the n - 1 - i behind it.
  Json x = Json::array(), share = Json::array();
  const std::size_t n = sorted.size();
  const std::size_t stride = std::max<std::size_t>(1, n / curve_points);
  // The tail is what the curve is read for: its last 100 rocks are never thinned.
  for (std::size_t i = 0; i < n; i += i + 100 >= n ? 1 : std::min(stride, n - 100 - i)) {
    x.push_back(std::llround(1000 * sorted[i].value));
    share.push_back(static_cast<double>(n - 1 - i) / static_cast<double>(n));
  }
  const auto first = std::find_if(sorted.begin(), sorted.end(), [](const Bounded& v) { return v.censored; });
  return {{"step", step},
          {"known", known},
          {"censored", censored},
          {"x", x},
          {"share", share},
          {"known_to", first == sorted.end() ? Json(nullptr) : Json(std::llround(1000 * first->value))}};
}

}  // namespace flyrock
