#pragma once
// A piece of the ground in 3D as a mesh, for pictures and exports.

#include <vector>

#include "geometry/box.h"
#include "geometry/mesh.h"

namespace flyrock {

class Ground3;

/// Triangles of the ground over a rectangle in plan.
struct GroundSurface {
  Mesh mesh;
  /// 0: these are the triangles of the ground, cut at the border of the rectangle. Else there are too many of
  /// them, and heights of the ground on a square lattice with this spacing [m] stand for them: of an overhang
  /// only the top is there, and small holes are closed.
  double lattice = 0;
};

/// The ground over `window` (in plan, in the coordinates of the ground) by at most about `most` triangles.
/// The lattice of a grid is every n-th of its heights. A mesh without triangles: there is no ground.
GroundSurface surface_within(const Ground3& ground, const Box2& window, std::size_t most);

/// The ground under a line in plan as points (distance from `from`, height) at equal distances [m], split
/// where there is none.
std::vector<std::vector<Vec2>> heights_along(const Ground3& ground, const Vec2& from, const Vec2& to,
                                             int points);

}  // namespace flyrock
