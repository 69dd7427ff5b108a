#pragma once
// Launch speeds fitted to bench blasts: v0^2 = K f(c/m) - C.

namespace flyrock {

enum class BenchRock {
  limestone,  ///< and dolomite
  granite
};

/// How the fit reads. The paper prints the square root; with it the speeds are those of no quarry (237 m/s
/// and 5.7 km for its own blasts). v0 = sqrt(2E) sqrt(c/m), squared, is linear in c/m, and sqrt(K) is then
/// the Gurney constant of ANFO to 1 %: the root was most likely misplaced on squaring.
enum class BenchFitForm {
  linear,     ///< f = c/m
  as_printed  ///< f = sqrt(c/m)
};

/// Constants of one fit.
struct BenchFit {
  double slope = 0;   ///< K, m2/s2
  double offset = 0;  ///< C, m2/s2
};

/// The fit for a rock and an explosive; that of limestone is printed for ANFO only and serves every
/// explosive. Source: Fly-rock distance (Ninh Dan), equation 6 and after, after Roth 1979.
BenchFit bench_fit(BenchRock rock, bool anfo);

/// v0^2 = K f(c/m) - C [m2/s2]. Negative below a charge of its own: there the fit says nothing and the burden
/// does not fly.
double squared_speed(const BenchFit& fit, BenchFitForm form, double charge_to_mass);

}  // namespace flyrock
