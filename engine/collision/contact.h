#pragma once
// A contact as the narrow phase finds it.

#include <cstdint>

#include "math/space.h"

namespace flyrock {

/// One point of contact of a candidate with an antagonist. World frame, metres.
template <int D>
struct ContactPoint {
  Vec<D> point = Vec<D>::Zero();   ///< half-way between the two surfaces
  Vec<D> normal = Vec<D>::Zero();  ///< unit, from the antagonist to the candidate
  double gap = 0;                  ///< negative where they overlap
  std::uint32_t feature = 0;       ///< of the candidate: contactor and its vertex or edge
  std::uint32_t against = 0;       ///< of the antagonist: segment or corner of the terrain; contactor and vertex or edge of a body
};

/// Feature ids. Of a body: a vertex and an edge of the same index differ in the lowest bit.
inline std::uint32_t vertex_id(int contactor, int vertex) {
  return static_cast<std::uint32_t>(contactor) << 16 | static_cast<std::uint32_t>(vertex) << 1;
}
inline std::uint32_t edge_id(int contactor, int edge) { return vertex_id(contactor, edge) | 1; }

/// Of the terrain: a corner i lies between the segments i - 1 and i.
inline std::uint32_t segment_id(int segment) { return static_cast<std::uint32_t>(segment) << 1 | 1; }
inline std::uint32_t corner_id(int corner) { return static_cast<std::uint32_t>(corner) << 1; }
inline bool is_corner(std::uint32_t terrain_id) { return (terrain_id & 1) == 0; }
inline int terrain_index(std::uint32_t terrain_id) { return static_cast<int>(terrain_id >> 1); }

}  // namespace flyrock
