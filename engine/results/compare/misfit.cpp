#include "results/compare/misfit.h"

#include <algorithm>
#include <type_traits>

namespace flyrock {

namespace {

/// Distances in the plane take the time of pairs: of more places every k-th counts.
constexpr std::size_t most_places = 4000;

std::vector<double> numbers_of(const std::vector<Vec2>& values) {
  std::vector<double> numbers;
  for (const Vec2& value : values) numbers.push_back(value.x());
  return numbers;
}

std::vector<Vec2> thinned(const std::vector<Vec2>& values) {
  const std::size_t step = (values.size() + most_places - 1) / most_places;
  std::vector<Vec2> list;
  for (std::size_t i = 0; i < values.size(); i += step) list.push_back(values[i]);
  return list;
}

}  // namespace

MisfitPool::MisfitPool(std::vector<const SimulatedRow*> rows, bool in_plane, Censored censored)
    : in_plane_(in_plane) {
  std::vector<Vec2> all;
  for (const SimulatedRow* row : rows) {
    std::vector<Vec2> values;
    for (const SimulatedValue& value : row->values)
      if (!value.censored || censored == Censored::at_their_end) values.push_back(value.value);
    all.insert(all.end(), values.begin(), values.end());
    if (!values.empty()) values_.push_back(std::move(values));
  }
  if (in_plane_)
    plane_ = PlaneSample(thinned(all));
  else
    line_ = SortedSample(numbers_of(all));
}

double MisfitPool::energy_of(const std::vector<Vec2>& observed) const {
  return in_plane_ ? energy_distance(PlaneSample(observed), plane_)
                   : energy_distance(SortedSample(numbers_of(observed)), line_);
}

double MisfitPool::quantiles_of(const std::vector<Vec2>& observed) const {
  return quantile_distance(SortedSample(numbers_of(observed)), line_);
}

std::vector<std::vector<Vec2>> MisfitPool::drawn(std::size_t count, std::uint64_t seed) const {
  std::vector<std::vector<Vec2>> list;
  const std::uint64_t name = hash_name("observed.noise");
  const std::size_t picks = values_.size() > 1 ? values_.size() : count;
  for (int draw = 0; draw < draws; ++draw) {
    DrawKey key;
    key.trial = static_cast<std::uint64_t>(draw);
    RandomStream rng(seed, name, key);
    std::vector<Vec2>& drawn = list.emplace_back();
    for (std::size_t i = 0; i < picks; ++i) {
      const std::vector<Vec2>& row = values_[values_.size() > 1 ? i : 0];
      drawn.push_back(
          row[static_cast<std::size_t>(rng.integer(0, static_cast<std::int64_t>(row.size()) - 1))]);
    }
  }
  return list;
}

std::vector<double> MisfitPool::energies_of_draws(std::size_t count, std::uint64_t seed) const {
  std::vector<double> energies;
  for (const std::vector<Vec2>& values : drawn(count, seed)) energies.push_back(energy_of(values));
  return energies;
}

namespace {

Vec2 in_plane(double value) { return {value, 0}; }
const Vec2& in_plane(const Vec2& value) { return value; }

double mean_distance_at(const SortedSample& sample, const Vec2& x) { return sample.mean_distance(x.x()); }
double mean_distance_at(const PlaneSample& sample, const Vec2& x) { return sample.mean_distance(x); }

}  // namespace

template <class Sample>
DistanceTable::DistanceTable(const Sample& sample) {
  constexpr double beyond_all = 1e300;  // where all values are equal, every other place is beyond them
  constexpr bool is_line = std::is_same_v<Sample, SortedSample>;
  columns_ = is_line ? 1024 : 64;
  rows_ = is_line ? 1 : 64;
  own_ = sample.own_distance();
  Vec2 high = in_plane(sample.values().front());
  low_ = high;
  for (const auto& value : sample.values()) {
    low_ = low_.cwiseMin(in_plane(value));
    high = high.cwiseMax(in_plane(value));
    mean_ += in_plane(value) / static_cast<double>(sample.size());
  }
  step_ = Vec2((high.x() - low_.x()) / (columns_ - 1), rows_ > 1 ? (high.y() - low_.y()) / (rows_ - 1) : 0);
  per_step_ = step_.unaryExpr([](double step) { return step > 0 ? 1 / step : beyond_all; });
  distances_.clear();
  for (int j = 0; j < rows_; ++j)
    for (int i = 0; i < columns_; ++i)
      distances_.push_back(mean_distance_at(sample, low_ + Vec2(i * step_.x(), j * step_.y())));
}

double DistanceTable::at(const Vec2& x) const {
  const Vec2 from = (x - low_).cwiseProduct(per_step_);
  const double u = std::clamp(from.x(), 0.0, columns_ - 1.0), v = std::clamp(from.y(), 0.0, rows_ - 1.0);
  const std::size_t i = std::min(static_cast<std::size_t>(u), static_cast<std::size_t>(columns_ - 2));
  const double a = u - static_cast<double>(i);
  const auto along = [&](std::size_t row) {
    const double* values = &distances_[row * static_cast<std::size_t>(columns_) + i];
    return values[0] + a * (values[1] - values[0]);
  };
  double inside = 0;
  if (rows_ == 1) {
    inside = along(0);
  } else {
    const std::size_t j = std::min(static_cast<std::size_t>(v), static_cast<std::size_t>(rows_ - 2));
    inside = along(j) + (v - static_cast<double>(j)) * (along(j + 1) - along(j));
  }
  const bool is_beyond = u != from.x() || (rows_ > 1 && v != from.y());
  if (!is_beyond) return inside;
  const Vec2 nearest = low_ + Vec2(u * step_.x(), v * step_.y());
  return inside + (x - mean_).norm() - (nearest - mean_).norm();
}

double DistanceTable::partial_energy(const std::vector<Vec2>& values) const {
  double sum = 0;
  for (const Vec2& value : values) sum += at(value);
  return 2 * sum / static_cast<double>(values.size()) - own_;
}

template DistanceTable::DistanceTable(const SortedSample&);
template DistanceTable::DistanceTable(const PlaneSample&);

double energy_of_constant(const std::vector<Vec2>& observed, const Vec2& constant, bool in_plane) {
  return in_plane ? energy_distance(PlaneSample(observed), PlaneSample({constant}))
                  : energy_distance(SortedSample(numbers_of(observed)), SortedSample({constant.x()}));
}

}  // namespace flyrock
