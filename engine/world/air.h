#pragma once
// The drag of the air on a flying rock.
//
//   dv/dt = g + a(v),   a(v) = -k |v - w| (v - w),   k = rho c_d A / (2 m)
// with the wind w [m/s] and the cross-section A [m2] of the sphere that has the rock's volume. The air does
// not change the spin.

#include <array>

#include "math/space.h"

namespace flyrock {

/// k [1/m] of a rock of `mass` [kg] and `volume` [m3] in air of `density` [kg/m3] with the drag coefficient
/// cd.
double drag_constant(double density, double cd, double mass, double volume);

template <int D>
struct Air {
  double drag = 0;               ///< k, 1/m; 0: no air
  Vec<D> wind = Vec<D>::Zero();  ///< m/s

  Vec<D> acceleration(const Vec<D>& velocity) const {
    const Vec<D> through_air = velocity - wind;
    return -drag * through_air.norm() * through_air;
  }
};

/// One leg of a flight through air, as two parabolas of equal duration. Parabolas make the time of impact and
/// the passages computable in closed form. Position and velocity at the end of the leg are those of the
/// classical Runge-Kutta scheme of order 4 over the whole leg. With the accelerations a1, a2, a3, a4 by the
/// air at its stages, the accelerations of the two parabolas by the air are
///   (3 a1 + 2 a2 + 2 a3 - a4)/6 and (-a1 + 2 a2 + 2 a3 + 3 a4)/6
/// Within the leg the parabolas depart from the path by at most |a'| h^3 / 324.
template <int D>
std::array<Vec<D>, 2> leg_accelerations(const Air<D>& air, const Vec<D>& velocity, const Vec<D>& gravity,
                                        double h);

/// The mean of the two accelerations [m/s2]: the change of velocity over the leg, divided by h.
template <int D>
Vec<D> mean_acceleration(const Air<D>& air, const Vec<D>& velocity, const Vec<D>& gravity, double h) {
  const auto [first, second] = leg_accelerations(air, velocity, gravity, h);
  return 0.5 * (first + second);
}

/// The largest allowed distance between a leg of two parabolas and the path [m].
inline constexpr double leg_tolerance = 1e-6;

/// The longest allowed duration of a leg that begins at `velocity` [s], at most 0.1 s.
template <int D>
double leg_length(const Air<D>& air, const Vec<D>& velocity, const Vec<D>& gravity);

}  // namespace flyrock
