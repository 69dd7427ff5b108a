#pragma once
// Launch speeds fitted to bench blasts: v0^2 = K f(c/m) - C.

namespace flyrock {

enum class BenchRock {
  limestone,  ///< and dolomite
  granite
};

/// The form of the fit. The paper prints the square root, but then the speeds are unrealistic (237 m/s and
/// 5.7 km for its own blasts). The square of v0 = sqrt(2E) sqrt(c/m) is linear in c/m, and sqrt(K) then
/// equals the Gurney constant of ANFO to 1 %. The root in the paper is therefore most likely an error made
/// when squaring.
enum class BenchFitForm {
  linear,     ///< f = c/m
  as_printed  ///< f = sqrt(c/m)
};

/// Constants of one fit.
struct BenchFit {
  double slope = 0;   ///< K, m2/s2
  double offset = 0;  ///< C, m2/s2
};

/// The fit for a rock and an explosive. The fit for limestone is published for ANFO only and is used for
/// every explosive. Source: Fly-rock distance (Ninh Dan), equation 6 and the following, after Roth 1979.
BenchFit bench_fit(BenchRock rock, bool anfo);

/// v0^2 = K f(c/m) - C [m2/s2]. It is negative below a certain charge; the fit does not apply there, and the
/// burden does not fly.
double squared_speed(const BenchFit& fit, BenchFitForm form, double charge_to_mass);

}  // namespace flyrock
