#include "results/misfit.h"

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

std::vector<double> MisfitPool::energies_of_draws(std::size_t count, std::uint64_t seed) const {
  std::vector<double> energies;
  const std::uint64_t name = hash_name("observed.noise");
  const std::size_t picks = values_.size() > 1 ? values_.size() : count;
  for (int draw = 0; draw < draws; ++draw) {
    DrawKey key;
    key.trial = static_cast<std::uint64_t>(draw);
    RandomStream rng(seed, name, key);
    std::vector<Vec2> drawn;
    for (std::size_t i = 0; i < picks; ++i) {
      const std::vector<Vec2>& row = values_[values_.size() > 1 ? i : 0];
      drawn.push_back(
          row[static_cast<std::size_t>(rng.integer(0, static_cast<std::int64_t>(row.size()) - 1))]);
    }
    energies.push_back(energy_of(drawn));
  }
  return energies;
}

double energy_of_constant(const std::vector<Vec2>& observed, const Vec2& constant, bool in_plane) {
  return in_plane ? energy_distance(PlaneSample(observed), PlaneSample({constant}))
                  : energy_distance(SortedSample(numbers_of(observed)), SortedSample({constant.x()}));
}

}  // namespace flyrock
