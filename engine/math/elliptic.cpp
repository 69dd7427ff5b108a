#include "math/elliptic.h"

#include <algorithm>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <cmath>
#include <utility>

#include "math/space.h"

namespace flyrock {

namespace {

double arithmetic_geometric_mean(double a, double b) {
  while (std::abs(a - b) > 1e-8 * a) {  // the next mean is then exact to rounding
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  return 0.5 * (a + b);
}

}  // namespace

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

double first_kind(const Modulus& modulus, double sine, double cosine) {
  const double c2 = cosine * cosine, d2 = modulus.m1 + modulus.m * c2;
  return sine * boost::math::ellint_rf(c2, d2, 1.0);
}

double third_kind(const Modulus& modulus, double n, double sine, double cosine) {
  const double c2 = cosine * cosine, s2 = sine * sine, d2 = modulus.m1 + modulus.m * c2;
  return first_kind(modulus, sine, cosine) +
         n / 3 * sine * s2 * boost::math::ellint_rj(c2, d2, 1.0, 1 - n * s2);
}

EllipticFunctions::EllipticFunctions(const Modulus& modulus, double n)
    : modulus_(modulus), n_(n), quarter_(0.5 * pi / arithmetic_geometric_mean(1, std::sqrt(modulus.m1))) {
  // Without m there is no second period, and the exponential is 0.
  const double ratio =
      modulus.m > 0 ? 0.5 * pi / arithmetic_geometric_mean(1, std::sqrt(modulus.m)) / quarter_ : 300;
  const double q = std::exp(-pi * ratio);
  if (q > 0.3) {
    third_kind_quarter_ = third_kind(modulus, n, 1, 0);
    return;
  }
  const double s2 = 1 / (1 - n), c2 = -n / (1 - n), d2 = 1 - modulus.m1 * s2;
  const double eta = first_kind({modulus.m1, modulus.m}, std::sqrt(s2), std::sqrt(c2));
  const double beta = 0.5 * pi * eta / quarter_, sinh_2 = std::sinh(2 * beta), cosh_2 = std::cosh(2 * beta);
  double sinh = std::sinh(beta), cosh = std::cosh(beta);
  double odd = 1, even = 1, power = 1;                                       // power = q^i
  double theta_2 = 0, theta_3 = 0, theta_4 = 0, across = 0, along_rate = 0;  // the last two at K
  for (int i = 0; i < most_terms && std::max(even, odd * cosh) > 1e-19; ++i, ++terms_) {
    const double sign = i % 2 == 0 ? 1 : -1;
    term_[i] = {sign * odd, sign * (i == 0 ? 1 : 2 * even), sign * odd * cosh, sign * odd * sinh};
    theta_2 += odd;
    theta_3 += sign * term_[i].even;
    theta_4 += term_[i].even;
    across += odd * cosh;
    along_rate += (2 * i + 1) * odd * sinh;
    even *= power * power * q;
    power *= q;
    odd *= power * power;
    const double next = sinh * cosh_2 + cosh * sinh_2;
    cosh = cosh * cosh_2 + sinh * sinh_2;
    sinh = next;
  }
  sn_scale_ = theta_3 / theta_2;
  cn_scale_ = theta_4 / theta_2;
  // At K the integrand is 1/(1 - n), which determines A without cancellation.
  turning_ = std::sqrt(c2 * s2 / d2);
  linear_ = s2 - turning_ * 0.5 * pi / quarter_ * along_rate / across;
  third_kind_quarter_ = linear_ * quarter_ + 0.5 * pi * turning_;
}

EllipticFunctions::Values EllipticFunctions::at(double u) const {
  const double half_periods = std::round(u / (2 * quarter_)), within = u - 2 * quarter_ * half_periods;
  Values v;
  if (terms_ > 0) {
    v = by_series(within);
  } else {
    const Jacobi f = jacobi(modulus_, within);
    // Near K both integrals rise by 1/dn times an error of the amplitude, which dn makes great close to m =
    // 1; their difference Pi - F/(1 - n) does not. F itself is the argument.
    const double error = within - first_kind(modulus_, f.sn, f.cn);
    v = {f.sn, f.cn, f.dn, third_kind(modulus_, n_, f.sn, f.cn) + error / (1 - n_)};
  }
  if (std::fmod(half_periods, 2) != 0) v.sn = -v.sn, v.cn = -v.cn;
  v.third_kind += 2 * half_periods * third_kind_quarter_;
  return v;
}

EllipticFunctions::Values EllipticFunctions::by_series(double u) const {
  const double z = 0.5 * pi * u / quarter_, sine = std::sin(z), cosine = std::cos(z);
  const double twice = 2 * (1 - 2 * sine * sine);  // 2 cos 2z: all angles follow from it by recurrence
  double s = sine, s_last = -sine, c = cosine, c_last = cosine, e = 1, e_last = 0.5 * twice;
  double theta_1 = 0, theta_2 = 0, theta_4 = 0, along = 0, across = 0;
  for (int i = 0; i < terms_; ++i) {
    const Term& term = term_[i];
    theta_1 += term.odd * s;
    theta_2 += (i % 2 == 0 ? term.odd : -term.odd) * c;
    theta_4 += term.even * e;
    across += term.odd_cosh * s;
    along += term.odd_sinh * c;
    s_last = std::exchange(s, twice * s - s_last);
    c_last = std::exchange(c, twice * c - c_last);
    e_last = std::exchange(e, twice * e - e_last);
  }
  const double sn = sn_scale_ * theta_1 / theta_4, cn = cn_scale_ * theta_2 / theta_4;
  return {sn, cn, std::sqrt(modulus_.m1 + modulus_.m * cn * cn),
          linear_ * u + turning_ * std::atan2(across, along)};
}

}  // namespace flyrock
