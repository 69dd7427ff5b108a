#pragma once
// Spearman's rank correlation with its confidence interval.

#include <cstdint>
#include <vector>

namespace flyrock {

/// Fewer pairs say too little, so they get no interval.
inline constexpr std::size_t least_pairs = 30;

struct RankCorrelation {
  double r = 0;                 ///< from -1 to 1; NaN if all values of a column are equal
  double lower = 0, upper = 0;  ///< ends of its interval; NaN for fewer than least_pairs pairs
};

/// The rank correlation of two columns of equal length: the correlation of their ranks. Equal values get the
/// mean of their ranks. The interval is that of Fisher's z with the variance (1 + r^2 / 2) / (n - 3). Source:
/// Bonett and Wright 2000, Sample size requirements for estimating Pearson, Kendall and Spearman
/// correlations.
RankCorrelation rank_correlation(const std::vector<double>& a, const std::vector<double>& b,
                                 double confidence);

/// A known correlation r of n pairs, with its interval.
RankCorrelation with_interval(double r, std::size_t n, double confidence);

}  // namespace flyrock
