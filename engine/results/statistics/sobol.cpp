#include "results/statistics/sobol.h"

#include <algorithm>
#include <cmath>

#include "random/stream.h"

namespace flyrock {

namespace {

/// Sums over trials of which each counts so often.
struct BaseSums {
  double n = 0, sum_b = 0, sum = 0, squares = 0;  ///< `sum`, `squares`: of both bases

  double mean() const { return sum / (2 * n); }
  double variance() const { return squares / (2 * n) - mean() * mean(); }
};

struct InputSums {
  double product = 0, difference = 0, square = 0;

  /// With d = f_ABi - f_A: sum f_B d, sum d and sum d^2.
  void add(double count, double a, double b, double ab) {
    const double d = ab - a;
    product += count * b * d;
    difference += count * d;
    square += count * d * d;
  }
  double first(const BaseSums& bases) const {
    return (product - bases.mean() * difference) / bases.n / bases.variance();
  }
  double total(const BaseSums& bases) const { return square / (2 * bases.n) / bases.variance(); }
};

/// The runs without the trials that are left out, less the mean of both bases.
class Centred {
 public:
  Centred(const ExchangedRuns& runs, SobolIndices& found) {
    std::vector<std::size_t> kept;
    for (std::size_t t = 0; t < runs.a.size(); ++t) {
      const bool is_known =
          std::isfinite(runs.a[t]) && std::isfinite(runs.b[t]) &&
          std::all_of(runs.ab.begin(), runs.ab.end(), [&](const auto& run) { return std::isfinite(run[t]); });
      if (is_known) kept.push_back(t);
    }
    found.trials = kept.size();
    found.left_out = runs.a.size() - kept.size();
    double sum = 0;
    for (const std::size_t t : kept) sum += runs.a[t] + runs.b[t];
    found.mean = kept.empty() ? unknown : sum / (2 * static_cast<double>(kept.size()));
    const auto centred = [&](const std::vector<double>& run) {
      std::vector<double> values;
      for (const std::size_t t : kept) values.push_back(run[t] - found.mean);
      return values;
    };
    a_ = centred(runs.a);
    b_ = centred(runs.b);
    for (const std::vector<double>& run : runs.ab) ab_.push_back(centred(run));
  }

  std::size_t trials() const { return a_.size(); }
  std::size_t inputs() const { return ab_.size(); }

  /// `counts`: how often each trial counts.
  BaseSums bases(const std::vector<double>& counts) const {
    BaseSums sums;
    for (std::size_t t = 0; t < a_.size(); ++t) {
      sums.n += counts[t];
      sums.sum += counts[t] * (a_[t] + b_[t]);
      sums.squares += counts[t] * (a_[t] * a_[t] + b_[t] * b_[t]);
    }
    return sums;
  }
  InputSums input(std::size_t i, const std::vector<double>& counts) const {
    InputSums sums;
    for (std::size_t t = 0; t < a_.size(); ++t) sums.add(counts[t], a_[t], b_[t], ab_[i][t]);
    return sums;
  }

 private:
  std::vector<double> a_, b_;
  std::vector<std::vector<double>> ab_;
};

/// How often each trial is among n that are drawn from all with replacement.
void draw_counts(RandomStream& rng, std::vector<double>& counts) {
  std::fill(counts.begin(), counts.end(), 0.0);
  const auto last = static_cast<std::int64_t>(counts.size()) - 1;
  for (std::size_t left = counts.size(); left > 0; --left)
    counts[static_cast<std::size_t>(rng.integer(0, last))] += 1;
}

Interval middle_95(std::vector<double>& values) {
  if (values.empty()) return {unknown, unknown};
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto low = static_cast<std::size_t>(place), high = std::min(low + 1, values.size() - 1);
    return values[low] + (place - static_cast<double>(low)) * (values[high] - values[low]);
  };
  return {at(0.025), at(0.975)};
}

}  // namespace

SobolIndices sobol_indices(const ExchangedRuns& runs, std::uint64_t seed, int bootstraps) {
  SobolIndices found;
  found.inputs.resize(runs.ab.size());
  const Centred centred(runs, found);
  std::vector<double> counts(centred.trials(), 1.0);
  const BaseSums bases = centred.bases(counts);
  if (centred.trials() == 0 || found.is_lost()) return found;
  found.variance = bases.variance();
  // Rounding leaves about 1e-16 of the numbers in their differences.
  constexpr double rounding = 1e-13;
  const double least = rounding * std::abs(found.mean);
  if (!(found.variance > least * least)) return found;
  found.sum_first = found.sum_total = 0;
  for (std::size_t i = 0; i < centred.inputs(); ++i) {
    const InputSums sums = centred.input(i, counts);
    found.sum_first += found.inputs[i].first = sums.first(bases);
    found.sum_total += found.inputs[i].total = sums.total(bases);
  }
  if (centred.trials() < 2) return found;
  std::vector<std::vector<double>> first(centred.inputs()), total(centred.inputs());
  RandomStream rng(seed, "sobol.bootstrap", {});
  for (int k = 0; k < bootstraps; ++k) {
    draw_counts(rng, counts);
    const BaseSums drawn = centred.bases(counts);
    if (!(drawn.variance() > least * least)) continue;
    for (std::size_t i = 0; i < centred.inputs(); ++i) {
      const InputSums sums = centred.input(i, counts);
      first[i].push_back(sums.first(drawn));
      total[i].push_back(sums.total(drawn));
    }
  }
  for (std::size_t i = 0; i < centred.inputs(); ++i) {
    found.inputs[i].first_interval = middle_95(first[i]);
    found.inputs[i].total_interval = middle_95(total[i]);
  }
  return found;
}

}  // namespace flyrock
