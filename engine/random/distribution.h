#pragma once
// The distributions that a scenario may use instead of a number.

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "random/stream.h"

namespace flyrock {

enum class DistributionKind {
  uniform,        ///< a = low, b = high
  normal,         ///< a = mean, b = standard deviation
  lognormal,      ///< a = median, b = standard deviation of the logarithm
  triangular,     ///< a = low, b = mode, c = high
  weibull,        ///< a = scale, b = shape
  beta,           ///< a = alpha, b = beta, on [c, d]
  exponential,    ///< a = mean
  discrete,       ///< one of `values`, with `weights`
  integer,        ///< a whole number from a to b, both included
  rosin_rammler,  ///< a = median, b = uniformity n: F(x) = 1 - 2^-(x/a)^b
  power_law,      ///< from a = low to b = high, more than x are as x^-c
  sieve           ///< `values` are sizes in rising order, `weights` the shares below them, from 0 to 1
};

/// What is counted: pieces, or their mass, which is as the cube of their size.
enum class CountedBy { count, mass };

/// A distribution, truncated to [min, max]. It is sampled by the inverse of its cumulative distribution, so
/// that one uniform number u gives one draw and the truncation is exact:
///   x = F^-1(F(min) + u (F(max) - F(min))).
struct Distribution {
  DistributionKind kind = DistributionKind::uniform;
  double a = 0, b = 0, c = 0, d = 0;
  std::vector<double> values = {};
  std::vector<double> weights = {};  ///< of `discrete`: empty for equal ones
  /// With `sieve`, the share between two sizes is linear in ln x (count), or in x^-3 (mass), which is how
  /// many pieces there are if their mass is linear in ln x.
  CountedBy between = CountedBy::count;
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();

  /// The value at probability u in (0, 1).
  double quantile(double u) const;
  /// The cumulative distribution at x, before truncation. Not defined for `discrete`.
  double cumulative(double x) const;
  /// What is wrong with the parameters, or an empty text.
  std::string fault() const;
  /// The smallest and the greatest value that can be drawn; may be infinite.
  double lowest() const;
  double highest() const;
  /// The same. Where it has no end, the value beyond which a tail weighs only `negligible`.
  double likely_lowest() const;
  double likely_highest() const;
  /// The share of what is drawn that lies below x. Not defined for `discrete`.
  double share_below(double x) const;

  bool is_continuous() const {
    return kind != DistributionKind::discrete && kind != DistributionKind::integer;
  }
  /// A tail of this weight is never asked for a bound: a run of 10^9 trials draws about one value from it.
  static constexpr double negligible = 1e-9;
};

std::string_view name_of(DistributionKind kind);

/// How often a distribution is drawn anew.
enum class Scope { run, trial, hole, rock, impact };

std::string_view name_of(Scope scope);

/// One distribution of a scenario. `stream` is its path with the names of list elements instead of their
/// indices.
struct Draw {
  std::string path;
  std::string stream;
  Distribution distribution;
  Scope scope = Scope::trial;
  std::uint64_t stream_hash = 0;
  double factor = 1;  ///< above 0, multiplies each value drawn
  std::string unit;   ///< SI, of the values: "m", "rad", "1"
  int group = -1;     ///< the group of rocks (or body) that it belongs to; -1: it belongs to the scenario
  std::uint64_t trials_of_run = 0;  ///< where a scenario makes several runs (`outer`); 0: all trials are one
  int dimension = -1;  ///< of a sampling that is not random (random/sampling.h); -1: drawn at random

  /// The value at probability u in (0, 1), and the smallest and the greatest value.
  double quantile(double u) const { return factor * distribution.quantile(u); }
  double lowest() const { return factor * distribution.lowest(); }
  double highest() const { return factor * distribution.highest(); }
  double likely_lowest() const { return factor * distribution.likely_lowest(); }
  double likely_highest() const { return factor * distribution.likely_highest(); }
  /// The value at `key`. Only the parts of the key that `scope` depends on are used.
  double value(const Streams& streams, const DrawKey& key) const;
};

/// A decoded number: a constant, or the index of a Draw in the scenario's list.
struct Number {
  double constant = 0;
  int draw = -1;

  bool is_constant() const { return draw < 0; }
  double value(const std::vector<Draw>& draws, const Streams& streams, const DrawKey& key) const {
    return draw < 0 ? constant : draws[draw].value(streams, key);
  }
};

}  // namespace flyrock
