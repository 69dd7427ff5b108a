#include "results/statistics/joint_survey.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "random/stream.h"
#include "results/statistics/share.h"

namespace flyrock {

namespace {

constexpr int bootstrap_draws = 400;  // of the bootstrap
constexpr int most_sets = 6;
constexpr double bootstrap_tail = 0.025;

double sine_to_line(const Vec3& pole, const Vec3& line) { return std::abs(pole.dot(line)); }

/// The value below which a share of sorted numbers lies.
double quantile_of_draws(std::vector<double>& numbers, double share) {
  std::sort(numbers.begin(), numbers.end());
  const double at = share * static_cast<double>(numbers.size() - 1);
  const auto low = static_cast<std::size_t>(at);
  const std::size_t high = std::min(low + 1, numbers.size() - 1);
  return numbers[low] + (at - static_cast<double>(low)) * (numbers[high] - numbers[low]);
}

Estimate estimate(double value, std::vector<double> again) {
  if (again.empty()) return {value, value, value};
  return {value, quantile_of_draws(again, bootstrap_tail), quantile_of_draws(again, 1 - bootstrap_tail)};
}

/// So many planes of equal weight say as much (Kish).
double effective_number(const std::vector<double>& weights) {
  double sum = 0, squares = 0;
  for (const double weight : weights) {
    sum += weight;
    squares += weight * weight;
  }
  return sum * sum / squares;
}

/// A share of n independent planes or pairs of planes. Where all agree, the draws of the bootstrap are alike
/// and know nothing of those that were not met: then the exact interval holds.
Estimate share_of_draws(double value, const std::vector<double>& again, double n) {
  if (value > 0 && value < 1) return estimate(value, again);
  const Interval exact = share_interval(value * n, n, 1 - 2 * bootstrap_tail);
  return {value, exact.lower, exact.upper};
}

/// How often each of n planes is drawn in draw `number` of the bootstrap.
std::vector<double> counts_of_draw(std::size_t n, std::uint64_t seed, int number) {
  RandomStream rng(seed, "joints.bootstrap", {.trial = static_cast<std::uint64_t>(number)});
  std::vector<double> counts(n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    ++counts[static_cast<std::size_t>(rng.integer(0, static_cast<std::int64_t>(n) - 1))];
  return counts;
}

/// The shares of planes and pairs that could let a face fail, for any weights of the planes.
class HazardShares {
 public:
  HazardShares(const SlopeFace& face, const std::vector<Vec3>& poles) {
    for (const Vec3& pole : poles) {
      planes_.push_back(slides_on(face, pole));
      topples_.push_back(topples_on(face, pole));
      std::vector<std::size_t>& with = wedges_.emplace_back();
      for (std::size_t j = 0; j + 1 < planes_.size(); ++j)
        if (slides_between(face, pole, poles[j])) with.push_back(j);
    }
  }

  /// plane, wedge, toppling
  std::array<double, 3> of(const std::vector<double>& weights) const {
    double all = 0, squares = 0, plane = 0, wedge = 0, toppling = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      all += weights[i];
      squares += weights[i] * weights[i];
      plane += weights[i] * planes_[i];
      toppling += weights[i] * topples_[i];
      double with = 0;
      for (const std::size_t j : wedges_[i]) with += weights[j];
      wedge += weights[i] * with;
    }
    const double pairs = 0.5 * (all * all - squares);
    return {plane / all, pairs > 0 ? wedge / pairs : 0, toppling / all};
  }

 private:
  std::vector<char> planes_, topples_;
  std::vector<std::vector<std::size_t>>
      wedges_;  ///< of each plane, the earlier ones that make a wedge with it
};

/// A length with its weight in a mean.
struct WeightedLength {
  double length = 0, weight = 1;
};

/// The distances between neighbours of a set along their scanlines, at right angles to its mean plane.
std::vector<WeightedLength> gaps_of(const std::vector<SurveyedPlane>& planes, const std::vector<Vec3>& lines,
                                    const std::vector<int>& set_of, int set, const Vec3& mean) {
  std::map<std::array<double, 3>, std::vector<double>> by_line;
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (set_of[i] == set && planes[i].position && !lines[i].isZero(0))
      by_line[{lines[i].x(), lines[i].y(), lines[i].z()}].push_back(*planes[i].position);
  std::vector<WeightedLength> gaps;
  for (auto& [line, places] : by_line) {
    std::sort(places.begin(), places.end());
    const double sine = sine_to_line(mean, Vec3(line[0], line[1], line[2]));
    for (std::size_t i = 1; i < places.size(); ++i) gaps.push_back({sine * (places[i] - places[i - 1])});
  }
  return gaps;
}

/// The lengths of the traces of a set.
std::vector<WeightedLength> traces_of(const std::vector<SurveyedPlane>& planes,
                                      const std::vector<Vec3>& lines, const std::vector<int>& set_of,
                                      int set) {
  std::vector<WeightedLength> traces;
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (set_of[i] == set && planes[i].trace)
      traces.push_back({*planes[i].trace, lines[i].isZero(0) ? 1 : 1 / *planes[i].trace});
  return traces;
}

/// The mean of at least two lengths.
std::optional<Estimate> mean_of_lengths(const std::vector<WeightedLength>& lengths, std::uint64_t seed,
                                        int set) {
  constexpr std::size_t least_lengths = 2;
  if (lengths.size() < least_lengths) return std::nullopt;
  const auto mean = [&](const std::vector<double>& counts) {
    double sum = 0, weights = 0;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      sum += counts[i] * lengths[i].weight * lengths[i].length;
      weights += counts[i] * lengths[i].weight;
    }
    return sum / weights;
  };
  std::vector<double> again;
  for (int draw = 0; draw < bootstrap_draws; ++draw)
    again.push_back(mean(counts_of_draw(lengths.size(), seed + 1 + static_cast<std::uint64_t>(set), draw)));
  return estimate(mean(std::vector<double>(lengths.size(), 1.0)), again);
}

/// What the bootstrap finds for one set.
struct Again {
  std::vector<double> angles, k, shares;
};

}  // namespace

