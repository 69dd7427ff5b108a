#include "results/design_effect.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>

namespace flyrock {

void TrialCounts::add(std::uint64_t n, std::uint64_t k) {
  if (n == 0) return;
  n_ += n;
  k_ += k;
  ++trials_;
  with_ += k > 0;
  without_ += k < n;
  nn_ += n * n;
  kn_ += k * n;
  kk_ += k * k;
}

double TrialCounts::design_effect() const {
  if (!is_clustered()) return 1;
  const auto n = static_cast<double>(n_), m = static_cast<double>(trials_);
  if (std::min(with_, without_) < least_trials) return n / m;
  const double p = share();
  const double squares =
      static_cast<double>(kk_) - 2 * p * static_cast<double>(kn_) + p * p * static_cast<double>(nn_);
  return std::max(1.0, m / (m - 1) * squares / (n * p * (1 - p)));
}

double TrialCounts::effective_size(double confidence) const {
  const auto t = [&](std::uint64_t count) {
    const boost::math::students_t_distribution<> student(static_cast<double>(count - 1));
    return boost::math::quantile(boost::math::complement(student, 0.5 * (1 - confidence)));
  };
  // With fewer trials that say something, the design effect is that of whole trials.
  const std::uint64_t informative = std::min(with_, without_);
  const std::uint64_t d = informative < least_trials ? trials_ : informative;
  if (d < 2) return 0;
  const double ratio = t(n_) / t(d);
  return static_cast<double>(n_) / design_effect() * ratio * ratio;
}

std::uint64_t trials_needed(std::uint64_t with, std::uint64_t trials) {
  if (with >= least_trials) return 0;
  const std::uint64_t have = std::max<std::uint64_t>(with, 1);
  return (least_trials * trials + have - 1) / have;
}

}  // namespace flyrock
