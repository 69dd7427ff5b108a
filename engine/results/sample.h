#pragma once
// A sample of numbers of which some are censored: its quantiles, its mean and their confidence intervals. The
// numbers are not kept: they are shown in passes, see results/selection.h.

#include <cstdint>
#include <limits>
#include <vector>

#include "results/selection.h"

namespace flyrock {

/// A number that censored rocks may have had a hand in: then it is a lower bound (of the standard deviation:
/// merely not known). NaN where there are too few rocks.
struct Bounded {
  double value = 0;
  bool censored = false;
};

/// The confidence that all intervals of a summary have.
inline constexpr double stated_confidence = 0.95;

/// A confidence interval; NaN for an end that the sample does not give: it is too small, or censored values
/// reach it.
struct Interval {
  double lower = 0, upper = 0;
};

/// Mean, and standard deviation of the sample, sum (x - mean)^2 / (n - 1) under the root. NaN where there are
/// too few.
struct Moments {
  double mean = 0, sd = 0;
};

/// What a sample will be asked. Nothing else that rests on order statistics can be answered: they are looked
/// for.
struct Questions {
  struct IntervalOf {
    double p, confidence;
  };
  std::vector<double> quantiles;      ///< p from 0 to 1
  std::vector<IntervalOf> intervals;  ///< of quantiles
};

/// x_0 <= ... <= x_{n-1}; at equal values the known come before the censored.
class Sample {
 public:
  explicit Sample(Questions questions = {}) : questions_(std::move(questions)) {}

  /// Each number, in the same order in every pass (sums run in it).
  void add(const Bounded& value);
  /// Ends a pass; whether another one is needed before the sample can answer.
  bool again();

  std::uint64_t size() const { return count_; }
  bool any_censored() const { return least_censored_ < none; }
  Moments moments() const;

  /// Linear between the order statistics at h = (n - 1) p, as NumPy and the PERCENTILE.INC of spreadsheets:
  /// x_floor(h) + (h - floor(h)) (x_floor(h)+1 - x_floor(h)). Exact where the order statistics up to those
  /// that it reads hold whatever the censored values truly are, that is where every censored bound lies
  /// behind them in the order; else a lower bound. NaN of an empty sample.
  Bounded quantile(double p) const;

  /// Of the quantile p, from order statistics, whatever the distribution of the values: their number below
  /// the quantile is binomial B(n, p), so that [x_(l), x_(u)], counted from 1, with the greatest l for which
  /// P(B < l) <= (1 - confidence) / 2 and the least u for which P(B >= u) is, holds it with at least that
  /// confidence. Source: David and Nagaraja 2003, Order Statistics, 7.1. A censored bound at the lower end is
  /// below the true value and holds; at the upper not.
  Interval quantile_interval(double p, double confidence) const;

  /// Of the mean: mean -+ t sd / sqrt(n), Student's t with n - 1 degrees of freedom; holds for many values,
  /// fewer where tails are light. Not given for one value, nor where any is censored.
  Interval mean_interval(double confidence) const;

 private:
  static constexpr double none = std::numeric_limits<double>::infinity();

  std::vector<std::uint64_t> wanted_ranks() const;

  Questions questions_;
  int pass_ = 0;
  // The first pass:
  std::uint64_t count_ = 0;
  double sum_ = 0, least_ = none, greatest_ = -none, least_censored_ = none;
  // The second:
  double squares_ = 0;                ///< of the departures from the mean
  std::uint64_t first_censored_ = 0;  ///< its rank
  // The second and later ones:
  Selection selection_;
};

/// A sample of numbers that are in memory.
Sample sample_of(const std::vector<Bounded>& values, const Questions& questions);

}  // namespace flyrock
