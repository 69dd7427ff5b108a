#pragma once
// Conservative advancement of spheres, pills and convex polyhedra.

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "collision/motion.h"
#include "collision/time_of_contact.h"
#include "geometry/facet.h"

namespace flyrock {

/// A contact with the ground that exists when the search begins, with the vertices of the ground's feature.
struct HeldOnGround {
  FeatureId feature = 0;  ///< of the body
  FeatureId against = 0;
  bool opened = false, yields = false;  ///< as HeldContact
  std::array<std::uint64_t, 3> vertex{};
  int vertices = 0;
  Vec3 normal = Vec3::UnitZ();  ///< of a facet
  Vec3 place = Vec3::Zero();    ///< a corner of the facet, the start of the edge, or the peak
  Vec3 along = Vec3::Zero();    ///< of an edge [m]

  bool contains(std::uint64_t of_ground) const {
    return std::find(vertex.begin(), vertex.begin() + vertices, of_ground) != vertex.begin() + vertices;
  }
};

/// A moving contactor. Shape and motion must outlive it.
struct MovingContactor {
  const Contactor3& shape;
  const Motion3& motion;
  int index = 0;                         ///< of the contactor in its body, for feature ids
  const Facet* facet = nullptr;          ///< for a facet of the ground at rest, as a flat polyhedron
  std::span<const HeldOnGround> held{};  ///< for a facet: the contacts of the other contactor with the ground

  /// The id of a feature. A facet has its own; its back has none.
  FeatureId id(FeatureKind kind, int i) const;
};

/// The first time in the window at which the contactor touches the facet and approaches it; see
/// time_of_contact.
std::optional<double> advance_to_facet(const MovingContactor& contactor, const Facet& facet,
                                       std::span<const HeldOnGround> held, const TimeWindow& window,
                                       const TouchSearch& search);

/// The same for two contactors. They are not both spheres about their centres of mass.
std::optional<double> advance_to_contact(const MovingContactor& a, const MovingContactor& b,
                                         const TimeWindow& window, const TouchSearch& search);

}  // namespace flyrock
