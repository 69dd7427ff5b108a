#pragma once
// The flight of a point under gravity and the drag of the air.
//
// The equation is in world/air.h. Without air the flight is a parabola in closed form. With air it is
// integrated by the Dormand-Prince pair of orders 5 and 4 (Boost.Odeint), with steps adapted to a tolerance.
// Source: practice since Stojadinovic et al. 2011, who integrate the same equation.

#include "flight/arc.h"
#include "world/air.h"

namespace flyrock {

template <int D>
struct Forces {
  Vec<D> gravity = Vec<D>::Zero();  ///< m/s2
  Air<D> air;

  Vec<D> acceleration(const Vec<D>& velocity) const { return gravity + air.acceleration(velocity); }
};

/// The allowed error of one step: absolute [m, m/s], and relative to position and velocity.
inline constexpr double flight_tolerance = 1e-7;

/// A flight, arc by arc. The interpolation within a step is as accurate as the step. No arc is longer than
/// 0.5 s, except a parabola, which is as long as requested.
template <int D>
class BallisticFlight {
 public:
  BallisticFlight(const Forces<D>& forces, const Vec<D>& position, const Vec<D>& velocity, double time = 0)
      : forces_(forces), now_{position, velocity, forces.acceleration(velocity)}, time_(time) {}

  /// The next arc, of at most `longest` seconds (above 0).
  Arc<D> next(double longest) {
    if (forces_.air.drag != 0) return next_in_air(longest);
    const Arc<D> arc = parabola(time_, longest, now_);
    now_.position = arc.position(1);
    now_.velocity = arc.velocity(1);
    time_ += longest;
    return arc;
  }

  double time() const { return time_; }
  const FlightState<D>& now() const { return now_; }

 private:
  Arc<D> next_in_air(double longest);

  Forces<D> forces_;
  FlightState<D> now_;
  double time_;
  double step_ = 0.05;  // s, at the start
};

/// Where a flight ends on an arc or parabola: at the ground, at the end of the terrain, where an observer
/// stops it, or at its end. `s` is the parameter of the curve.
struct ArcEnd {
  double s = 1;
  bool on_ground = false, left = false, held = false;
  int segment = -1;  ///< of the ground in 2D that it touches; -1: not known
};
template <int D, class Ground>
ArcEnd end_of(const Arc<D>& arc, const Ground& ground) {
  const std::optional<double> touch = first_touch(arc, ground), exit = first_exit(arc, ground);
  if (touch && (!exit || *touch <= *exit)) return {*touch, true};
  if (exit) return {*exit, false, true};
  return {};
}

/// Where a flight ends: at the ground, at the end of the terrain or of the time, or where an observer stopped
/// it.
template <int D>
struct Landing {
  bool on_ground = false, left = false;
  double time = 0;
  Vec<D> position = Vec<D>::Zero(), velocity = Vec<D>::Zero();
};

/// Flies to the ground, the end of the terrain or the time `latest` [s]; ends immediately if `latest` has
/// passed. `see(arc, end)` is called with every arc and its ArcEnd. It may move the end forward to stop the
/// flight there.
template <int D, class Ground, class See>
Landing<D> land(BallisticFlight<D> flight, const Ground& ground, double latest, See see) {
  Landing<D> landing{false, false, flight.time(), flight.now().position, flight.now().velocity};
  ArcEnd end;
  while (landing.time < latest && !end.on_ground && !end.left && !end.held) {
    const Arc<D> arc = flight.next(latest - landing.time);
    end = end_of(arc, ground);
    see(arc, end);
    landing = {end.on_ground, end.left, arc.time(end.s), arc.position(end.s), arc.velocity(end.s)};
  }
  return landing;
}

}  // namespace flyrock
