#include "results/statistics/design_effect.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace flyrock {

void TrialCounts::Sums::add(double n_t, double k_t) {
  n += n_t;
  k += k_t;
  nn += n_t * n_t;
  kn += k_t * n_t;
  kk += k_t * k_t;
}

void TrialCounts::add(const Weighed& n, const Weighed& k) {
  if (n.count == 0) return;
  n_ += n.count;
  k_ += k.count;
  ++trials_;
  with_ += k.count > 0;
  without_ += k.count < n.count;
  counts_.add(static_cast<double>(n.count), static_cast<double>(k.count));
  weights_.add(n.weight, k.weight);
}

double TrialCounts::evidence_with() const {
  const auto with = static_cast<double>(with_);
  const auto& [n, k, nn, kn, kk] = weights_;
  return is_weighted_ && kk > 0 ? std::min(with, k * k / kk) : with;
}

double TrialCounts::evidence_without() const {
  const auto without = static_cast<double>(without_);
  const auto& [n, k, nn, kn, kk] = weights_;
  const double squares = nn - 2 * kn + kk;
  return is_weighted_ && squares > 0 ? std::min(without, (n - k) * (n - k) / squares) : without;
}

double TrialCounts::effective_trials() const {
  return is_weighted_ ? weights_.n * weights_.n / weights_.nn : static_cast<double>(trials_);
}

double TrialCounts::design_effect() const {
  if (!is_by_trial()) return 1;
  const auto rocks = static_cast<double>(n_), m = static_cast<double>(trials_);
  if (std::min(evidence_with(), evidence_without()) < least_trials) return rocks / effective_trials();
  const auto& [n, k, nn, kn, kk] = sums();
  const double p = share();
  const double squares = kk - 2 * p * kn + p * p * nn;
  // The variance over p (1 - p) / rocks; without weights n is the number of rocks.
  return std::max(1.0, m / (m - 1) * squares / (n * p * (1 - p)) * (rocks / n));
}

double TrialCounts::effective_size(double confidence) const {
  const auto t = [&](double count) {
    const boost::math::students_t_distribution<> student(count - 1);
    return boost::math::quantile(boost::math::complement(student, 0.5 * (1 - confidence)));
  };
  // With fewer trials that say something, the design effect is that of whole trials.
  const double informative = std::min(evidence_with(), evidence_without());
  const double d = informative < least_trials ? effective_trials() : informative;
  if (d < 2) return 0;
  const double ratio = t(static_cast<double>(n_)) / t(d);
  return static_cast<double>(n_) / design_effect() * ratio * ratio;
}

std::uint64_t trials_needed(double with, std::uint64_t trials) {
  if (with >= least_trials) return 0;
  return static_cast<std::uint64_t>(
      std::ceil(static_cast<double>(least_trials * trials) / std::max(with, 1.0)));
}

}  // namespace flyrock
