#pragma once
// A piece of a flight as a polynomial of time, and where it first meets the ground.

#include <array>
#include <optional>

#include "geometry/profile.h"
#include "math/space.h"

namespace flyrock {

/// The path over [start, start + length] as the polynomial of degree 5 in s = (t - start) / length that has position,
/// velocity and acceleration of both ends: p(s) = c0 + c1 s + ... + c5 s^5. Without air the last three are 0.
template <int D>
struct Arc {
  double start = 0, length = 0;  ///< s
  std::array<Vec<D>, 6> c;

  Vec<D> position(double s) const;
  Vec<D> velocity(double s) const;  ///< m/s
  /// A box with sides along the axes around the whole arc (of its control points as a Bezier curve).
  Eigen::AlignedBox<double, D> box() const;
};

/// A point in flight.
template <int D>
struct FlightState {
  Vec<D> position = Vec<D>::Zero(), velocity = Vec<D>::Zero(), acceleration = Vec<D>::Zero();
};

/// The arc from one state to another, `length` > 0 seconds later.
template <int D>
Arc<D> arc_between(double start, double length, const FlightState<D>& from, const FlightState<D>& to);

/// The arc of a constant acceleration, that of `from`.
template <int D>
Arc<D> parabola(double start, double length, const FlightState<D>& from);

/// The first s in [0, 1] at which the arc passes the profile from above, the root being bracketed between those of the
/// derivatives so that none is missed. A point that begins on the profile and rises from it leaves it. Beyond its ends a
/// profile has no ground.
std::optional<double> first_touch(const Arc<2>& arc, const Profile& ground);

/// The first s in [0, 1] at which the arc goes beyond an end of the profile.
std::optional<double> first_exit(const Arc<2>& arc, const Profile& ground);

}  // namespace flyrock
