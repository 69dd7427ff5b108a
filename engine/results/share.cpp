#include "results/share.h"

#include <boost/math/distributions/binomial.hpp>

#include "results/unknown.h"

namespace flyrock {

Interval share_interval(std::uint64_t k, std::uint64_t n, double confidence) {
  using Binomial = boost::math::binomial_distribution<>;
  if (n == 0) return {unknown, unknown};
  const double trials = static_cast<double>(n), successes = static_cast<double>(k),
               tail = 0.5 * (1 - confidence);
  return {Binomial::find_lower_bound_on_p(trials, successes, tail),
          Binomial::find_upper_bound_on_p(trials, successes, tail)};
}

Share share_of(std::uint64_t k, std::uint64_t n, std::uint64_t open) {
  const double value = n > 0 ? static_cast<double>(k) / static_cast<double>(n) : unknown;
  return {
      {value, open > 0},
      {share_interval(k, n, stated_confidence).lower, share_interval(k + open, n, stated_confidence).upper}};
}

Complement complement_of(const Share& share) {
  return {1 - share.value, share.censored, {1 - share.interval.upper, 1 - share.interval.lower}};
}

}  // namespace flyrock
