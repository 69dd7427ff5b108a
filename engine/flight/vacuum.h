#pragma once
// Flights without air in closed form, over level ground, from a height h [m] above it, with gravity g [m/s2].
//
// Source: the parabola; J. Roth, A model for the determination of flyrock range, USBM J0387242 (1979), gives
// the range from a height for 45 degrees only, which is not the greatest range.

namespace flyrock {

/// The horizontal distance [m] at which a launch at `speed` [m/s] and `elevation` [rad] reaches the ground:
///   v cos(e) (v sin(e) + sqrt(v^2 sin^2(e) + 2 g h)) / g.
double vacuum_range(double speed, double elevation, double height, double gravity);

/// The elevation [rad] with the greatest range, tan e = v / sqrt(v^2 + 2 g h), and this range [m], (v/g)
/// sqrt(v^2 + 2 g h).
double best_vacuum_elevation(double speed, double height, double gravity);
double greatest_vacuum_range(double speed, double height, double gravity);

/// The envelope (shroud) of all launches of one speed [m above the launch] at the horizontal distance x:
///   v^2/(2 g) - g x^2/(2 v^2). No flight reaches higher there.
double vacuum_envelope(double speed, double x, double gravity);

}  // namespace flyrock
