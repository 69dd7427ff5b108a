#include "results/sample.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "results/unknown.h"

namespace flyrock {

namespace {

/// The greatest k in [0, n] with holds(k); -1 if there is none. holds(k) must be true up to some k and false
/// for all greater k. The search starts at `guess`, doubles its steps, then bisects.
template <class Holds>
std::int64_t last_that(std::int64_t n, double guess, Holds holds) {
  std::int64_t low = -1, high = n + 1;
  const std::int64_t first = std::clamp<std::int64_t>(std::llround(guess), 0, n);
  const bool up = holds(first);
  (up ? low : high) = first;
  for (std::int64_t step = 1; up ? first + step < high : first - step > low; step *= 2) {
    const std::int64_t k = up ? first + step : first - step;
    const bool holds_there = holds(k);
    (holds_there ? low : high) = k;
    if (holds_there != up) break;
  }
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

/// The position of a quantile: this share of the way from x_low to x_low+1.
struct Rank {
  std::uint64_t low;
  double share;
};

Rank rank_of(double p, std::uint64_t n) {
  double h = static_cast<double>(n - 1) * p;
  // 0.95 of 100 must be 95, although 0.95 is not exact as a double.
  if (std::abs(h - std::round(h)) <= 4 * std::numeric_limits<double>::epsilon() * static_cast<double>(n))
    h = std::round(h);
  return {static_cast<std::uint64_t>(h), h - std::floor(h)};
}

/// Ranks, from 0, of the ends of an interval. A rank below 0 or above the last one means that the sample is
/// too small.
struct Ends {
  std::int64_t lower, upper;
};

Ends ends_of(double p, double confidence, std::uint64_t count) {
  const auto n = static_cast<std::int64_t>(count);
  const double tail = 0.5 * (1 - confidence);
  const boost::math::binomial_distribution<> below(static_cast<double>(n), p);
  const auto at_most = [&](std::int64_t k) {
    return k < 0 ? 0 : boost::math::cdf(below, static_cast<double>(k));
  };
  const auto more_than = [&](std::int64_t k) {
    return k < 0 ? 1 : boost::math::cdf(boost::math::complement(below, static_cast<double>(k)));
  };
  const double mean = static_cast<double>(n) * p, about = 2 * std::sqrt(mean * (1 - p));
  const std::int64_t l = last_that(n, mean - about, [&](std::int64_t k) { return at_most(k - 1) <= tail; });
  const std::int64_t u =
      last_that(n, mean + about, [&](std::int64_t k) { return more_than(k - 1) > tail; }) + 1;
  return {l - 1, u - 1};
}

}  // namespace

void Sample::add(const Bounded& value) {
  const double x = value.value;
  if (pass_ == 0) {
    ++count_;
    sum_ += x;
    least_ = std::min(least_, x);
    greatest_ = std::max(greatest_, x);
    if (value.censored) least_censored_ = std::min(least_censored_, x);
    return;
  }
  selection_.add(x);
  if (pass_ > 1) return;
  const double departure = x - sum_ / static_cast<double>(count_);
  squares_ += departure * departure;
  first_censored_ += !value.censored && x <= least_censored_;
}

bool Sample::needs_another_pass() {
  if (count_ == 0) return false;
  if (pass_++ == 0) {
    selection_ = Selection(wanted_ranks(), count_, least_, greatest_);
    return true;
  }
  selection_.end_pass();
  return selection_.open();
}

std::vector<std::uint64_t> Sample::wanted_ranks() const {
  std::vector<std::uint64_t> ranks;
  for (const double p : questions_.quantiles) {
    const Rank rank = rank_of(p, count_);
    ranks.push_back(rank.low);
    if (rank.share > 0) ranks.push_back(rank.low + 1);
  }
  for (const auto& [p, confidence] : questions_.intervals) {
    const Ends ends = ends_of(p, confidence, count_);
    if (ends.lower >= 0) ranks.push_back(static_cast<std::uint64_t>(ends.lower));
    if (ends.upper < static_cast<std::int64_t>(count_))
      ranks.push_back(static_cast<std::uint64_t>(ends.upper));
  }
  return ranks;
}

Moments Sample::moments() const {
  if (count_ == 0) return {unknown, unknown};
  const auto n = static_cast<double>(count_);
  return {sum_ / n, count_ > 1 ? std::sqrt(squares_ / (n - 1)) : unknown};
}

Bounded Sample::quantile(double p) const {
  if (count_ == 0) return {unknown, false};
  const auto [low, share] = rank_of(p, count_);
  const double value = selection_.at(low);
  if (share == 0) return {value, first_censored_ <= low};
  return {value + share * (selection_.at(low + 1) - value), first_censored_ <= low + 1};
}

Interval Sample::quantile_interval(double p, double confidence) const {
  Interval interval{unknown, unknown};
  if (count_ == 0) return interval;
  const Ends ends = ends_of(p, confidence, count_);
  if (ends.lower >= 0) interval.lower = selection_.at(static_cast<std::uint64_t>(ends.lower));
  if (ends.upper < static_cast<std::int64_t>(first_censored_))
    interval.upper = selection_.at(static_cast<std::uint64_t>(ends.upper));
  return interval;
}

Interval Sample::mean_interval(double confidence) const {
  if (count_ < 2 || any_censored()) return {unknown, unknown};
  const auto n = static_cast<double>(count_);
  const auto [mean, sd] = moments();
  const boost::math::students_t_distribution<> student(n - 1);
  const double half =
      boost::math::quantile(boost::math::complement(student, 0.5 * (1 - confidence))) * sd / std::sqrt(n);
  return {mean - half, mean + half};
}

Sample sample_of(const std::vector<Bounded>& values, const Questions& questions) {
  Sample sample(questions);
  do {
    for (const Bounded& value : values) sample.add(value);
  } while (sample.needs_another_pass());
  return sample;
}

}  // namespace flyrock
