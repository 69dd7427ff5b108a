#pragma once
// The flight of a point under gravity and the drag of the air.
//
// world/air.h has the equation. Without air the flight is the parabola, in closed form; with it the pair of Dormand and
// Prince of orders 5 and 4 (Boost.Odeint) with steps adapted to a tolerance.
// Source: field practice since Stojadinovic et al. 2011, who integrate the same equation.

#include "trajectory/arc.h"
#include "world/air.h"

namespace flyrock {

template <int D>
struct Forces {
  Vec<D> gravity = Vec<D>::Zero();  ///< m/s2
  Air<D> air;

  Vec<D> acceleration(const Vec<D>& velocity) const { return gravity + air.acceleration(velocity); }
};

/// The error that a step may add: this many m and m/s, and this share of position and velocity.
inline constexpr double flight_tolerance = 1e-7;

/// A flight, arc by arc. The interpolation between the ends of a step is as exact as the step; no arc lasts longer than
/// 0.5 s, but a parabola, which lasts as long as it is asked to.
template <int D>
class BallisticFlight {
 public:
  BallisticFlight(const Forces<D>& forces, const Vec<D>& position, const Vec<D>& velocity, double time = 0);

  /// The next arc, of at most `longest` seconds (above 0).
  Arc<D> next(double longest);

 private:
  Forces<D> forces_;
  FlightState<D> now_;
  double time_;
  double step_ = 0.05;  // s, to begin with
};

/// Where a flight over a profile ends: at the ground, or at the end of the profile or of the time.
struct Landing {
  bool on_ground = false, left = false;  ///< neither: the time was up
  double time = 0;
  Vec2 position = Vec2::Zero(), velocity = Vec2::Zero();
};

/// Flies to the ground, the end of the profile or the time `latest` [s]; `see(arc, end)` is called with every arc and the s
/// in [0, 1] at which it ends.
template <class See>
Landing land(BallisticFlight<2> flight, double start, const Profile& ground, double latest, See see) {
  Landing landing;
  landing.time = start;
  while (landing.time < latest) {
    const Arc<2> arc = flight.next(latest - landing.time);
    const std::optional<double> touch = first_touch(arc, ground), exit = first_exit(arc, ground);
    landing.on_ground = touch && (!exit || *touch <= *exit);
    landing.left = !landing.on_ground && exit;
    const double end = landing.on_ground ? *touch : exit.value_or(1);
    landing.time = arc.start + end * arc.length;
    landing.position = arc.position(end);
    landing.velocity = arc.velocity(end);
    see(arc, end);
    if (landing.on_ground || landing.left) break;
  }
  return landing;
}

/// The elevation [rad] in (0, pi/2) that goes farthest over level ground `height` [m] below the launch, to 1e-4 rad, and
/// its distance [m]. `forces` with gravity along -y.
struct Farthest {
  double elevation = 0, range = 0;
};
Farthest farthest(const Forces<2>& forces, double speed, double height);

}  // namespace flyrock
