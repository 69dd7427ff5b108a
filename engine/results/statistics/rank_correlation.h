#pragma once
// Spearman's rank correlation with its confidence interval.

#include <cstdint>
#include <vector>

#include "results/statistics/sample.h"

namespace flyrock {

/// Fewer pairs, or pairs of fewer trials, say too little, so they get no interval.
inline constexpr std::size_t least_pairs = 30;

/// To which trial each pair belongs, and the number of real rocks that it stands for. Pairs of a trial follow
/// each other.
struct PairUnits {
  std::vector<std::uint64_t> trial;
  std::vector<double> weight;

  std::size_t size() const { return trial.size(); }
  void add(std::uint64_t of_trial, double with_weight) {
    trial.push_back(of_trial);
    weight.push_back(with_weight);
  }
};

struct RankCorrelation {
  double r = 0;               ///< from -1 to 1; NaN if all values of a column are equal
  double effective_size = 0;  ///< the number of independent pairs that say as much
  std::uint64_t trials = 0;
  bool is_by_trial = false;  ///< some trial has several pairs

  /// The interval of Fisher's z with the variance (1 + r^2 / 2) / (n - 3), n: effective_size. Where trials
  /// have several pairs, Student's t with trials - 1 degrees of freedom takes the place of the normal
  /// deviate. NaN for fewer than least_pairs trials. Source: Bonett and Wright 2000, Sample size
  /// requirements for estimating Pearson, Kendall and Spearman correlations.
  Interval interval(double confidence) const;
};

/// The rank correlation of two columns of equal length: the correlation of their ranks. Equal values get the
/// mean of their ranks. With weights, a rank is the weight of what lies below, and half of that of equals.
///
/// Pairs of one trial depend on each other. With e_i the influence of pair i on r (the derivative of r by the
/// weight of the pair, centred), the effective size is sum w . sum w e^2 / sum_t (sum_{i in t} w_i e_i)^2, at
/// most the number of pairs; it is that number where each trial has one pair and the weights are equal. With
/// the ranks F and G from -1/2 to 1/2,
///   e_i = F_i G_i + sum_j w_j [F_j >= F_i] G_j / sum w + sum_j w_j [G_j >= G_i] F_j / sum w.
/// Source: Croux and Dehon 2010, Influence functions of the Spearman and Kendall correlation measures.
RankCorrelation rank_correlation(const std::vector<double>& a, const std::vector<double>& b,
                                 const PairUnits& units);

}  // namespace flyrock
