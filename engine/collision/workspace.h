#pragma once
// The memory of the searches for contacts and touches.

#include <cstdint>
#include <vector>

#include "collision/smooth/piece_heights.h"
#include "collision/touch_search.h"

namespace flyrock {

/// The facets that a body may meet within a part of its path.
struct FacetMeeting {
  TimeWindow window;
  int facet;
};

/// A facet as a polyhedron of two faces, at rest. Where it has an open rim, it reaches as far beyond as a
/// contactor of this size can, because the ground continues there.
class FlatPolyhedron {
 public:
  FlatPolyhedron();
  /// The facet as the second contactor of a pair. Valid until the next call, and as long as the facet.
  Moving3 of(const Facet& facet, double size, std::span<const HeldOnGround> held);

 private:
  Contactor3 shape_;
  Motion3 rest_;
};

/// What the searches keep between calls, so that a step of the simulation allocates nothing. Each world has
/// one; its contents mean nothing between two calls of pairs.h.
struct Workspace {
  std::vector<Facet> facets;  ///< near a contactor, or near a part of its path
  std::vector<FacetMeeting> meetings;
  std::vector<std::uint64_t> vertices;  ///< of the ground, that were seen
  std::vector<Vec3> edges;              ///< of the ground, that leave one of them
  FlatPolyhedron facet_hull;
  Contactor3 edge = Contactor3::pill(Vec3::Zero(), Vec3::Zero(), 0);  ///< of the ground
  std::vector<HeldContact> mirrored, seen_from_outline, still_held;
  std::vector<HeldOnGround> held_on_ground;
  Contacts<3> found, of_other_planes, rest, kept;
  std::vector<double> rises;  ///< of the faces of a hull along an edge
  std::vector<PieceHeight> heights_a, heights_b;
};

}  // namespace flyrock
