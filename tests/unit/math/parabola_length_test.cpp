#include "math/parabola_length.h"

#include <boost/math/quadrature/gauss.hpp>
#include <catch2/catch.hpp>

using namespace flyrock;

namespace {

/// The same by quadrature over pieces that grow from where the motion turns, because the speed bends there
/// within the time p/a.
double integrated_length(double p_squared, double u0, double a, double t) {
  const double turn = -u0 / a;
  const auto speed = [&](double at) { return std::hypot(std::sqrt(p_squared), a * (at - turn)); };
  double sum = 0;
  const auto add = [&](double from, double to) {
    from = std::clamp(from, 0.0, t), to = std::clamp(to, 0.0, t);
    if (from < to) sum += boost::math::quadrature::gauss<double, 30>::integrate(speed, from, to);
  };
  double reach = std::sqrt(p_squared) / a;
  add(turn - reach, turn + reach);
  for (; turn - reach > 0 || turn + reach < t; reach *= 3) {
    add(turn - 3 * reach, turn - reach);
    add(turn + reach, turn + 3 * reach);
  }
  return sum;
}

}  // namespace

TEST_CASE("the length of a parabola is the integral of its speed", "[fast]") {
  for (const double p : {1e-3, 0.3, 2.0, 40.0})
    for (const double u0 : {-30.0, -2.0, -1e-3, 0.0, 0.7, 25.0})
      for (const double t : {1e-6, 1e-3, 0.03, 0.5, 8.0})
        for (const double a : {9.81, 0.4}) {
          CAPTURE(p, u0, t, a);
          const double expected = integrated_length(p * p, u0, a, t);
          CHECK(std::abs(parabola_length(p * p, u0, a, t) - expected) <= 1e-12 * expected);
        }
}

TEST_CASE("the length of a path without bend, without motion, or straight up and down is exact", "[fast]") {
  CHECK(parabola_length(9, 4, 0, 2) == 10);
  CHECK(parabola_length(0, 0, 0, 2) == 0);
  CHECK(parabola_length(0, 0, 2, 3) == 9);
  CHECK(std::abs(parabola_length(0, -10, 10, 2) - 10) < 1e-14);
  CHECK(std::abs(parabola_length(1e-300, -10, 10, 2) - 10) < 1e-12);
}
