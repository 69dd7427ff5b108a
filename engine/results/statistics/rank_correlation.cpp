#include "results/statistics/rank_correlation.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numeric>

#include "results/statistics/unknown.h"

namespace flyrock {

namespace {

/// A column in the order of its values: equal values are a group.
class Ranking {
 public:
  Ranking(const std::vector<double>& values, const std::vector<double>& weights)
      : weights_(weights), order_(values.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t i, std::size_t j) { return values[i] < values[j]; });
    for (std::size_t k = 0; k < order_.size(); ++k)
      if (k == 0 || values[order_[k]] != values[order_[k - 1]]) starts_.push_back(k);
    starts_.push_back(order_.size());
  }

  /// From -1/2 to 1/2: the share of the weight that lies below, and half of that of equals, less 1/2.
  std::vector<double> ranks() const {
    const double all = std::accumulate(weights_.begin(), weights_.end(), 0.0);
    std::vector<double> ranks(order_.size());
    double below = 0;
    for_each_group([&](auto begin, auto end) {
      double of_group = 0;
      for (auto i = begin; i != end; ++i) of_group += weights_[*i];
      for (auto i = begin; i != end; ++i) ranks[*i] = (below + 0.5 * of_group) / all - 0.5;
      below += of_group;
    });
    return ranks;
  }

  /// For each value the weighted sum of `of` over greater ones, and half of it over equals, by the sum of all
  /// weights.
  std::vector<double> sums_above(const std::vector<double>& of) const {
    const double all = std::accumulate(weights_.begin(), weights_.end(), 0.0);
    double above = 0;
    for (std::size_t i = 0; i < of.size(); ++i) above += weights_[i] * of[i];
    std::vector<double> sums(order_.size());
    for_each_group([&](auto begin, auto end) {
      double of_group = 0;
      for (auto i = begin; i != end; ++i) of_group += weights_[*i] * of[*i];
      for (auto i = begin; i != end; ++i) sums[*i] = (above - 0.5 * of_group) / all;
      above -= of_group;
    });
    return sums;
  }

 private:
  template <class See>
  void for_each_group(See see) const {
    for (std::size_t g = 0; g + 1 < starts_.size(); ++g)
      see(order_.begin() + static_cast<std::ptrdiff_t>(starts_[g]),
          order_.begin() + static_cast<std::ptrdiff_t>(starts_[g + 1]));
  }

  const std::vector<double>& weights_;
  std::vector<std::size_t> order_, starts_;
};

double weighted_dot(const std::vector<double>& w, const std::vector<double>& a,
                    const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < w.size(); ++i) sum += w[i] * a[i] * b[i];
  return sum;
}

/// The influences e of the pairs, with the weighted mean 0.
std::vector<double> influences(const Ranking& a, const Ranking& b, const std::vector<double>& f,
                               const std::vector<double>& g, const std::vector<double>& weights) {
  std::vector<double> e = a.sums_above(g);
  const std::vector<double> of_b = b.sums_above(f);
  for (std::size_t i = 0; i < e.size(); ++i) e[i] += f[i] * g[i] + of_b[i];
  const std::vector<double> ones(e.size(), 1.0);
  const double mean = weighted_dot(weights, e, ones) / weighted_dot(weights, ones, ones);
  for (double& value : e) value -= mean;
  return e;
}

/// Sets trials, is_by_trial and effective_size.
void count_trials(const std::vector<double>& e, const PairUnits& units, RankCorrelation& found) {
  double all = 0, squares = 0, of_trials = 0, in_trial = 0;
  for (std::size_t i = 0; i < e.size(); ++i) {
    const bool is_new = i == 0 || units.trial[i] != units.trial[i - 1];
    if (is_new) {
      of_trials += in_trial * in_trial;
      in_trial = 0;
      ++found.trials;
    }
    all += units.weight[i];
    squares += units.weight[i] * e[i] * e[i];
    in_trial += units.weight[i] * e[i];
  }
  of_trials += in_trial * in_trial;
  found.is_by_trial = found.trials < e.size();
  const auto pairs = static_cast<double>(e.size());
  found.effective_size = of_trials > 0 ? std::min(pairs, all * squares / of_trials) : pairs;
}

double deviate(const RankCorrelation& of, double confidence) {
  const double p = 0.5 * (1 + confidence);
  if (!of.is_by_trial) return boost::math::quantile(boost::math::normal(), p);
  return boost::math::quantile(boost::math::students_t(static_cast<double>(of.trials - 1)), p);
}

}  // namespace

Interval RankCorrelation::interval(double confidence) const {
  if (std::isnan(r) || trials < least_pairs || !(effective_size > 3)) return {unknown, unknown};
  const double half = deviate(*this, confidence) * std::sqrt((1 + 0.5 * r * r) / (effective_size - 3));
  return {std::tanh(std::atanh(r) - half), std::tanh(std::atanh(r) + half)};
}

RankCorrelation rank_correlation(const std::vector<double>& a, const std::vector<double>& b,
                                 const PairUnits& units) {
  const Ranking of_a(a, units.weight), of_b(b, units.weight);
  const std::vector<double> f = of_a.ranks(), g = of_b.ranks();
  const double scale = std::sqrt(weighted_dot(units.weight, f, f) * weighted_dot(units.weight, g, g));
  RankCorrelation found;
  if (!(scale > 0)) {
    found.r = unknown;
    return found;
  }
  found.r = std::clamp(weighted_dot(units.weight, f, g) / scale, -1.0, 1.0);
  count_trials(influences(of_a, of_b, f, g, units.weight), units, found);
  return found;
}

}  // namespace flyrock
