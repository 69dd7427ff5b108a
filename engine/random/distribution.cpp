#include "random/distribution.h"

#include <algorithm>
#include <array>
#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <functional>

#include "random/sampling.h"

namespace flyrock {

namespace {

namespace policies = boost::math::policies;
using Policy =
    policies::policy<policies::promote_double<false>>;  // doubles are accurate enough and ten times faster
using Normal = boost::math::normal_distribution<double, Policy>;
using Beta = boost::math::beta_distribution<double, Policy>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double greatest_whole = 9007199254740992.0;  // 2^53: doubles hold every whole number up to it

/// The two ends of the support of the distribution, before truncation.
std::pair<double, double> support(const Distribution& f) {
  switch (f.kind) {
    case DistributionKind::uniform:
    case DistributionKind::integer:
      return {f.a, f.b};
    case DistributionKind::normal:
      return {-infinity, infinity};
    case DistributionKind::lognormal:
    case DistributionKind::weibull:
    case DistributionKind::exponential:
    case DistributionKind::rosin_rammler:
      return {0, infinity};
    case DistributionKind::power_law:
      return {f.a, f.b};
    case DistributionKind::sieve:
      return {f.values.front(), f.values.back()};
    case DistributionKind::triangular:
      return {f.a, f.c};
    case DistributionKind::beta:
      return {f.c, f.d};
    case DistributionKind::discrete:
      break;
  }
  double low = infinity, high = -infinity;
  for (std::size_t i = 0; i < f.values.size(); ++i) {
    if (!f.weights.empty() && f.weights[i] == 0) continue;
    if (f.values[i] < f.min || f.values[i] > f.max) continue;
    low = std::min(low, f.values[i]);
    high = std::max(high, f.values[i]);
  }
  return {low, high};
}

/// Both kinds are F(x) = 1 - exp(-rate (x/a)^b): a is where 1/e, or a half, lies beyond.
double weibull_rate(const Distribution& f) { return f.kind == DistributionKind::weibull ? 1 : std::log(2.0); }

/// The scale in which the share between two sieves is linear.
double sieve_scale(const Distribution& f, double x) {
  return f.between == CountedBy::count ? std::log(x) : -1 / (x * x * x);
}

double sieve_cumulative(const Distribution& f, double x) {
  const auto above =
      static_cast<std::size_t>(std::upper_bound(f.values.begin(), f.values.end(), x) - f.values.begin());
  const double from = sieve_scale(f, f.values[above - 1]), to = sieve_scale(f, f.values[above]);
  return f.weights[above - 1] +
         (f.weights[above] - f.weights[above - 1]) * (sieve_scale(f, x) - from) / (to - from);
}

double sieve_inverse(const Distribution& f, double p) {
  const auto above =
      static_cast<std::size_t>(std::upper_bound(f.weights.begin(), f.weights.end(), p) - f.weights.begin());
  const double part = (p - f.weights[above - 1]) / (f.weights[above] - f.weights[above - 1]);
  const double low = f.values[above - 1], high = f.values[above];
  if (f.between == CountedBy::count) return low * std::pow(high / low, part);
  const double ratio = low / high;
  return low / std::cbrt(1 - part * (1 - ratio * ratio * ratio));
}

/// F^-1(p) before truncation; continuous kinds only.
double inverse(const Distribution& f, double p) {
  if (p <= 0) return support(f).first;
  if (p >= 1) return support(f).second;
  switch (f.kind) {
    case DistributionKind::uniform:
      return f.a + p * (f.b - f.a);
    case DistributionKind::normal:
      return boost::math::quantile(Normal(f.a, f.b), p);
    case DistributionKind::lognormal:
      return f.a * std::exp(boost::math::quantile(Normal(0, f.b), p));
    case DistributionKind::triangular: {
      const double range = f.c - f.a;
      if (p < (f.b - f.a) / range) return f.a + std::sqrt(p * range * (f.b - f.a));
      return f.c - std::sqrt((1 - p) * range * (f.c - f.b));
    }
    case DistributionKind::weibull:
    case DistributionKind::rosin_rammler:
      return f.a * std::pow(-std::log1p(-p) / weibull_rate(f), 1 / f.b);
    case DistributionKind::beta:
      return f.c + (f.d - f.c) * boost::math::quantile(Beta(f.a, f.b), p);
    case DistributionKind::exponential:
      return -f.a * std::log1p(-p);
    case DistributionKind::power_law:
      return f.a * std::pow(1 + p * std::expm1(-f.c * std::log(f.b / f.a)), -1 / f.c);
    case DistributionKind::sieve:
      return sieve_inverse(f, p);
    case DistributionKind::discrete:
    case DistributionKind::integer:
      break;
  }
  return 0;
}

/// The value of a discrete distribution at u, among the values within the truncation.
double discrete_quantile(const Distribution& f, double u) {
  auto weight = [&](std::size_t i) {
    if (f.values[i] < f.min || f.values[i] > f.max) return 0.0;
    return f.weights.empty() ? 1.0 : f.weights[i];
  };
  double total = 0;
  for (std::size_t i = 0; i < f.values.size(); ++i) total += weight(i);
  double sum = 0;
  std::size_t last = 0;
  for (std::size_t i = 0; i < f.values.size(); ++i) {
    if (weight(i) == 0) continue;
    sum += weight(i);
    last = i;
    if (u * total < sum) break;
  }
  return f.values[last];
}

bool is_rising(const std::vector<double>& values) {
  return std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) == values.end();
}

std::string sieve_fault(const Distribution& f) {
  if (f.values.size() < 2 || f.values.size() != f.weights.size())
    return "it needs as many shares as sizes, at least two";
  if (!(f.values.front() > 0) || !std::isfinite(f.values.back()) || !is_rising(f.values))
    return "its sizes must be above 0 and rise";
  if (!is_rising(f.weights)) return "its shares must rise";
  if (f.weights.front() != 0) return "nothing must pass its first size: its first share must be 0";
  return f.weights.back() == 1 ? "" : "all must pass its last size: its last share must be 1 (100 %)";
}

std::string parameter_fault(const Distribution& f) {
  for (double parameter : {f.a, f.b, f.c, f.d})
    if (!std::isfinite(parameter)) return "its parameters must be finite";
  switch (f.kind) {
    case DistributionKind::uniform:
      return f.a < f.b ? "" : "its low end must be below its high end";
    case DistributionKind::normal:
      return f.b > 0 ? "" : "its sd must be above 0";
    case DistributionKind::lognormal:
      if (!(f.a > 0)) return "its median must be above 0";
      return f.b > 0 ? "" : "its log_sd must be above 0";
    case DistributionKind::triangular:
      return f.a <= f.b && f.b <= f.c && f.a < f.c ? "" : "it must be [low, mode, high] in rising order";
    case DistributionKind::weibull:
      return f.a > 0 && f.b > 0 ? "" : "its scale and shape must be above 0";
    case DistributionKind::beta:
      if (!(f.a > 0 && f.b > 0)) return "its alpha and beta must be above 0";
      return f.c < f.d ? "" : "its low must be below its high";
    case DistributionKind::exponential:
      return f.a > 0 ? "" : "its mean must be above 0";
    case DistributionKind::integer:
      if (f.a != std::floor(f.a) || f.b != std::floor(f.b)) return "its ends must be whole numbers";
      if (std::max(std::abs(f.a), std::abs(f.b)) > greatest_whole) return "its ends must be at most 2^53";
      return f.a <= f.b ? "" : "its low end must not be above its high end";
    case DistributionKind::rosin_rammler:
      return f.a > 0 && f.b > 0 ? "" : "its median and uniformity must be above 0";
    case DistributionKind::power_law:
      if (!(f.c > 0)) return "its exponent must be above 0";
      return f.a > 0 && f.a < f.b ? "" : "its low end must be above 0 and below its high end";
    case DistributionKind::sieve:
      return sieve_fault(f);
    case DistributionKind::discrete:
      break;
  }
  if (f.values.empty()) return "it needs at least one value";
  if (!f.weights.empty() && f.weights.size() != f.values.size()) return "it needs one weight for each value";
  double total = 0;
  for (double weight : f.weights) {
    if (!(weight >= 0) || !std::isfinite(weight)) return "its weights must be at least 0";
    total += weight;
  }
  return f.weights.empty() || total > 0 ? "" : "one of its weights must be above 0";
}

constexpr std::array<std::string_view, 12> kind_names{"uniform", "normal",        "lognormal",   "triangular",
                                                      "weibull", "beta",          "exponential", "discrete",
                                                      "integer", "rosin_rammler", "power_law",   "sieve"};
constexpr std::array<std::string_view, 5> scope_names{"run", "trial", "hole", "rock", "impact"};

}  // namespace

