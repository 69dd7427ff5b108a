#pragma once
// The energy distance of two samples, on a line or in the plane:
//   ED = 2 E|X - Y| - E|X - X'| - E|Y - Y'|,
// with means over all pairs of the two samples, also of a value with itself. It is 0 for equal samples and
// positive for others, in the unit of the values: about sqrt(4/pi) sd for one value against a spread sd.
// Source: G. J. Szekely and M. L. Rizzo, Energy statistics, J. Stat. Plann. Inference 143, 2013.

#include <vector>

#include "math/space.h"

namespace flyrock {

/// A sample of numbers in rising order, whose mean distances take no pass over it.
class SortedSample {
 public:
  SortedSample() = default;
  explicit SortedSample(std::vector<double> values);

  std::size_t size() const { return values_.size(); }
  bool empty() const { return values_.empty(); }
  const std::vector<double>& values() const { return values_; }
  double mean() const;
  /// With n - 1; 0 of fewer than two values.
  double standard_deviation() const;
  /// Linear between the order statistics, at (i + 1/2)/n; p from 0 to 1. NaN without values.
  double quantile(double p) const;
  /// E|x - Y|.
  double mean_distance(double x) const;
  /// E|Y - Y'|.
  double own_distance() const { return own_; }

 private:
  std::vector<double> values_;
  std::vector<double> sums_;  ///< of the values before each one, and of all
  double own_ = 0;
};

double energy_distance(const SortedSample& a, const SortedSample& b);

/// A sample of places in the plane. Distances take a pass over it.
class PlaneSample {
 public:
  PlaneSample() = default;
  explicit PlaneSample(std::vector<Vec2> values);

  std::size_t size() const { return values_.size(); }
  const std::vector<Vec2>& values() const { return values_; }
  double mean_distance(const Vec2& x) const;
  double own_distance() const { return own_; }

 private:
  std::vector<Vec2> values_;
  double own_ = 0;
};

double energy_distance(const PlaneSample& a, const PlaneSample& b);

/// The mean distance between the quantiles of two samples at equal levels [m] (Wasserstein's distance of
/// order 1).
double quantile_distance(const SortedSample& a, const SortedSample& b);

}  // namespace flyrock
