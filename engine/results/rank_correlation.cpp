#include "results/rank_correlation.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>

#include "results/unknown.h"

namespace flyrock {

namespace {

/// Ranks minus their mean.
std::vector<double> centred_ranks(const std::vector<double>& values) {
  const std::size_t n = values.size();
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return values[i] < values[j]; });
  std::vector<double> ranks(n);
  for (std::size_t i = 0, end = 0; i < n; i = end) {
    for (end = i; end < n && values[order[end]] == values[order[i]];) ++end;
    for (std::size_t k = i; k < end; ++k)
      ranks[order[k]] = 0.5 * static_cast<double>(i + end - 1) - 0.5 * static_cast<double>(n - 1);
  }
  return ranks;
}

}  // namespace

RankCorrelation rank_correlation(const std::vector<double>& a, const std::vector<double>& b,
                                 double confidence) {
  const std::vector<double> x = centred_ranks(a), y = centred_ranks(b);
  const auto dot = [](const auto& u, const auto& v) {
    return std::inner_product(u.begin(), u.end(), v.begin(), 0.0);
  };
  const double scale = std::sqrt(dot(x, x) * dot(y, y));
  if (!(scale > 0)) return {unknown, unknown, unknown};
  return with_interval(std::clamp(dot(x, y) / scale, -1.0, 1.0), a.size(), confidence);
}

RankCorrelation with_interval(double r, std::size_t n, double confidence) {
  if (n < least_pairs) return {r, unknown, unknown};
  const double half = boost::math::quantile(boost::math::normal(), 0.5 * (1 + confidence)) *
                      std::sqrt((1 + 0.5 * r * r) / static_cast<double>(n - 3));
  return {r, std::tanh(std::atanh(r) - half), std::tanh(std::atanh(r) + half)};
}

}  // namespace flyrock
