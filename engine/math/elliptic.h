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
struct EllipticIntegrals {
  double first, third;
};
EllipticIntegrals elliptic_integrals(const Modulus& modulus, double n, double sine, double cosine);

}  // namespace flyrock
