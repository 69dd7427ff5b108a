#pragma once
// The drag of the air on a flying rock.
//
//   dv/dt = g + a(v),   a(v) = -k |v - w| (v - w),   k = rho c_d A / (2 m)
// with the wind w and the cross-section A of the sphere of the rock's volume. The air takes nothing from the
// spin.

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

/// A piece of a flight through air as two parabolas of equal duration, so that all that is known of parabolas
/// (when they touch, what they pass) holds for it. Place and velocity at its end are those of the classical
/// Runge-Kutta scheme of order 4 for the whole leg, whose air is a1, a2, a3, a4 at its stages: the two
/// accelerations by the air
///   (3 a1 + 2 a2 + 2 a3 - a4)/6 and (-a1 + 2 a2 + 2 a3 + 3 a4)/6
/// are those that arrive there. Within the leg the path departs by |a'| h^3 / 324 at most.
template <int D>
std::array<Vec<D>, 2> leg_accelerations(const Air<D>& air, const Vec<D>& velocity, const Vec<D>& gravity,
                                        double h);

/// The mean of both [m/s2]: that of the change of velocity over h.
template <int D>
Vec<D> mean_acceleration(const Air<D>& air, const Vec<D>& velocity, const Vec<D>& gravity, double h) {
  const auto [first, second] = leg_accelerations(air, velocity, gravity, h);
  return 0.5 * (first + second);
}

/// What a leg of two parabolas may depart from the path [m].
inline constexpr double leg_tolerance = 1e-6;

/// How long a leg that begins at `velocity` may last [s]: at most 0.1 s.
template <int D>
double leg_length(const Air<D>& air, const Vec<D>& velocity, const Vec<D>& gravity);

}  // namespace flyrock
