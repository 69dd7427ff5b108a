#include "math/polynomial.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flyrock {

namespace {

constexpr int max_degree = 10;

struct Roots {
  std::array<double, max_degree> at;
  int count = 0;
  void add(double t) { at[count++] = t; }
};

/// A root of p between a and b, where p changes sign, by Newton's method safeguarded by bisection. Returns
/// the end of the last bracket at which p has the sign of p(a).
double bracketed_root(std::span<const double> c, double a, double b) {
  const bool positive = evaluate(c, a) > 0;
  double t = 0.5 * (a + b);
  for (int i = 0; i < 200 && a < t && t < b; ++i) {
    const double p = evaluate(c, t);
    ((p > 0) == positive ? a : b) = t;
    double slope = 0;
    for (std::size_t k = c.size() - 1; k > 0; --k) slope = slope * t + static_cast<double>(k) * c[k];
    const double newton = t - p / slope, resolution = 1e-16 * (std::abs(a) + std::abs(b));
    if (std::abs(newton - t) <= resolution) {
      // Converged from one side: a step across the root closes the bracket from the other.
      const double across = a == t ? t + 2 * resolution : t - 2 * resolution;
      t = across > a && across < b ? across : 0.5 * (a + b);
    } else {
      // A Newton step that lands on an end of the bracket would end the search there. Bisect instead.
      t = newton > a && newton < b ? newton : 0.5 * (a + b);
    }
    if (b - a <= 4e-16 * (std::abs(a) + std::abs(b))) break;
  }
  return a;
}

Roots roots_between(std::span<const double> c, double low, double high) {
  while (c.size() > 1 && c.back() == 0) c = c.first(c.size() - 1);
  Roots roots;
  const int degree = static_cast<int>(c.size()) - 1;
  if (degree < 1) return roots;
  if (degree == 1) {
    const double t = -c[0] / c[1];
    if (t >= low && t <= high) roots.add(t);
    return roots;
  }
  std::array<double, max_degree> derivative{};
  for (int k = 1; k <= degree; ++k) derivative[k - 1] = k * c[k];
  const Roots turns = roots_between(std::span<const double>(derivative.data(), degree), low, high);
  double a = low;
  for (int i = 0; i <= turns.count; ++i) {
    const double b = i < turns.count ? turns.at[i] : high;
    const double pa = evaluate(c, a), pb = evaluate(c, b);
    if ((pa > 0) != (pb > 0) && b > a) roots.add(bracketed_root(c, a, b));
    a = b;
  }
  return roots;
}

/// Whether the coefficients alone show that sign * p > 0 on [0, high].
bool keeps_sign(std::span<const double> c, double high, double sign) {
  double least = sign * c[0], power = 1;
  for (std::size_t k = 1; k < c.size(); ++k) {
    power *= high;
    least += std::min(sign * c[k], 0.0) * power;
  }
  return least > 0;
}

}  // namespace

double evaluate(std::span<const double> c, double t) {
  double p = 0;
  for (std::size_t k = c.size(); k-- > 0;) p = p * t + c[k];
  return p;
}

std::optional<double> first_approach(std::span<const double> c, double low, double high) {
  if (evaluate(c, low) > 0) return first_fall(c, low, high);
  std::array<double, max_degree> slope{};
  for (std::size_t k = 1; k < c.size(); ++k) slope[k - 1] = static_cast<double>(k) * c[k];
  const auto turn = first_fall(std::span<const double>(slope.data(), c.size() - 1), low, high);
  if (turn && evaluate(c, *turn) <= 0) return turn;
  return first_fall(c, low, high);
}

std::optional<double> first_fall(std::span<const double> c, double low, double high) {
  if (low == 0 && keeps_sign(c, high, 1)) return std::nullopt;
  if (evaluate(c, low) <= 0) {
    // The first non-zero derivative at low decides whether p falls or rises from there.
    std::array<double, max_degree + 1> d{};
    std::copy(c.begin(), c.end(), d.begin());
    for (std::size_t order = 1; order < c.size(); ++order) {
      const std::size_t terms = c.size() - order;
      for (std::size_t k = 0; k < terms; ++k) d[k] = static_cast<double>(k + 1) * d[k + 1];
      const double slope = evaluate(std::span<const double>(d.data(), terms), low);
      if (slope < 0) return low;
      if (slope > 0) break;
    }
  }
  if (low == 0 && keeps_sign(c, high, -1)) return std::nullopt;
  const Roots roots = roots_between(c, low, high);
  double before = low;
  for (int i = 0; i < roots.count; ++i) {
    const double after = i + 1 < roots.count ? roots.at[i + 1] : high;
    if (evaluate(c, 0.5 * (before + roots.at[i])) > 0 && evaluate(c, 0.5 * (roots.at[i] + after)) <= 0)
      return roots.at[i];
    before = roots.at[i];
  }
  return std::nullopt;
}

}  // namespace flyrock
