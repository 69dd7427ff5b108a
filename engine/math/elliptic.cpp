#include "math/elliptic.h"

#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <cmath>

namespace flyrock {

Jacobi jacobi(const Modulus& modulus, double u) {
  constexpr int most_halvings = 16;
  std::array<double, most_halvings> share;  // c_n / a_n
  double a = 1, b = std::sqrt(modulus.m1), c = std::sqrt(modulus.m), power = 1;
  int n = 0;
  while (c > 1e-17 * a && n < most_halvings) {
    c = 0.5 * (a - b);
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
    share[n++] = c / a;
    power *= 2;
  }
  double amplitude = power * a * u;
  while (n > 0) amplitude = 0.5 * (amplitude + std::asin(share[--n] * std::sin(amplitude)));
  const double sn = std::sin(amplitude), cn = std::cos(amplitude);
  return {sn, cn, std::sqrt(modulus.m1 + modulus.m * cn * cn)};
}

EllipticIntegrals elliptic_integrals(const Modulus& modulus, double n, double sine, double cosine) {
  const double c2 = cosine * cosine, s2 = sine * sine, d2 = modulus.m1 + modulus.m * c2;
  const double first = sine * boost::math::ellint_rf(c2, d2, 1.0);
  return {first, first + n / 3 * sine * s2 * boost::math::ellint_rj(c2, d2, 1.0, 1 - n * s2)};
}

}  // namespace flyrock
