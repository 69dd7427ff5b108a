#pragma once
// Gates, which look at what passes them, and barriers, which hold it.
//
// Both stand at an x of the terrain (in 3D a vertical plane across x) and act once on each body: when its
// centre of mass first arrives there from the side on which it started. A body that starts at x arrives at
// once.

#include <span>
#include <vector>

#include "world/observe.h"

namespace flyrock {

struct Gate {
  double x = 0;  ///< m
};

/// A fence or berm. A body that arrives at `height` above the ground or higher goes on over the top. Lower,
/// it is caught where its kinetic energy E, of translation and rotation, is at most `capacity`; else it goes
/// through, and its velocity and spin are scaled by sqrt(1 - capacity / E), which takes `capacity` from its
/// energy.
struct Barrier {
  double x = 0;         ///< m
  double height = 0;    ///< m above the ground at x
  double capacity = 0;  ///< J
};

/// How a body arrives at a gate or barrier.
struct Arrival {
  double time = 0;
  double speed = 0;           ///< m/s
  double kinetic_energy = 0;  ///< J
  double height = 0;          ///< m above the ground there
};

/// The place of a body that arrives at x, moved onto it along x: free of the rounding of its time.
template <int D>
Vec<D> at_x(Vec<D> place, double x) {
  place.x() = x;
  return place;
}

/// What the barrier of this index does to a body that arrives so.
BarrierHit meet(const Barrier& barrier, int index, const Arrival& arrival);

/// The share of its velocity and spin that a body has behind the barrier: below 1 where it went through.
double velocity_left(const Barrier& barrier, const BarrierHit& hit);

/// Places still ahead of a body: the side they lie on, +1 right, -1 left, or 0 once it has arrived.
using Sides = std::vector<int>;

template <class Place>
Sides sides_of(std::span<const Place> places, double start) {
  Sides sides;
  for (const Place& place : places) sides.push_back(place.x >= start ? 1 : -1);
  return sides;
}

}  // namespace flyrock
