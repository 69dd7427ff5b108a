#pragma once
// Where a terrain in 3D lies, and profiles that are cut out of it.

#include <stdexcept>

#include "geometry/profile.h"
#include "geometry/terrain_shape.h"

namespace flyrock {

/// The lower left corner of triangles or heights, rounded down to 100 m, in each coordinate that exceeds 10
/// km; 0 in the others. A plane has no corner.
Vec3 automatic_origin(const TerrainShape3& shape);

/// The shape in coordinates that count from `origin`.
TerrainShape3 counted_from(TerrainShape3 shape, const Vec3& origin);

/// Why a shape reaches farther than `most` [m] from the place from which its coordinates count, which is
/// `origin` in those of the scenario; empty if it does not.
std::string reach_fault(const TerrainShape3& shape, const Vec3& origin, double most);

/// A terrain has no profile along a line.
struct SectionError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The profile of a terrain along the line from `from` to `to` in plan [m]: x is the distance from `from`.
/// Its parts are those of the terrain on the line. Throws SectionError where the ground does not reach both
/// ends, has a gap or hangs over, and for a line shorter than 1 mm or longer than 100 km.
Profile section_of(const TerrainShape3& shape, const Vec2& from, const Vec2& to);

}  // namespace flyrock
