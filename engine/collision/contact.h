#pragma once
// A contact point as the narrow phase finds it.

#include <cstdint>

#include "math/space.h"

namespace flyrock {

/// One contact point of a candidate with an antagonist. World frame, metres.
template <int D>
struct ContactPoint {
  Vec<D> point = Vec<D>::Zero();   ///< half-way between the two surfaces
  Vec<D> normal = Vec<D>::Zero();  ///< unit, from the antagonist to the candidate
  double gap = 0;                  ///< negative if they penetrate
  std::uint32_t feature = 0;       ///< of the candidate: contactor and its vertex or edge
  std::uint32_t against =
      0;  ///< of the antagonist: segment or corner of the terrain, or contactor and vertex or edge of a body
};

/// Feature ids of a body. A vertex and an edge of the same index (below Contactor2::most_vertices) differ in
/// the lowest bit.
inline std::uint32_t vertex_id(int contactor, int vertex) {
  return static_cast<std::uint32_t>(contactor) << 16 | static_cast<std::uint32_t>(vertex) << 1;
}
inline std::uint32_t edge_id(int contactor, int edge) { return vertex_id(contactor, edge) | 1; }

/// Feature ids of the terrain. Corner i lies between the segments i - 1 and i.
inline std::uint32_t segment_id(int segment) { return static_cast<std::uint32_t>(segment) << 1 | 1; }
inline std::uint32_t corner_id(int corner) { return static_cast<std::uint32_t>(corner) << 1; }
inline bool is_corner(std::uint32_t terrain_id) { return (terrain_id & 1) == 0; }
inline int terrain_index(std::uint32_t terrain_id) { return static_cast<int>(terrain_id >> 1); }

/// In 3D a feature is a vertex, edge or face with an index below Contactor3::most_edges. A sphere has only
/// vertex 0; a plane as terrain has only face 0.
enum class FeatureKind : std::uint32_t { vertex, edge, face };
inline std::uint32_t feature_id(int contactor, FeatureKind kind, int index) {
  return static_cast<std::uint32_t>(contactor) << 16 | static_cast<std::uint32_t>(index) << 2 |
         static_cast<std::uint32_t>(kind);
}
inline FeatureKind kind_of(std::uint32_t feature) { return static_cast<FeatureKind>(feature & 3); }
inline int index_of(std::uint32_t feature) { return static_cast<int>(feature >> 2 & 0x3fff); }

/// The index of the contactor in a feature id, in 2D and 3D.
inline int contactor_of(std::uint32_t feature) { return static_cast<int>(feature >> 16); }

}  // namespace flyrock
