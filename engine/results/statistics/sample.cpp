#include "results/statistics/sample.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "results/statistics/share.h"
#include "results/statistics/unknown.h"

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

void Sample::add(const Bounded& value, std::uint64_t trial, double weight) {
  if (stage_ == Stage::done) return;
  if (stage_ != Stage::first && !is_weighted_) weight = 1;
  if (stage_ == Stage::first || is_by_trial()) {
    if (in_trial_.count > 0 && trial != trial_) end_trial();
    trial_ = trial;
    in_trial_.add(weight);
  }
  switch (stage_) {
    case Stage::first:
      return add_first(value, weight);
    case Stage::quantiles:
      quantiles_.add(value.value, weight);
      if (!squared_) add_square(value, weight);
      return;
    case Stage::shares:
      for (Asked& asked : asked_)
        if (asked.upper_tail ? value.value < asked.quantile : value.value <= asked.quantile)
          asked.in_trial.add(weight);
      return;
    case Stage::ends:
      return ends_.add(value.value, weight);
    case Stage::done:
      return;
  }
}

void Sample::add_first(const Bounded& value, double weight) {
  const double x = value.value;
  ++count_;
  weights_.add(weight);
  weight_ += weight;
  sum_ += x;
  weighted_sum_ += weight * x;
  least_ = std::min(least_, x);
  greatest_ = std::max(greatest_, x);
  if (value.censored) least_censored_ = std::min(least_censored_, x);
}

void Sample::add_square(const Bounded& value, double weight) {
  const double deviation = value.value - (is_weighted_ ? weighted_sum_ : sum_) / total();
  squares_ += weight * (deviation * deviation);
  deviation_ += weight * deviation;
  if (!value.censored && value.value <= least_censored_) first_censored_ += weight;
}

void Sample::end_trial() {
  if (in_trial_.count == 0) return;
  if (stage_ == Stage::first) {
    ++trials_;
    is_clustered_ = is_clustered_ || in_trial_.count > 1;
    weight_squares_ += in_trial_.weight * in_trial_.weight;
  } else if (stage_ == Stage::quantiles) {
    trial_squares_ += deviation_ * deviation_;
  } else if (stage_ == Stage::shares) {
    for (Asked& asked : asked_) {
      asked.before.add(in_trial_, asked.in_trial);
      asked.in_trial = {};
    }
  }
  in_trial_ = {};
  deviation_ = 0;
}

bool Sample::needs_another_pass() {
  if (count_ == 0) return false;
  end_trial();
  switch (stage_) {
    case Stage::first: {
      is_weighted_ = weights_.differ();
      asked_.resize(questions_.intervals.size());
      if (!is_by_trial()) find_exact_ends();
      std::vector<double> ranks = quantile_ranks();
      if (!is_by_trial()) {
        const std::vector<double> more = end_ranks();
        ranks.insert(ranks.end(), more.begin(), more.end());
      }
      quantiles_ = Selection(std::move(ranks), count_, total(), least_, greatest_);
      stage_ = Stage::quantiles;
      break;
    }
    case Stage::quantiles:
      squared_ = true;
      quantiles_.end_pass();
      if (quantiles_.open()) break;
      stage_ = is_by_trial() && !asked_.empty() ? Stage::shares : Stage::done;
      if (stage_ == Stage::done) quantiles_.forget();
      for (std::size_t i = 0; i < asked_.size(); ++i)
        asked_[i].quantile = quantile(questions_.intervals[i].p).value;
      for (std::size_t i = 0; i < asked_.size(); ++i) asked_[i].upper_tail = questions_.intervals[i].p >= 0.5;
      break;
    case Stage::shares:
      find_clustered_ends();
      ends_ = quantiles_.search_again(end_ranks());
      stage_ = ends_.open() ? Stage::ends : Stage::done;
      break;
    case Stage::ends:
      ends_.end_pass();
      if (!ends_.open()) stage_ = Stage::done;
      break;
    case Stage::done:
      break;
  }
  return stage_ != Stage::done;
}

Sample::Rank Sample::rank_of(double p) const {
  if (is_weighted_) return {std::min(p * weight_, std::nextafter(weight_, 0.0)), 0};
  double h = static_cast<double>(count_ - 1) * p;
  // 0.95 of 100 must be 95, although 0.95 is not exact as a double.
  if (std::abs(h - std::round(h)) <= 4 * std::numeric_limits<double>::epsilon() * static_cast<double>(count_))
    h = std::round(h);
  return {std::floor(h), h - std::floor(h)};
}

