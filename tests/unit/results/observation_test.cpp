// The comparison of a model with measured rows, on samples that are known.

#include "results/compare/observation.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "random/stream.h"

namespace flyrock::observation_test {

namespace {

constexpr int trials = 300;

ObservedPlan plan_of(std::size_t rows, bool is_paired = true) {
  ObservedPlan plan;
  for (std::size_t r = 0; r < rows; ++r) {
    ObservedRow& row = plan.rows.emplace_back();
    row.rock_group = is_paired ? 0 : -1;
    row.rock_line = is_paired ? static_cast<int>(r) : -1;
  }
  return plan;
}

/// A normal value of row r in trial t, which has the mean 20 + r and the deviation 3.
double model_value(std::size_t r, std::uint64_t t, double shift = 0) {
  DrawKey key;
  key.trial = t;
  key.rock = r + 1;
  RandomStream rng(11, "model", key);
  return 20 + static_cast<double>(r) + shift + 3 * rng.normal();
}

/// What is measured is one more trial of the model.
std::pair<ObservedPlan, SimulatedRows> sample(std::size_t rows, double shift = 0) {
  ObservedPlan plan = plan_of(rows);
  SimulatedRows simulated;
  simulated.trials = trials;
  for (std::size_t r = 0; r < rows; ++r) {
    plan.rows[r].distance = model_value(r, trials);
    SimulatedRow& row = simulated.rows.emplace_back();
    for (std::uint64_t t = 0; t < trials; ++t)
      row.values.push_back({t, {model_value(r, t, shift), 0}, false});
  }
  return {plan, simulated};
}

}  // namespace

TEST_CASE("a true model has a bias and an energy distance within their noise, and 90 % of the rows inside") {
  const auto [plan, simulated] = sample(200);
  const ObservationSummary summary = compare(plan, simulated, 1);
  CHECK(summary.rows == 200);
  CHECK(summary.values == 200 * trials);
  CHECK(std::abs(summary.bias) < 3 * summary.bias_error);
  CHECK(summary.bias_error == Approx(3 / std::sqrt(200.0)).epsilon(0.15));
  CHECK(summary.energy < 2 * summary.energy_noise_p90);
  CHECK(summary.energy_noise < summary.energy_noise_p90);
  CHECK(summary.with_band == 200);
  CHECK(summary.inside > 165);
  CHECK(summary.inside < 195);
  CHECK(summary.constant_energy > 10 * summary.energy);
}

TEST_CASE("a model that is 4 m far has that bias, and an energy distance above its noise") {
  const auto [plan, simulated] = sample(100, 4);
  const ObservationSummary summary = compare(plan, simulated, 1);
  CHECK(summary.bias == Approx(4).margin(4 * summary.bias_error));
  CHECK(summary.energy > summary.energy_noise_p90);
  CHECK(observation_text(plan, summary).find(" m too far on the mean (") != std::string::npos);
}

TEST_CASE("rocks that left are counted apart, with them the scores count where they were last seen") {
  auto [plan, simulated] = sample(20);
  const ObservationSummary before = compare(plan, simulated, 1);
  for (SimulatedRow& row : simulated.rows) row.values.push_back({trials, {1e4, 0}, true});
  const ObservationSummary after = compare(plan, simulated, 1);
  CHECK(after.censored == 20);
  CHECK(after.energy == before.energy);
  CHECK(after.bias == before.bias);
  CHECK(before.with_censored.bias == before.bias);
  CHECK(before.with_censored.energy == before.energy);
  // A share p of the trials is d farther: the bias grows by p d, the energy distance by 2 p^2 d.
  constexpr double p = 1 / (trials + 1.0), d = 9970;
  CHECK(after.with_censored.bias == Approx(before.bias + p * d).margin(0.2));
  CHECK(after.with_censored.energy == Approx(after.energy + 2 * p * p * d).margin(0.02));
  CHECK(observation_text(plan, after).find("Counted where they were last seen, the model is 33") !=
        std::string::npos);
  CHECK(after.rocks.front().censored == 1);
}

TEST_CASE("a model whose trials are alike is said to have no scatter") {
  auto [plan, simulated] = sample(20);
  for (SimulatedRow& row : simulated.rows)
    for (SimulatedValue& value : row.values) value.value = row.values.front().value;
  const ObservationSummary summary = compare(plan, simulated, 1);
  CHECK_FALSE(summary.has_scatter);
  CHECK(summary.with_band == 0);
  CHECK(std::isnan(summary.energy_noise));
  CHECK(std::isfinite(summary.energy));
  CHECK(observation_text(plan, summary).find("no scatter") != std::string::npos);
}

TEST_CASE("rows without rocks of their own are compared as a whole") {
  ObservedPlan plan = plan_of(30, false);
  SimulatedRows simulated;
  SimulatedRow& all = simulated.rows.emplace_back();
  for (std::size_t r = 0; r < 30; ++r) {
    plan.rows[r].distance = model_value(r, trials);
    for (std::uint64_t t = 0; t < trials; ++t) all.values.push_back({t, {model_value(r, t), 0}, false});
  }
  std::sort(all.values.begin(), all.values.end(),
            [](const SimulatedValue& a, const SimulatedValue& b) { return a.trial < b.trial; });
  const ObservationSummary summary = compare(plan, simulated, 1);
  CHECK(summary.has_scatter);
  CHECK(summary.with_band == 0);
  CHECK(std::abs(summary.bias) < 3 * summary.bias_error);
  CHECK(summary.bias_error == Approx(summary.observed.standard_deviation() / std::sqrt(30.0)).epsilon(0.05));
}

TEST_CASE("places are compared along the way and across it") {
  ObservedPlan plan = plan_of(50);
  plan.of = ObservedNumber::place;
  SimulatedRows simulated;
  for (std::size_t r = 0; r < 50; ++r) {
    // The way is along (3, 4)/5; the model goes 2 m too far and 1 m too much to the left.
    const Vec2 along(0.6, 0.8), left(-0.8, 0.6);
    const double s = model_value(r, trials);
    const Vec2 place = Vec2(100, 200) + s * along;
    plan.rows[r].place = Vec3(place.x(), place.y(), 0);
    SimulatedRow& row = simulated.rows.emplace_back();
    row.start = Vec2(100, 200);
    for (std::uint64_t t = 0; t < 40; ++t)
      row.values.push_back({t, place + (2 + 0.1 * static_cast<double>(t % 3)) * along + 1 * left, false});
  }
  const ObservationSummary summary = compare(plan, simulated, 1);
  CHECK(summary.bias == Approx(2.1).margin(0.02));
  CHECK(summary.across == Approx(1).margin(1e-9));
  CHECK(summary.energy > 0);
}

}  // namespace flyrock::observation_test
