#pragma once
// A sample of numbers, some of them censored: its quantiles, its mean and their confidence intervals. The
// numbers are not kept; they are shown in passes, see results/selection.h.

#include <cstdint>
#include <limits>
#include <vector>

#include "results/selection.h"

namespace flyrock {

/// A number that may be affected by censored rocks. It is then a lower bound (a standard deviation is then
/// only unknown). NaN if there are too few rocks.
struct Bounded {
  double value = 0;
  bool censored = false;
};

/// The confidence of all intervals of a summary.
inline constexpr double stated_confidence = 0.95;

/// A confidence interval. An end is NaN if the sample does not give it: the sample is too small, or censored
/// values reach this end.
struct Interval {
  double lower = 0, upper = 0;
};

/// Mean and standard deviation of the sample, sqrt(sum (x - mean)^2 / (n - 1)). NaN if there are too few
/// numbers.
struct Moments {
  double mean = 0, sd = 0;
};

/// The questions that a sample must answer. They are needed in advance, because the passes look only for the
/// order statistics of these questions.
struct Questions {
  struct IntervalOf {
    double p, confidence;
  };
  std::vector<double> quantiles;      ///< p from 0 to 1
  std::vector<IntervalOf> intervals;  ///< of quantiles
};

/// x_0 <= ... <= x_{n-1}. Among equal values, known ones come before censored ones.
class Sample {
 public:
  explicit Sample(Questions questions = {}) : questions_(std::move(questions)) {}

  /// Adds a number. Every pass needs the same order, because sums depend on it.
  void add(const Bounded& value);
  /// Ends a pass. Returns whether the sample needs another one.
  bool needs_another_pass();

  std::uint64_t size() const { return count_; }
  bool any_censored() const { return least_censored_ < none; }
  Moments moments() const;

  /// Linear interpolation between the order statistics at h = (n - 1) p, as in NumPy and PERCENTILE.INC of
  /// spreadsheets: x_floor(h) + (h - floor(h)) (x_floor(h)+1 - x_floor(h)). Exact if every censored bound
  /// comes later in the order than the order statistics used here, because then the true values of censored
  /// rocks cannot change them. Otherwise a lower bound. NaN for an empty sample.
  Bounded quantile(double p) const;

  /// The interval of the quantile p from order statistics; it holds for any distribution of the values. The
  /// number of values below the quantile is binomial B(n, p). Therefore [x_(l), x_(u)], counted from 1,
  /// contains the quantile with at least this confidence, with the greatest l for which P(B < l) <= (1 -
  /// confidence) / 2 and the least u for which P(B >= u) <= (1 - confidence) / 2. Source: David and Nagaraja
  /// 2003, Order Statistics, 7.1. A censored bound is valid as the lower end, because it is below the true
  /// value; as the upper end it is not.
  Interval quantile_interval(double p, double confidence) const;

  /// The interval of the mean: mean -+ t sd / sqrt(n), Student's t with n - 1 degrees of freedom. It is valid
  /// for many values; fewer suffice if the tails are light. Not given for one value, or if any value is
  /// censored.
  Interval mean_interval(double confidence) const;

 private:
  static constexpr double none = std::numeric_limits<double>::infinity();

  std::vector<std::uint64_t> wanted_ranks() const;

  Questions questions_;
  int pass_ = 0;
  // Found in the first pass:
  std::uint64_t count_ = 0;
  double sum_ = 0, least_ = none, greatest_ = -none, least_censored_ = none;
  // Found in the second pass:
  double squares_ = 0;                ///< of the deviations from the mean
  std::uint64_t first_censored_ = 0;  ///< its rank
  // Used in the second and later passes:
  Selection selection_;
};

/// A sample of numbers that are already in memory.
Sample sample_of(const std::vector<Bounded>& values, const Questions& questions);

}  // namespace flyrock
