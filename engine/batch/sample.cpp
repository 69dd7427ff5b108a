#include "batch/sample.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

namespace flyrock {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The greatest k in [0, n] with holds(k), which holds up to some k >= 0 and for none beyond; -1 where it never holds.
template <class Holds>
std::int64_t last_that(std::int64_t n, Holds holds) {
  std::int64_t low = -1, high = n + 1;
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

Moments moments_of(const std::vector<Bounded>& values) {
  if (values.empty()) return {unknown, unknown};
  const auto n = static_cast<double>(values.size());
  double sum = 0, squares = 0;
  for (const Bounded& v : values) sum += v.value;
  const double mean = sum / n;
  for (const Bounded& v : values) squares += (v.value - mean) * (v.value - mean);
  return {mean, values.size() > 1 ? std::sqrt(squares / (n - 1)) : unknown};
}

Sample::Sample(std::vector<Bounded> values) : sorted_(std::move(values)) {
  std::sort(sorted_.begin(), sorted_.end(), [](const Bounded& a, const Bounded& b) {
    return a.value != b.value ? a.value < b.value : a.censored < b.censored;
  });
  const auto first = std::find_if(sorted_.begin(), sorted_.end(), [](const Bounded& v) { return v.censored; });
  first_censored_ = static_cast<std::size_t>(first - sorted_.begin());
}

Bounded Sample::between(std::size_t low, double share) const {
  const std::size_t high = share > 0 ? low + 1 : low;
  const double value = sorted_[low].value + share * (sorted_[high].value - sorted_[low].value);
  return {value, first_censored_ <= high};
}

Bounded Sample::percentile(std::size_t percent) const {
  if (sorted_.empty()) return {unknown, false};
  const std::size_t hundredths = (sorted_.size() - 1) * percent;
  return between(hundredths / 100, static_cast<double>(hundredths % 100) / 100);
}

Bounded Sample::quantile(double p) const {
  if (sorted_.empty()) return {unknown, false};
  const double h = static_cast<double>(sorted_.size() - 1) * p;
  const double low = std::min(std::floor(h), static_cast<double>(sorted_.size() - 1));
  const bool at_end = low + 1 >= static_cast<double>(sorted_.size());
  return between(static_cast<std::size_t>(low), at_end ? 0 : h - low);
}

Interval Sample::quantile_interval(double p, double confidence) const {
  Interval interval{unknown, unknown};
  if (sorted_.empty()) return interval;
  const auto n = static_cast<std::int64_t>(sorted_.size());
  const double tail = 0.5 * (1 - confidence);
  const boost::math::binomial_distribution<> below(static_cast<double>(n), p);
  const auto at_most = [&](std::int64_t k) { return k < 0 ? 0 : boost::math::cdf(below, static_cast<double>(k)); };
  const auto more_than = [&](std::int64_t k) {
    return k < 0 ? 1 : boost::math::cdf(boost::math::complement(below, static_cast<double>(k)));
  };
  const std::int64_t l = last_that(n, [&](std::int64_t k) { return at_most(k - 1) <= tail; });
  const std::int64_t u = last_that(n, [&](std::int64_t k) { return more_than(k - 1) > tail; }) + 1;
  if (l >= 1) interval.lower = sorted_[static_cast<std::size_t>(l - 1)].value;
  if (u <= n && static_cast<std::size_t>(u - 1) < first_censored_)
    interval.upper = sorted_[static_cast<std::size_t>(u - 1)].value;
  return interval;
}

Interval Sample::mean_interval(double confidence) const {
  if (sorted_.size() < 2 || any_censored()) return {unknown, unknown};
  const auto n = static_cast<double>(sorted_.size());
  const Moments moments = moments_of(sorted_);
  const boost::math::students_t_distribution<> student(n - 1);
  const double half = boost::math::quantile(boost::math::complement(student, 0.5 * (1 - confidence))) *
                      moments.sd / std::sqrt(n);
  return {moments.mean - half, moments.mean + half};
}

}  // namespace flyrock
