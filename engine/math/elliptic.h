#pragma once
// Elliptic functions and integrals that stay accurate for a modulus close to 1.

#include <array>

namespace flyrock {

/// The squares of a modulus and of its complement, m + m1 = 1, m1 > 0. Both are stored, because near m = 1
/// the difference 1 - m loses its digits, and with them the period 4 K = 4 log(4/sqrt(m1)). (Boost's
/// functions, which take the modulus alone, are accurate only to 1e-4 there.)
struct Modulus {
  double m = 0, m1 = 1;
};

/// sn, cn and dn = sqrt(m1 + m cn^2) at u in [-K, K], by the arithmetic-geometric mean (Abramowitz and
/// Stegun 16.4).
struct Jacobi {
  double sn, cn, dn;
};
Jacobi jacobi(const Modulus& modulus, double u);

/// The integrals of the first and the third kind, from 0 to an amplitude in [-pi/2, pi/2], which is given by
/// its sine and cosine:
///   F = int dx / sqrt(1 - m sin^2 x),  Pi = int dx / ((1 - n sin^2 x) sqrt(1 - m sin^2 x)),  n < 1,
/// by Carlson's symmetric forms.
double first_kind(const Modulus& modulus, double sine, double cosine);
double third_kind(const Modulus& modulus, double n, double sine, double cosine);

/// Jacobi's functions and the integral of the third kind Pi(n; u) at any u, for one modulus and one n < 0.
///
/// With the nome q = exp(-pi K'/K) and z = pi u / (2 K), the functions are quotients of the theta series
///   theta_1 = 2 sum (-1)^i q^((i+1/2)^2) sin((2i+1) z),  theta_2 = 2 sum q^((i+1/2)^2) cos((2i+1) z),
///   theta_4 = 1 + 2 sum (-1)^i q^(i^2) cos(2i z),
/// and Pi(n; u) = A u + B (pi/2 - arg theta_1(z + i beta)): both sides have the same poles, at u = +-i eta
/// with sn^2 = 1/n, and the same derivative at K. There beta = pi eta / (2 K), eta = F(1/sqrt(1 - n) | m1),
/// and B = sqrt(-n) / ((1 - n) sqrt(1 - m1/(1 - n))). Six terms reach rounding for q <= 0.3 (m < 0.996);
/// above, the mean and Carlson's forms take their place. Source of the series: Abramowitz and
/// Stegun 16.27, 17.7.
class EllipticFunctions {
 public:
  EllipticFunctions() = default;
  EllipticFunctions(const Modulus& modulus, double n);

  struct Values {
    double sn, cn, dn, third_kind;
  };
  Values at(double u) const;

 private:
  static constexpr int most_terms = 6;
  struct Term {
    double odd, even;           ///< q^(i (i+1)), and 2 q^(i^2) (1 for i = 0), with the sign (-1)^i
    double odd_cosh, odd_sinh;  ///< odd times cosh, sinh of (2i+1) beta
  };
  Values by_series(double u) const;

  Modulus modulus_;
  double n_ = 0, quarter_ = 1, third_kind_quarter_ = 1;
  int terms_ = 0;  ///< 0 if the series converge too slowly
  std::array<Term, most_terms> term_{};
  double sn_scale_ = 1, cn_scale_ = 1;  ///< theta_3/theta_2, theta_4/theta_2 at 0
  double linear_ = 1, turning_ = 0;     ///< A, B
};

}  // namespace flyrock
