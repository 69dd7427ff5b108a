#pragma once
// A piece of a flight as a polynomial of time, and the point where it first touches the ground.

#include <array>
#include <optional>

#include "flight/parabola.h"
#include "geometry/box.h"
#include "math/space.h"

namespace flyrock {

class Ground3;
struct Profile;

/// The path over [start, start + length] as a polynomial of degree 5 in s = (t - start) / length: p(s) = c0 +
/// c1 s + ... + c5 s^5. It matches position, velocity and acceleration at both ends. Without air, c3, c4 and
/// c5 are 0.
template <int D>
struct Arc {
  double start = 0, length = 0;  ///< s
  std::array<Vec<D>, 6> c;
  bool is_parabola = false;  ///< c3, c4 and c5 are 0

  Vec<D> position(double s) const {
    return is_parabola ? Vec<D>((c[2] * s + c[1]) * s + c[0]) : position_of_degree_5(s);
  }
  Vec<D> velocity(double s) const {  ///< m/s
    return is_parabola ? Vec<D>((2 * c[2] * s + c[1]) / length) : velocity_of_degree_5(s);
  }
  Vec<D> position_of_degree_5(double s) const;
  Vec<D> velocity_of_degree_5(double s) const;
  /// The coefficients of n . p(s) + offset.
  std::array<double, 6> along(const Vec<D>& n, double offset = 0) const {
    std::array<double, 6> of{};
    for (int k = 0; k < terms(); ++k) of[k] = n.dot(c[k]);
    of[0] += offset;
    return of;
  }
  /// The coefficients of n . dp/ds.
  std::array<double, 5> rate_along(const Vec<D>& n) const {
    std::array<double, 5> rate{};
    for (int k = 1; k < terms(); ++k) rate[k - 1] = k * n.dot(c[k]);
    return rate;
  }
  double end() const { return 1; }  ///< the greatest s
  double time(double s) const { return start + s * length; }
  const Vec<D>& origin() const { return c[0]; }
  const Vec<D>& rate() const { return c[1]; }
  const Vec<D>& bend() const { return c[2]; }
  /// The same as a path over its time, if it is a parabola.
  Parabola<D> parabola() const {
    return {{c[0], c[1] / length, 2 / (length * length) * c[2]}, start, length};
  }
  int terms() const { return is_parabola ? 3 : 6; }
  /// The part of the arc over [from, to] of s.
  Arc part(double from, double to) const;
  /// A box with sides along the axes that contains the whole arc (the box of its control points as a Bezier
  /// curve).
  Box<D> box() const;
};

/// The arc in plan, as polynomials of s.
inline PlanPath in_plan(const Arc<2>& arc) { return {arc.along(Vec2::UnitX()), {}}; }
inline PlanPath in_plan(const Arc<3>& arc) { return {arc.along(Vec3::UnitX()), arc.along(Vec3::UnitY())}; }

/// The state of a point in flight.
template <int D>
struct FlightState {
  Vec<D> position = Vec<D>::Zero(), velocity = Vec<D>::Zero(), acceleration = Vec<D>::Zero();
};

/// The arc from one state to another, `length` > 0 seconds later.
template <int D>
Arc<D> arc_between(double start, double length, const FlightState<D>& from, const FlightState<D>& to);

/// The arc with the constant acceleration of `from`.
template <int D>
Arc<D> parabola(double start, double length, const FlightState<D>& from) {
  Arc<D> arc;
  arc.start = start;
  arc.length = length;
  arc.c = {from.position,  length * from.velocity, 0.5 * length * length * from.acceleration,
           Vec<D>::Zero(), Vec<D>::Zero(),         Vec<D>::Zero()};
  arc.is_parabola = true;
  return arc;
}

/// The first s in [0, 1] at which the arc passes the profile from above. The roots are bracketed between the
/// roots of the derivatives, so that none is missed. A point that begins on the profile and rises from it has
/// left it. Beyond its ends a profile has no ground.
std::optional<double> first_touch(const Arc<2>& arc, const Profile& ground);

std::optional<double> first_touch(const Arc<3>& arc, const Ground3& ground);

/// The first s in [0, 1] at which the arc passes an end of the ground. A plane has no ends.
std::optional<double> first_exit(const Arc<2>& arc, const Profile& ground);
std::optional<double> first_exit(const Arc<3>& arc, const Ground3& ground);

/// The first s in [0, end] at which the arc arrives at the position x [m], which lies on its side `side` (+1
/// right, -1 left); 0 if it begins there or beyond.
template <int D>
std::optional<double> first_arrival(const Arc<D>& arc, double x, double side, double end);

}  // namespace flyrock
