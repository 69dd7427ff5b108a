#pragma once
// Gates, which record the bodies that pass them, and barriers, which stop or slow them.
//
// Both stand on a line in plan (geometry/plan_line.h). They act once on each body: when its centre of mass
// first arrives at the line. A body that starts on the line arrives immediately.

#include <span>
#include <vector>

#include "geometry/plan_line.h"
#include "record/observe.h"

namespace flyrock {

struct Gate {
  PlanLine line;
};

/// A fence, wall or berm. A body with its centre h above the ground, the radius R (of the sphere of equal
/// volume) and the kinetic energy E (translation and rotation) passes over the top if height_factor h + R >
/// height. A lower body is caught if E <= capacity. Otherwise it goes through, and its velocity and spin are
/// scaled by sqrt(1 - capacity / E), so that it loses the energy `capacity`.
struct Barrier {
  PlanLine line;
  double height = 0;    ///< m above the ground at the line, without what its inclination and freeboard take
  double capacity = 0;  ///< J, of its energy level, divided by the partial factor of energies
  double height_factor = 1;
};

/// What the barrier with this index does to a body of this volume [m3] with this arrival.
BarrierHit meet(const Barrier& barrier, int index, const Arrival& arrival, double volume);

/// The factor by which the barrier scales velocity and spin of the body: below 1 if the body went through.
double velocity_left(const Barrier& barrier, const BarrierHit& hit);

/// A position in plan.
inline Vec2 in_plan(const Vec2& place) { return {place.x(), 0}; }
inline Vec2 in_plan(const Vec3& place) { return place.head<2>(); }

/// A position moved in plan to a place of a line, which removes the rounding error of the arrival time.
template <int D>
Vec<D> moved_to(Vec<D> position, const Vec2& plan) {
  position.template head<D - 1>() = plan.head<D - 1>();
  return position;
}

/// The approaches of a body that starts at a position to the lines of gates or barriers, in their order.
template <class Place>
std::vector<Approach> approaches(std::span<const Place> places, const Vec2& start) {
  std::vector<Approach> list;
  for (const Place& place : places) list.emplace_back(place.line, start);
  return list;
}

}  // namespace flyrock
