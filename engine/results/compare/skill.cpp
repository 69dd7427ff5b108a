#include "results/compare/skill.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "random/stream.h"
#include "results/compare/observation.h"
#include "results/say/wording.h"
#include "results/statistics/energy_distance.h"

namespace flyrock {

namespace {

constexpr std::size_t most_rows = 1000, most_of_model = 4000;
constexpr int bootstraps = 1000;

std::vector<Vec2> thinned(const std::vector<Vec2>& values, std::size_t most) {
  const std::size_t step = std::max<std::size_t>(1, (values.size() + most - 1) / most);
  std::vector<Vec2> list;
  for (std::size_t i = 0; i < values.size(); i += step) list.push_back(values[i]);
  return list;
}

/// E|x - Y| of each x, and E|Y - Y'|.
struct FromModel {
  std::vector<double> distances;
  double own = 0;
};

FromModel from_model(const std::vector<Vec2>& held, const std::vector<Vec2>& model, bool in_plane) {
  FromModel from;
  const auto measure = [&](const auto& sample, auto value_of) {
    for (const Vec2& x : held) from.distances.push_back(sample.mean_distance(value_of(x)));
    from.own = sample.own_distance();
  };
  if (in_plane) {
    measure(PlaneSample(model), [](const Vec2& x) { return x; });
  } else {
    std::vector<double> numbers;
    for (const Vec2& value : model) numbers.push_back(value.x());
    measure(SortedSample(std::move(numbers)), [](const Vec2& x) { return x.x(); });
  }
  return from;
}

/// The skill of drawn rows. Distances between rows are looked up.
class Skills {
 public:
  Skills(const std::vector<Vec2>& held, const std::vector<Vec2>& model, const std::vector<Vec2>& others,
         bool in_plane)
      : held_(held.size()), others_(others.size()), model_(from_model(held, model, in_plane)) {
    for (const Vec2& x : held)
      for (const Vec2& other : others) to_others_.push_back((x - other).norm());
    for (const Vec2& a : others)
      for (const Vec2& b : others) between_.push_back((a - b).norm());
  }

  /// Rows by their indices. `repeats`: draws of rows have equal pairs twice as often by chance.
  double of(const std::vector<std::size_t>& x, const std::vector<std::size_t>& o, bool are_drawn) const {
    double model = 0, to_others = 0, between = 0;
    for (const std::size_t i : x) {
      model += model_.distances[i];
      for (const std::size_t j : o) to_others += to_others_[i * others_ + j];
    }
    for (const std::size_t j : o)
      for (const std::size_t k : o) between += between_[j * others_ + k];
    const double n = static_cast<double>(x.size()), m = static_cast<double>(o.size());
    // Of m rows a share 1/m of all pairs is a row with itself; of m rows drawn from them one more.
    const double different = std::pow(m / (m - 1), are_drawn ? 2 : 1);
    return 2 * (model / n - to_others / (n * m)) - model_.own + different * between / (m * m);
  }

  std::size_t held() const { return held_; }
  std::size_t others() const { return others_; }

 private:
  std::size_t held_, others_;
  FromModel model_;
  std::vector<double> to_others_, between_;
};

std::vector<std::size_t> drawn(std::size_t count, RandomStream& rng) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < count; ++i)
    indices.push_back(static_cast<std::size_t>(rng.integer(0, static_cast<std::int64_t>(count) - 1)));
  return indices;
}

std::vector<std::size_t> all_of(std::size_t count) {
  std::vector<std::size_t> indices(count);
  for (std::size_t i = 0; i < count; ++i) indices[i] = i;
  return indices;
}

Vec2 start_of(const ObservedPlan& plan, const SimulatedRows& simulated, std::size_t row) {
  if (plan.of != ObservedNumber::place) return Vec2::Zero();
  return simulated.rows[plan.is_paired() ? row : 0].start;
}

}  // namespace

Skill skill_of(const std::vector<Vec2>& held, const std::vector<Vec2>& model, const std::vector<Vec2>& others,
               bool in_plane, std::uint64_t seed) {
  Skill skill;
  if (held.size() < 2 || others.size() < 2 || model.empty()) return skill;
  const Skills skills(thinned(held, most_rows), thinned(model, most_of_model), thinned(others, most_rows),
                      in_plane);
  skill.difference = skills.of(all_of(skills.held()), all_of(skills.others()), false);
  std::vector<double> repeats;
  for (int b = 0; b < bootstraps; ++b) {
    DrawKey key;
    key.trial = static_cast<std::uint64_t>(b);
    RandomStream rng(seed, hash_name("skill"), key);
    const std::vector<std::size_t> x = drawn(skills.held(), rng), o = drawn(skills.others(), rng);
    repeats.push_back(skills.of(x, o, true));
  }
  const SortedSample sorted(std::move(repeats));
  const double tail = (1 - stated_confidence) / 2;
  skill.interval.lower = sorted.quantile(tail);
  skill.interval.upper = sorted.quantile(1 - tail);
  return skill;
}

std::vector<Vec2> measured_ways(const ObservedPlan& plan, const SimulatedRows& simulated,
                                const std::vector<std::size_t>& rows) {
  const std::vector<Vec2> all = observed_values(plan, simulated);
  std::vector<Vec2> ways;
  for (const std::size_t row : rows)
    if (const Vec2 way = all[row] - start_of(plan, simulated, row); way.allFinite()) ways.push_back(way);
  return ways;
}

std::vector<Vec2> simulated_ways(const ObservedPlan& plan, const SimulatedRows& simulated,
                                 const std::vector<std::size_t>& rows) {
  std::vector<Vec2> ways;
  const auto add = [&](std::size_t row) {
    const Vec2 start = start_of(plan, simulated, row);
    for (const SimulatedValue& value : simulated.rows[row].values) ways.push_back(value.value - start);
  };
  if (!plan.is_paired())
    add(0);
  else
    for (const std::size_t row : rows) add(row);
  return ways;
}

std::string skill_text(const Skill& skill, const std::string& held_name) {
  if (!skill.is_known())
    return fmt::format(
        "The skill for {} is not known: it needs two rows that are held back and two of the fit.", held_name);
  const std::string numbers = fmt::format(
      "energy distance of the prediction less that of the distances of the other rows {} m, 95 % "
      "interval {} to {} m",
      three_digits(skill.difference), three_digits(skill.interval.lower), three_digits(skill.interval.upper));
  if (skill.has_skill())
    return fmt::format("The model predicts {} better than the distances of the other rows do ({}).",
                       held_name, numbers);
  if (skill.is_worse())
    return fmt::format("No skill: the model predicts {} worse than the distances of the other rows do ({}).",
                       held_name, numbers);
  return fmt::format(
      "No skill: the model is not shown to predict {} better than the distances of the other rows do ({}).",
      held_name, numbers);
}

}  // namespace flyrock
