#pragma once
// The surfaces of rocks and other bodies as polygons, for exports.

#include <cstdint>
#include <vector>

#include "report/tables/stored_scene.h"

namespace flyrock {

/// A surface in the body's frame. Faces are convex polygons, counter-clockwise as seen from outside; in 2D
/// each contactor is one.
struct RockShape {
  std::vector<Vec3> vertices;  ///< m
  std::vector<std::vector<std::int64_t>> faces;
};

/// Polyhedra, boxes and polygons have their faces; what has a radius is triangulated, and inscribed.
RockShape shape_of(const std::vector<SurfaceCorner>& corners, bool in_space);

/// Whether a result is one in 3D.
bool is_stored_in_space(const SqliteReader& database);

/// The attitude of a body: it maps its frame to the world, in 2D about z.
Eigen::Quaterniond turn_of(const StoredMoment& moment, bool in_space);

}  // namespace flyrock
