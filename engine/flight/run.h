#pragma once
// Runs a world: flights in closed form, impacts without duration, contact phases in steps.

#include <vector>

#include "flight/crossings.h"

namespace flyrock {

struct RunSettings {
  bool exact_flight = true;     ///< false: fixed steps throughout, for comparison with the literature
  double stop_time = 60;        ///< s
  double stop_speed = 0.05;     ///< m/s; slower for `rest_time` in contact is at rest; 0: never
  double trajectory_every = 0;  ///< s between stored points; 0: none
  bool keep_impacts = true;
  double bin_width = 0;  ///< m, of BodyHistory::path; 0: none is kept; needs a terrain with ends
  std::span<const Gate> gates;
  std::span<const Barrier> barriers;
  bool (*interrupted)() = [] {
    return false;
  };  ///< asked at each step and flight: whether to throw Interrupted
};

/// Thrown out of a run that was interrupted: what it has done is worth nothing.
struct Interrupted {};

/// Runs the world until every dynamic body has stopped, left the terrain or the time is up. With exact
/// flight:
///   - while nothing is in contact, all bodies jump to the next touch: parabola and free rotation. Where two
///   moving
///     bodies may meet meanwhile, they go on in steps;
///   - at a touch the impact problem of all closed contacts is solved; if all separate, the flight goes on;
///   - else steps of the scheme follow, each cut at the first touch of a pair that is not in contact.
/// A flight ends at a barrier as it does at a touch; a step ends there too, to a hundredth of a step.
/// Bodies whose state is not finite end with `diverged`, and all where 10,000 steps lead on by less than one
/// of their length: bodies that cannot be where their contacts want them. Throws TrialError and Interrupted.
/// Instantiated for D = 2, 3.
template <int D>
void run(World<D>& world, const RunSettings& settings, std::vector<BodyHistory>& histories);

}  // namespace flyrock
