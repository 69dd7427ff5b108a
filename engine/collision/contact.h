#pragma once
// A contact point as the narrow phase finds it.

#include <vector>

#include "geometry/facet.h"

namespace flyrock {

/// One contact point of a candidate with an antagonist. World frame, metres.
template <int D>
struct ContactPoint {
  Vec<D> point = Vec<D>::Zero();   ///< half-way between the two surfaces
  Vec<D> normal = Vec<D>::Zero();  ///< unit, from the antagonist to the candidate
  double gap = 0;                  ///< negative if they penetrate
  FeatureId feature = 0;           ///< of the candidate: contactor and its vertex, edge or face
  /// Of the antagonist: feature of the terrain, or contactor and vertex, edge or face of a body
  FeatureId against = 0;
  /// m2, in 3D, where a reduction has dropped contacts of the same face: an equal share of the area that is
  /// lost with them (manifold_reduction.h)
  double dropped_area = 0;
};

template <int D>
using Contacts = std::vector<ContactPoint<D>>;

/// A vertex, edge or face of a contactor.
struct ShapeFeature {
  FeatureKind kind = FeatureKind::vertex;
  int index = 0;
};

/// Feature ids of a body in 2D. A vertex and an edge of the same index (below Contactor2::most_vertices)
/// differ in the lowest bit.
inline FeatureId vertex_id(int contactor, int vertex) {
  return static_cast<FeatureId>(contactor) << 16 | static_cast<FeatureId>(vertex) << 1;
}
inline FeatureId edge_id(int contactor, int edge) { return vertex_id(contactor, edge) | 1; }

inline int index_2d(FeatureId feature) { return static_cast<int>(feature >> 1 & 0x7fff); }

/// Feature ids of the terrain in 2D. Corner i lies between the segments i - 1 and i.
inline FeatureId segment_id(int segment) { return static_cast<FeatureId>(segment) << 1 | 1; }
inline FeatureId corner_id(int corner) { return static_cast<FeatureId>(corner) << 1; }
inline bool is_corner(FeatureId terrain_id) { return (terrain_id & 1) == 0; }
inline int terrain_index(FeatureId terrain_id) { return static_cast<int>(terrain_id >> 1); }

/// In 3D the feature of a body has an index below Contactor3::most_edges; a sphere has only vertex 0, a pill
/// the vertices 0 and 1 and edge 0. The ids of the ground are in geometry/facet.h; a plane has only face 0.
inline FeatureId feature_id(int contactor, FeatureKind kind, int index) {
  return static_cast<FeatureId>(contactor) << 16 | static_cast<FeatureId>(index) << 2 |
         static_cast<FeatureId>(kind);
}
inline int index_of(FeatureId feature) { return static_cast<int>(feature >> 2 & 0x3fff); }
inline ShapeFeature feature_of(FeatureId id) { return {kind_of(id), index_of(id)}; }

/// The index of the contactor in a feature id, in 2D and 3D.
inline int contactor_of(FeatureId feature) { return static_cast<int>(feature >> 16); }

}  // namespace flyrock
