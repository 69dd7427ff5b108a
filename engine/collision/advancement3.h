#pragma once
// Conservative advancement of spheres and convex polyhedra.

#include <optional>

#include "collision/motion.h"
#include "collision/time_of_contact.h"
#include "geometry/plane.h"

namespace flyrock {

/// A moving contactor. Shape and motion must outlive it.
struct MovingContactor {
  const Contactor3& shape;
  const Motion3& motion;
  int index = 0;  ///< of the contactor in its body, for feature ids
};

/// The first time in [0, end] at which the contactor touches the plane and approaches it; see
/// time_of_contact.
std::optional<double> advance_to_plane(const MovingContactor& contactor, const Plane& plane, double end,
                                       const TouchSearch& search);

/// The same for two contactors. At least one of them is a polyhedron, or a sphere whose centre is not the
/// centre of mass.
std::optional<double> advance_to_contact(const MovingContactor& a, const MovingContactor& b, double end,
                                         const TouchSearch& search);

}  // namespace flyrock