double Distribution::cumulative(double x) const {
  const auto [low, high] = support(*this);
  if (x <= low) return kind == DistributionKind::integer && x == low ? 1 / (b - a + 1) : 0;
  if (x >= high) return 1;
  switch (kind) {
    case DistributionKind::uniform:
      return (x - a) / (b - a);
    case DistributionKind::normal:
      return boost::math::cdf(Normal(a, b), x);
    case DistributionKind::lognormal:
      return boost::math::cdf(Normal(0, b), std::log(x / a));
    case DistributionKind::triangular:
      if (x < b) return (x - a) * (x - a) / ((c - a) * (b - a));
      return 1 - (c - x) * (c - x) / ((c - a) * (c - b));
    case DistributionKind::weibull:
    case DistributionKind::rosin_rammler:
      return -std::expm1(-weibull_rate(*this) * std::pow(x / a, b));
    case DistributionKind::beta:
      return boost::math::cdf(Beta(a, b), (x - c) / (d - c));
    case DistributionKind::exponential:
      return -std::expm1(-x / a);
    case DistributionKind::power_law:
      return std::expm1(-c * std::log(x / a)) / std::expm1(-c * std::log(b / a));
    case DistributionKind::sieve:
      return sieve_cumulative(*this, x);
    case DistributionKind::integer:
      return (std::floor(x) - a + 1) / (b - a + 1);
    case DistributionKind::discrete:
      break;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double Distribution::quantile(double u) const {
  if (kind == DistributionKind::discrete) return discrete_quantile(*this, u);
  if (min == -infinity && max == infinity && kind != DistributionKind::integer) {
    const auto [least, greatest] = support(*this);
    return std::clamp(inverse(*this, u), least, greatest);
  }
  const double low = lowest(), high = highest();
  if (kind == DistributionKind::integer) return std::min(low + std::floor(u * (high - low + 1)), high);
  const double from = cumulative(min), to = cumulative(max);
  // Clamp, because rounding in F and F^-1 must not move a draw past its truncation.
  return std::clamp(inverse(*this, from + u * (to - from)), low, high);
}

std::string Distribution::fault() const {
  if (std::string fault = parameter_fault(*this); !fault.empty()) return fault;
  if (!(min < max)) return "its min must be below its max";
  if (!(lowest() <= highest())) return "nothing of it lies between its min and its max";
  // Below this share, the difference of two cumulative values loses all its digits.
  if (is_continuous() && cumulative(max) - cumulative(min) < 1e-9)
    return "less than 1e-9 of it lies between its min and its max";
  return {};
}

double Distribution::lowest() const {
  const double low = std::max(support(*this).first, min);
  return kind == DistributionKind::integer ? std::ceil(low) : low;
}

double Distribution::highest() const {
  const double high = std::min(support(*this).second, max);
  return kind == DistributionKind::integer ? std::floor(high) : high;
}

double Distribution::likely_lowest() const {
  return std::isfinite(lowest()) ? lowest() : quantile(negligible);
}

double Distribution::likely_highest() const {
  return std::isfinite(highest()) ? highest() : quantile(1 - negligible);
}

double Distribution::share_below(double x) const {
  const double from = cumulative(min), to = cumulative(max);
  return std::clamp((cumulative(x) - from) / (to - from), 0.0, 1.0);
}

std::string_view name_of(DistributionKind kind) { return kind_names[static_cast<std::size_t>(kind)]; }
std::string_view name_of(Scope scope) { return scope_names[static_cast<std::size_t>(scope)]; }

double Draw::value(const Streams& streams, const DrawKey& key) const {
  if (dimension >= 0 && streams.sampling != Sampling::random)
    return quantile(sampled_at(streams, stream_hash, dimension, key.trial));
  DrawKey used;
  if (scope != Scope::run)
    used.trial = key.trial;
  else if (trials_of_run > 0)
    used.trial = key.trial / trials_of_run;  // the number of the run; those of run 0 are drawn as without
  if (scope == Scope::hole) used.hole = key.hole;
  if (scope == Scope::rock || scope == Scope::impact) used.rock = key.rock;
  if (scope == Scope::impact) used.impact = key.impact;
  return quantile(uniform_at(streams.seed_of(stream_hash), stream_hash, used));
}

}  // namespace flyrock
