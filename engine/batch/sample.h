#pragma once
// A sample of numbers of which some are censored: its percentiles, its mean and their confidence intervals.

#include <cstddef>
#include <vector>

namespace flyrock {

/// A number that censored rocks may have had a hand in: then it is a lower bound (of the standard deviation:
/// merely not known). NaN where there are too few rocks.
struct Bounded {
  double value = 0;
  bool censored = false;
};

/// A confidence interval; NaN for an end that the sample does not give: it is too small, or censored values reach it.
struct Interval {
  double lower = 0, upper = 0;
};

/// Values in order, x_0 <= ... <= x_{n-1}; at equal values the known come before the censored.
class Sample {
 public:
  explicit Sample(std::vector<Bounded> values);

  std::size_t size() const { return sorted_.size(); }
  bool any_censored() const { return first_censored_ < sorted_.size(); }

  /// Linear between the order statistics at h = (n - 1) p, as NumPy and the PERCENTILE.INC of spreadsheets:
  /// x_floor(h) + (h - floor(h)) (x_floor(h)+1 - x_floor(h)). Exact where the order statistics up to those that it reads
  /// hold whatever the censored values truly are, that is where every censored bound lies behind them in the order; else
  /// a lower bound. NaN of an empty sample.
  Bounded percentile(std::size_t percent) const;
  /// The same for p from 0 to 1; a percent as above has no rounding in its rank.
  Bounded quantile(double p) const;

  /// Of the quantile p, from order statistics, whatever the distribution of the values: their number below the quantile is
  /// binomial B(n, p), so that [x_(l), x_(u)], counted from 1, with the greatest l for which P(B < l) <= (1 - confidence)
  /// / 2 and the least u for which P(B >= u) is, holds it with at least that confidence. Source: David and Nagaraja 2003,
  /// Order Statistics, 7.1. A censored bound at the lower end is below the true value and holds; at the upper not.
  Interval quantile_interval(double p, double confidence) const;

  /// Of the mean: mean -+ t sd / sqrt(n), Student's t with n - 1 degrees of freedom; holds for many values, fewer where
  /// tails are light. Not given for one value, nor where any is censored.
  Interval mean_interval(double confidence) const;

 private:
  Bounded between(std::size_t low, double share) const;

  std::vector<Bounded> sorted_;
  std::size_t first_censored_ = 0;
};

/// Mean, and standard deviation of the sample, sum (x - mean)^2 / (n - 1) under the root; in the order of `values`. NaN
/// where there are too few.
struct Moments {
  double mean = 0, sd = 0;
};
Moments moments_of(const std::vector<Bounded>& values);

}  // namespace flyrock
