// Energy distances against closed forms and against all pairs.

#include "results/statistics/energy_distance.h"

#include <array>
#include <boost/math/distributions/normal.hpp>
#include <catch2/catch.hpp>
#include <cmath>

#include "random/stream.h"

namespace flyrock::energy_distance_test {

namespace {

/// The mean of |X| of a normal variable.
double mean_of_folded(double mean, double sd) {
  return sd * std::sqrt(2 / pi) * std::exp(-mean * mean / (2 * sd * sd)) +
         mean * std::erf(mean / (sd * std::sqrt(2.0)));
}

/// Of N(m1, s1^2) and N(m2, s2^2): X - Y, X - X' and Y - Y' are normal.
double of_two_normals(double m1, double s1, double m2, double s2) {
  return 2 * mean_of_folded(m1 - m2, std::hypot(s1, s2)) - 2 * s1 / std::sqrt(pi) - 2 * s2 / std::sqrt(pi);
}

/// Its quantiles in the middle of n equal shares.
std::vector<double> normal_values(double mean, double sd, int n) {
  std::vector<double> values;
  for (int i = 0; i < n; ++i)
    values.push_back(boost::math::quantile(boost::math::normal(mean, sd), (i + 0.5) / n));
  return values;
}

std::vector<double> drawn(int n, std::uint64_t seed) {
  RandomStream rng(seed, "values", {});
  std::vector<double> values;
  for (int i = 0; i < n; ++i) values.push_back(std::round(40 * rng.uniform()) / 4);  // some are equal
  return values;
}

template <class Values, class Distance>
double by_all_pairs(const Values& a, const Values& b, Distance distance) {
  const auto mean = [&](const Values& x, const Values& y) {
    double sum = 0;
    for (const auto& one : x)
      for (const auto& other : y) sum += distance(one, other);
    return sum / static_cast<double>(x.size() * y.size());
  };
  return 2 * mean(a, b) - mean(a, a) - mean(b, b);
}

}  // namespace

TEST_CASE("the energy distance of two normals is that of the closed form to 1e-3") {
  for (const auto& [m1, s1, m2, s2] : std::vector<std::array<double, 4>>{
           {0, 1, 0, 1}, {0, 1, 2, 1}, {5, 1, 5, 2}, {-3, 0.5, 1, 1.5}, {0, 1, 10, 1}}) {
    const double found =
        energy_distance(SortedSample(normal_values(m1, s1, 8000)), SortedSample(normal_values(m2, s2, 5000)));
    INFO(m1 << ' ' << s1 << ' ' << m2 << ' ' << s2);
    CHECK(found == Approx(of_two_normals(m1, s1, m2, s2)).margin(1e-3));
  }
}

TEST_CASE("the energy distance by ranks is that of all pairs, for any sizes and equal values") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto a = drawn(1 + static_cast<int>(seed % 7), seed),
               b = drawn(1 + static_cast<int>(seed % 23), seed + 100);
    CHECK(energy_distance(SortedSample(a), SortedSample(b)) ==
          Approx(by_all_pairs(a, b, [](double x, double y) { return std::abs(x - y); })).margin(1e-12));
    CHECK(energy_distance(SortedSample(a), SortedSample(a)) == Approx(0).margin(1e-12));
  }
}

TEST_CASE("the energy distance in the plane is that of all pairs, on a line it is that of numbers") {
  const auto x = drawn(30, 1), y = drawn(20, 2), z = drawn(30, 3), w = drawn(20, 4);
  std::vector<Vec2> a, b, line;
  for (std::size_t i = 0; i < x.size(); ++i) a.emplace_back(x[i], z[i]);
  for (std::size_t i = 0; i < y.size(); ++i) b.emplace_back(y[i], w[i]);
  CHECK(energy_distance(PlaneSample(a), PlaneSample(b)) ==
        Approx(by_all_pairs(a, b, [](const Vec2& p, const Vec2& q) { return (p - q).norm(); })));
  for (const double value : y) line.emplace_back(3 * value, 4 * value);  // 5 m a unit
  std::vector<Vec2> other;
  for (const double value : x) other.emplace_back(3 * value, 4 * value);
  CHECK(energy_distance(PlaneSample(line), PlaneSample(other)) ==
        Approx(5 * energy_distance(SortedSample(y), SortedSample(x))));
}

TEST_CASE("the distance of quantiles of a shifted sample is the shift") {
  const auto values = drawn(60, 5);
  std::vector<double> shifted;
  for (const double value : values) shifted.push_back(value + 2.5);
  CHECK(quantile_distance(SortedSample(values), SortedSample(shifted)) == Approx(2.5));
  CHECK(quantile_distance(SortedSample({1.0}), SortedSample({0.0, 4.0})) == Approx(2));
}

TEST_CASE("quantiles are linear between the middles of equal shares") {
  const SortedSample sample({3.0, 1.0, 2.0, 4.0});
  CHECK(sample.quantile(0.5) == Approx(2.5));
  CHECK(sample.quantile(0.125) == Approx(1));
  CHECK(sample.quantile(0) == Approx(1));
  CHECK(sample.quantile(1) == Approx(4));
  CHECK(sample.mean() == Approx(2.5));
  CHECK(sample.standard_deviation() == Approx(std::sqrt(5.0 / 3)));
}

}  // namespace flyrock::energy_distance_test