JointSurvey survey_of(const std::vector<SurveyedPlane>& planes, const SurveyOptions& options) {
  JointSurvey survey;
  survey.planes = planes.size();
  std::vector<SurveyedPlane> used;
  std::vector<Vec3> lines;  // zero: none
  double sum = 0;
  for (const SurveyedPlane& plane : planes) {
    const Vec3 pole = pole_of(plane.dip, plane.direction);
    const Vec3 line = plane.scanline ? *plane.scanline : options.scanline.value_or(Vec3::Zero());
    double weight = plane.weight;
    if (!line.isZero(0)) {
      const double sine = sine_to_line(pole, line);
      if (sine < std::sin(options.blind)) {
        ++survey.blind;
        continue;
      }
      weight /= sine;
    }
    used.push_back(plane);
    lines.push_back(line);
    survey.poles.poles.push_back(pole);
    survey.poles.weights.push_back(weight);
    sum += weight;
  }
  constexpr std::size_t least = 3;
  if (used.size() < least) throw std::invalid_argument("fewer than 3 planes are left, expected more");
  for (double& weight : survey.poles.weights) weight *= static_cast<double>(used.size()) / sum;

  survey.mixture = options.sets > 0 ? fit_sets(survey.poles, options.sets, options.seed)
                                    : fit_sets_by_bic(survey.poles, most_sets, options.seed);
  survey.set_of = sets_of(survey.poles, survey.mixture);
  survey.to_halve = 4 * survey.planes;
  const std::size_t sets = survey.mixture.sets.size();
  std::optional<HazardShares> shares;
  if (options.face) shares.emplace(*options.face, survey.poles.poles);

  std::vector<Again> again(sets);
  std::vector<double> rest;
  std::array<std::vector<double>, 3> hazards;
  for (int draw = 0; draw < bootstrap_draws; ++draw) {
    Poles drawn = survey.poles;
    const std::vector<double> counts = counts_of_draw(used.size(), options.seed, draw);
    for (std::size_t i = 0; i < used.size(); ++i) drawn.weights[i] *= counts[i];
    const SetMixture fit = fit_sets_from(drawn, survey.mixture);
    for (std::size_t s = 0; s < sets; ++s) {
      const double cosine = std::abs(fit.sets[s].mean.dot(survey.mixture.sets[s].mean));
      again[s].angles.push_back(std::acos(std::min(1.0, cosine)));
      again[s].k.push_back(fit.sets[s].k);
      again[s].shares.push_back(fit.sets[s].share);
    }
    rest.push_back(fit.rest);
    if (!shares) continue;
    const std::array<double, 3> found = shares->of(drawn.weights);
    for (std::size_t h = 0; h < found.size(); ++h) hazards[h].push_back(found[h]);
  }
  for (std::size_t s = 0; s < sets; ++s) {
    SurveyedSet& set = survey.sets.emplace_back();
    set.fit = survey.mixture.sets[s];
    std::tie(set.dip, set.direction) = dip_of(set.fit.mean);
    set.cone = quantile_of_draws(again[s].angles, 1 - 2 * bootstrap_tail);
    set.k = estimate(set.fit.k, again[s].k);
    set.share = estimate(set.fit.share, again[s].shares);
    set.planes =
        static_cast<int>(std::count(survey.set_of.begin(), survey.set_of.end(), static_cast<int>(s)));
    const int number = static_cast<int>(s);
    set.spacing =
        mean_of_lengths(gaps_of(used, lines, survey.set_of, number, set.fit.mean), options.seed, number);
    set.trace = mean_of_lengths(traces_of(used, lines, survey.set_of, number), options.seed, number);
  }
  survey.rest = estimate(survey.mixture.rest, rest);
  if (shares) {
    const std::array<double, 3> found = shares->of(survey.poles.weights);
    const double independent = effective_number(survey.poles.weights);
    survey.hazards = KinematicShares{share_of_draws(found[0], hazards[0], independent),
                                     share_of_draws(found[1], hazards[1], independent / 2),
                                     share_of_draws(found[2], hazards[2], independent)};
  }
  return survey;
}

}  // namespace flyrock
