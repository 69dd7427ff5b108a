#include "math/parabola_length.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <catch2/catch.hpp>

using namespace flyrock;

namespace {

/// The same by quadrature, cut where the motion turns.
double integrated_length(double p_squared, double u0, double a, double t) {
  const auto speed = [&](double at) { return std::sqrt(p_squared + (u0 + a * at) * (u0 + a * at)); };
  const auto over = [&](double from, double to) {
    return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(speed, from, to, 15, 1e-14);
  };
  const double turn = a > 0 ? std::clamp(-u0 / a, 0.0, t) : 0;
  return over(0, turn) + over(turn, t);
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
