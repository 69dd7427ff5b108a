#include "results/statistics/joint_sets.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "random/stream.h"

namespace flyrock {

namespace {

constexpr double least_poles = 3;  // of a set
constexpr int em_starts = 6;
constexpr int most_em_steps = 200;
constexpr double em_still = 1e-7;  // change of the log likelihood a pole
constexpr double uniform_density = 1 / (4 * pi);

double density(const FisherSet& set, double cosine) {
  // k / (4 pi sinh k) cosh(k c), with exponentials that do not overflow
  const double c = std::abs(cosine);
  return set.k / (4 * pi) * std::exp(set.k * (c - 1)) * (1 + std::exp(-2 * set.k * c)) /
         -std::expm1(-2 * set.k);
}

/// The k of a mean resultant length: coth k - 1/k = length.
double concentration(double length) {
  double k = length * (3 - length * length) / (1 - length * length);  // Banerjee et al. 2005, for a start
  for (int step = 0; step < 20; ++step) {
    const double coth = 1 / std::tanh(k);
    const double f = coth - 1 / k - length, slope = 1 - coth * coth + 1 / (k * k);
    const double next = k - f / slope;
    if (!(next > 0)) break;
    if (std::abs(next - k) <= 1e-12 * k) return next;
    k = next;
  }
  return k;
}

/// One step of EM. Returns the log likelihood of the mixture before it.
double step(const Poles& poles, SetMixture& mixture) {
  const std::size_t count = mixture.sets.size();
  std::vector<Vec3> resultants(count, Vec3::Zero());
  std::vector<double> weights(count, 0.0), terms(count);
  double rest = 0, all = 0, log_likelihood = 0;
  for (std::size_t i = 0; i < poles.poles.size(); ++i) {
    const Vec3& pole = poles.poles[i];
    const double of_rest = mixture.rest * uniform_density;
    double sum = of_rest;
    for (std::size_t s = 0; s < count; ++s)
      sum += terms[s] = mixture.sets[s].share * density(mixture.sets[s], mixture.sets[s].mean.dot(pole));
    const double weight = poles.weights[i];
    log_likelihood += weight * std::log(sum);
    all += weight;
    rest += weight * of_rest / sum;
    for (std::size_t s = 0; s < count; ++s) {
      const double own = weight * terms[s] / sum;
      weights[s] += own;
      resultants[s] += own * std::tanh(mixture.sets[s].k * mixture.sets[s].mean.dot(pole)) * pole;
    }
  }
  mixture.rest = rest / all;
  for (std::size_t s = 0; s < count; ++s) {
    FisherSet& set = mixture.sets[s];
    set.share = weights[s] / all;
    const double length = resultants[s].norm();
    if (!(length > 0)) continue;
    set.mean = resultants[s] / length;
    if (set.mean.z() < 0) set.mean = -set.mean;
    set.k = std::clamp(concentration(std::min(length / weights[s], 1 - 1e-9)), least_fisher_k, most_fisher_k);
  }
  return log_likelihood;
}

double sum_of(const std::vector<double>& numbers) {
  double sum = 0;
  for (const double number : numbers) sum += number;
  return sum;
}

SetMixture climb(const Poles& poles, SetMixture mixture, int steps) {
  double last = -infinite;
  const double all = sum_of(poles.weights);
  for (int n = 0; n < steps; ++n) {
    mixture.log_likelihood = step(poles, mixture);
    if (mixture.log_likelihood - last < em_still * all) break;
    last = mixture.log_likelihood;
  }
  const double parameters = 4.0 * static_cast<double>(mixture.sets.size());
  mixture.bic = parameters * std::log(static_cast<double>(poles.poles.size())) - 2 * mixture.log_likelihood;
  return mixture;
}

/// Means at poles that are far from each other: each next one with a probability in proportion to its squared
/// sine to the nearest mean so far (k-means++).
SetMixture random_start(const Poles& poles, int sets, RandomStream& rng) {
  std::vector<double> far(poles.poles.size(), 1.0);
  SetMixture mixture;
  mixture.rest = 0.1;
  for (int s = 0; s < sets; ++s) {
    double left = rng.uniform() * sum_of(far);
    std::size_t chosen = 0;
    while (chosen + 1 < far.size() && (left -= far[chosen]) > 0) ++chosen;
    const Vec3 mean = poles.poles[chosen].z() < 0 ? Vec3(-poles.poles[chosen]) : poles.poles[chosen];
    mixture.sets.push_back({mean, 20, 0.9 / sets});
    for (std::size_t i = 0; i < far.size(); ++i)
      far[i] = std::min(far[i], std::max(0.0, 1 - std::pow(mean.dot(poles.poles[i]), 2)));
  }
  return mixture;
}

bool is_sound(const Poles& poles, const SetMixture& mixture) {
  return std::all_of(mixture.sets.begin(), mixture.sets.end(), [&](const FisherSet& set) {
    return set.share * static_cast<double>(poles.poles.size()) >= least_poles;
  });
}

}  // namespace

SetMixture fit_sets(const Poles& poles, int sets, std::uint64_t seed) {
  constexpr int first_steps = 25;
  std::optional<SetMixture> best;
  for (int start = 0; start < em_starts; ++start) {
    RandomStream rng(seed, "joints.start",
                     {.trial = static_cast<std::uint64_t>(start), .rock = static_cast<std::uint64_t>(sets)});
    const SetMixture found = climb(poles, random_start(poles, sets, rng), first_steps);
    if (!best || std::pair(is_sound(poles, found), found.log_likelihood) >
                     std::pair(is_sound(poles, *best), best->log_likelihood))
      best = found;
  }
  SetMixture mixture = climb(poles, *best, most_em_steps);
  std::stable_sort(mixture.sets.begin(), mixture.sets.end(),
                   [](const FisherSet& a, const FisherSet& b) { return a.share > b.share; });
  return mixture;
}

SetMixture fit_sets_by_bic(const Poles& poles, int most, std::uint64_t seed) {
  SetMixture best = fit_sets(poles, 1, seed);
  for (int sets = 2; sets <= most && static_cast<double>(poles.poles.size()) >= least_poles * sets; ++sets) {
    SetMixture found = fit_sets(poles, sets, seed);
    if (is_sound(poles, found) && found.bic < best.bic) best = std::move(found);
  }
  return best;
}

SetMixture fit_sets_from(const Poles& poles, SetMixture start) {
  constexpr int steps = 40;
  return climb(poles, std::move(start), steps);
}

std::vector<int> sets_of(const Poles& poles, const SetMixture& mixture) {
  std::vector<int> list;
  for (const Vec3& pole : poles.poles) {
    double most = mixture.rest * uniform_density;
    int best = -1;
    for (std::size_t s = 0; s < mixture.sets.size(); ++s) {
      const FisherSet& set = mixture.sets[s];
      const double own = set.share * density(set, set.mean.dot(pole));
      if (own > most) {
        most = own;
        best = static_cast<int>(s);
      }
    }
    list.push_back(best);
  }
  return list;
}

}  // namespace flyrock
