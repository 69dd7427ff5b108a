#include "results/statistics/share.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>

#include "results/statistics/unknown.h"

namespace flyrock {

Interval share_interval(double k, double n, double confidence) {
  using Binomial = boost::math::binomial_distribution<>;
  if (!(n > 0)) return {unknown, unknown};
  const double tail = 0.5 * (1 - confidence);
  return {Binomial::find_lower_bound_on_p(n, k, tail), Binomial::find_upper_bound_on_p(n, k, tail)};
}

Share share_of(std::uint64_t k, std::uint64_t n, std::uint64_t open) {
  const double value = n > 0 ? static_cast<double>(k) / static_cast<double>(n) : unknown;
  const auto interval = [n](std::uint64_t count) {
    return share_interval(static_cast<double>(count), static_cast<double>(n), stated_confidence);
  };
  return {{value, open > 0}, {interval(k).lower, interval(k + open).upper}};
}

namespace {

/// By trial, without the rule of least_trials.
Interval clustered_interval(const TrialCounts& counts) {
  const double size = counts.effective_size(stated_confidence);
  return share_interval(counts.share() * size, size, stated_confidence);
}

}  // namespace

Share share_of(const TrialCounts& counts, const TrialCounts& or_open) {
  const std::uint64_t open = or_open.counted() - counts.counted();
  if (!counts.is_by_trial()) return share_of(counts.counted(), counts.rocks(), open);
  Share share{{counts.share(), open > 0}, {unknown, unknown}};
  share.interval.design_effect = counts.design_effect();
  if (counts.counted() == 0) {  // a rock does what no trial shows at most as often as a trial does
    const double n = counts.effective_trials();
    const double with = std::min(static_cast<double>(or_open.trials_with()), n);
    share.interval.lower = 0;
    share.interval.upper = share_interval(with, n, stated_confidence).upper;
    return share;
  }
  share.interval.trials_needed = trials_needed(counts.evidence_with(), counts.trials());
  if (share.interval.trials_needed > 0) return share;
  share.interval.lower = clustered_interval(counts).lower;
  share.interval.upper = clustered_interval(or_open).upper;
  return share;
}

void ShareTally::add(std::uint64_t trial, double weight) {
  if (trial != trial_) close();
  trial_ = trial;
  weight_ = weight;
  weights_.add(weight);
  in_trial_.add(weight);
}

void ShareTally::close() {
  if (in_trial_.count > 0) {
    rocks_ += in_trial_.count;
    for (Sums& share : shares_) {
      share.counts.add(in_trial_, share.counted);
      share.or_open.add(in_trial_, share.or_open_now);
      share.counted = share.or_open_now = {};
    }
    in_trial_ = {};
  }
  if (!weights_.differ()) return;
  for (Sums& share : shares_) {
    share.counts.weigh();
    share.or_open.weigh();
  }
}

Share ShareTally::per_trial(std::size_t share, std::uint64_t trials) const {
  const Sums& sums = shares_[share];
  const std::uint64_t with = sums.counts.trials_with();
  return share_of(with, trials, sums.or_open.trials_with() - with);
}

Complement complement_of(const Share& share) {
  Interval interval = share.interval;
  interval.lower = 1 - share.interval.upper;
  interval.upper = 1 - share.interval.lower;
  return {1 - share.value, share.censored, interval};
}

}  // namespace flyrock
