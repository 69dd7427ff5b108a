#pragma once
// Conservative advancement of spheres and convex polyhedra.

#include <optional>

#include "collision/motion.h"
#include "collision/time_of_contact.h"
#include "geometry/facet.h"

namespace flyrock {

/// A moving contactor. Shape and motion must outlive it.
struct MovingContactor {
  const Contactor3& shape;
  const Motion3& motion;
  int index = 0;                 ///< of the contactor in its body, for feature ids
  const Facet* facet = nullptr;  ///< for a facet of the ground at rest, as a flat polyhedron

  /// The id of a feature. A facet has its own; its back has none.
  FeatureId id(FeatureKind kind, int i) const;
};

/// The first time in the window at which the contactor touches the facet and approaches it; see
/// time_of_contact.
std::optional<double> advance_to_facet(const MovingContactor& contactor, const Facet& facet,
                                       const TimeWindow& window, const TouchSearch& search);

/// The same for two contactors. At least one of them is a polyhedron, or a sphere whose centre is not the
/// centre of mass.
std::optional<double> advance_to_contact(const MovingContactor& a, const MovingContactor& b,
                                         const TimeWindow& window, const TouchSearch& search);

}  // namespace flyrock
