#include "results/statistics/energy_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flyrock {

SortedSample::SortedSample(std::vector<double> values) : values_(std::move(values)) {
  std::sort(values_.begin(), values_.end());
  sums_.reserve(values_.size() + 1);
  double sum = 0;
  for (const double value : values_) {
    sums_.push_back(sum);
    sum += value;
  }
  sums_.push_back(sum);
  // The value of rank i is the greater one of i pairs and the lesser one of n - 1 - i.
  const double n = static_cast<double>(values_.size());
  double pairs = 0;
  for (std::size_t i = 0; i < values_.size(); ++i) pairs += (2 * static_cast<double>(i) + 1 - n) * values_[i];
  own_ = values_.empty() ? 0 : 2 * pairs / (n * n);
}

double SortedSample::mean() const { return sums_.back() / static_cast<double>(values_.size()); }

double SortedSample::standard_deviation() const {
  if (values_.size() < 2) return 0;
  const double centre = mean();
  double squares = 0;
  for (const double value : values_) squares += (value - centre) * (value - centre);
  return std::sqrt(squares / static_cast<double>(values_.size() - 1));
}

double SortedSample::quantile(double p) const {
  if (values_.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double at =
      std::clamp(p * static_cast<double>(values_.size()) - 0.5, 0.0, static_cast<double>(values_.size() - 1));
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, values_.size() - 1);
  return values_[below] + (at - static_cast<double>(below)) * (values_[above] - values_[below]);
}

double SortedSample::mean_distance(double x) const {
  const auto below =
      static_cast<std::size_t>(std::lower_bound(values_.begin(), values_.end(), x) - values_.begin());
  const double n = static_cast<double>(values_.size()), k = static_cast<double>(below);
  const double left = k * x - sums_[below], right = sums_.back() - sums_[below] - (n - k) * x;
  return (left + right) / n;
}

namespace {

template <class Sample>
double distance_of(const Sample& a, const Sample& b) {
  double between = 0;
  for (const auto& value : a.values()) between += b.mean_distance(value);
  between /= static_cast<double>(a.size());
  return std::max(0.0, 2 * between - a.own_distance() - b.own_distance());
}

}  // namespace

double energy_distance(const SortedSample& a, const SortedSample& b) { return distance_of(a, b); }

PlaneSample::PlaneSample(std::vector<Vec2> values) : values_(std::move(values)) {
  double pairs = 0;
  for (std::size_t i = 0; i < values_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) pairs += (values_[i] - values_[j]).norm();
  const double n = static_cast<double>(values_.size());
  own_ = values_.empty() ? 0 : 2 * pairs / (n * n);
}

double PlaneSample::mean_distance(const Vec2& x) const {
  double sum = 0;
  for (const Vec2& value : values_) sum += (value - x).norm();
  return sum / static_cast<double>(values_.size());
}

double energy_distance(const PlaneSample& a, const PlaneSample& b) { return distance_of(a, b); }

double quantile_distance(const SortedSample& a, const SortedSample& b) {
  const SortedSample& fewer = a.size() < b.size() ? a : b;
  const SortedSample& more = a.size() < b.size() ? b : a;
  // Both quantile functions are steps; each value of the larger sample has an equal share of the levels.
  double sum = 0;
  const double n = static_cast<double>(more.size()), m = static_cast<double>(fewer.size());
  for (std::size_t i = 0; i < more.size(); ++i) {
    const auto rank = static_cast<std::size_t>((static_cast<double>(i) + 0.5) / n * m);
    sum += std::abs(more.values()[i] - fewer.values()[std::min(rank, fewer.size() - 1)]);
  }
  return sum / n;
}

}  // namespace flyrock
