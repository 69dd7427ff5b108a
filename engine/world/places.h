#pragma once
// Gates, which record the bodies that pass them, and barriers, which stop or slow them.
//
// Both stand at a position x of the terrain (in 3D a vertical plane normal to x). They act once on each body:
// when its centre of mass first arrives there from the side on which it started. A body that starts at x
// arrives immediately.

#include <span>
#include <vector>

#include "world/observe.h"

namespace flyrock {

struct Gate {
  double x = 0;  ///< m
};

/// A fence or berm. A body that arrives at `height` above the ground or higher passes over the top. A lower
/// body is caught if its kinetic energy E (translation and rotation) is at most `capacity`. Otherwise it goes
/// through, and its velocity and spin are scaled by sqrt(1 - capacity / E), so that it loses the energy
/// `capacity`.
struct Barrier {
  double x = 0;         ///< m
  double height = 0;    ///< m above the ground at x
  double capacity = 0;  ///< J
};

/// The state in which a body arrives at a gate or barrier.
struct Arrival {
  double time = 0;
  double speed = 0;           ///< m/s
  double kinetic_energy = 0;  ///< J
  double height = 0;          ///< m above the ground there
};

/// The position of a body that arrives at x, with its x component set to x exactly. This removes the rounding
/// error of the arrival time.
template <int D>
Vec<D> at_x(Vec<D> place, double x) {
  place.x() = x;
  return place;
}

/// What the barrier with this index does to a body with this arrival.
BarrierHit meet(const Barrier& barrier, int index, const Arrival& arrival);

/// The factor by which the barrier scales velocity and spin of the body: below 1 if the body went through.
double velocity_left(const Barrier& barrier, const BarrierHit& hit);

/// For each place, the side of a body on which it lies: +1 right, -1 left, 0 once the body has arrived.
using Sides = std::vector<int>;

template <class Place>
Sides sides_of(std::span<const Place> places, double start) {
  Sides sides;
  for (const Place& place : places) sides.push_back(place.x >= start ? 1 : -1);
  return sides;
}

}  // namespace flyrock