std::vector<double> Sample::quantile_ranks() const {
  std::vector<double> ranks;
  const auto want = [&](double p) {
    const Rank rank = rank_of(p);
    ranks.push_back(rank.low);
    if (rank.share > 0) ranks.push_back(rank.low + 1);
  };
  for (const double p : questions_.quantiles) want(p);
  if (is_by_trial())
    for (const auto& asked : questions_.intervals) want(asked.p);
  return ranks;
}

std::vector<double> Sample::end_ranks() const {
  std::vector<double> ranks;
  for (const Asked& asked : asked_)
    for (const double end : {asked.lower, asked.upper})
      if (end >= 0 && end < total()) ranks.push_back(end);
  return ranks;
}

void Sample::find_exact_ends() {
  for (std::size_t i = 0; i < asked_.size(); ++i) {
    const auto [p, confidence] = questions_.intervals[i];
    const Ends ends = ends_of(p, confidence, count_);
    asked_[i].lower = static_cast<double>(ends.lower);
    asked_[i].upper = static_cast<double>(ends.upper);
  }
}

void Sample::find_clustered_ends() {
  for (std::size_t i = 0; i < asked_.size(); ++i) {
    const auto [p, confidence] = questions_.intervals[i];
    Asked& asked = asked_[i];
    if (is_weighted_) asked.before.weigh();
    asked.lower = -1;
    asked.upper = total();
    asked.design_effect = asked.before.design_effect();
    asked.trials_needed = trials_needed(
        asked.upper_tail ? asked.before.evidence_without() : asked.before.evidence_with(), trials_);
    if (asked.trials_needed > 0) continue;
    const double size = asked.before.effective_size(confidence);
    const Interval share = share_interval(p * size, size, confidence);
    if (is_weighted_) {
      if (share.lower > 0) asked.lower = weight_ * share.lower;
      asked.upper = weight_ * share.upper;
    } else {
      asked.lower = std::floor(total() * share.lower) - 1;
      asked.upper = std::ceil(total() * share.upper);
    }
  }
}

Moments Sample::moments() const {
  if (count_ == 0) return {unknown, unknown};
  const auto n = static_cast<double>(count_);
  if (is_weighted_) return {weighted_sum_ / weight_, std::sqrt(n / (n - 1) * squares_ / weight_)};
  return {sum_ / n, count_ > 1 ? std::sqrt(squares_ / (n - 1)) : unknown};
}

Bounded Sample::quantile(double p) const {
  if (count_ == 0) return {unknown, false};
  const auto [low, share] = rank_of(p);
  const double value = quantiles_.at(low);
  if (share == 0) return {value, first_censored_ <= low};
  return {value + share * (quantiles_.at(low + 1) - value), first_censored_ <= low + 1};
}

Interval Sample::quantile_interval(double p, double confidence) const {
  Interval interval{unknown, unknown};
  if (count_ == 0) return interval;
  const auto& questions = questions_.intervals;
  const auto question = std::find_if(questions.begin(), questions.end(), [&](const auto& each) {
    return each.p == p && each.confidence == confidence;
  });
  const Asked& asked = asked_.at(static_cast<std::size_t>(question - questions.begin()));
  const Selection& found = is_by_trial() ? ends_ : quantiles_;
  interval.design_effect = asked.design_effect;
  interval.trials_needed = asked.trials_needed;
  if (asked.lower >= 0) interval.lower = found.at(asked.lower);
  if (asked.upper < first_censored_) interval.upper = found.at(asked.upper);
  return interval;
}

Interval Sample::mean_interval(double confidence) const {
  if (count_ < 2 || any_censored()) return {unknown, unknown};
  const auto n = static_cast<double>(count_), m = static_cast<double>(trials_);
  const double effective_trials = is_weighted_ ? weight_ * weight_ / weight_squares_ : m;
  const auto [mean, sd] = moments();
  Interval interval{unknown, unknown};
  double error = sd / std::sqrt(n);
  if (is_by_trial()) {
    interval.trials_needed = trials_needed(effective_trials, trials_);
    if (interval.trials_needed > 0) return interval;
    const double clustered = std::sqrt(m / (m - 1) * trial_squares_) / total();
    interval.design_effect = error > 0 ? std::max(1.0, clustered * clustered / (error * error)) : 1;
    error = questions_.are_replicates ? clustered : std::max(error, clustered);
  }
  const boost::math::students_t_distribution<> student(effective_trials - 1);
  const double half = boost::math::quantile(boost::math::complement(student, 0.5 * (1 - confidence))) * error;
  interval.lower = mean - half;
  interval.upper = mean + half;
  return interval;
}

Sample sample_of(const std::vector<Bounded>& values, const Questions& questions) {
  Sample sample(questions);
  do {
    for (std::size_t i = 0; i < values.size(); ++i) sample.add(values[i], i);
  } while (sample.needs_another_pass());
  return sample;
}

}  // namespace flyrock
