#pragma once
// Mends the meshes of surveys, as their programs write them.

#include <string>
#include <vector>

#include "geometry/mesh.h"

namespace flyrock {

/// What a user allows to be changed.
struct MeshRepair {
  double weld = 0;            ///< m: borders that are no farther apart are joined
  int fill_holes = 0;         ///< holes of at most so many edges are filled
  bool keep_largest = false;  ///< of several pieces only the one with the greatest surface stays
};

/// Mends a mesh and returns what was changed, a sentence each; `lines` follows the triangles (may be empty).
/// Always: of triangles with the same corners one stays; triangles without an area are dropped (where three
/// corners lie on a line, the neighbour across the longest side gets the corner between); skirts are dropped,
/// which are upright strips below edges that have more than two triangles, or whose strips face the wrong
/// way; open pieces that look down as a whole are turned over. As `repair` allows: borders are welded,
/// vertices first, then edges at the vertices near them; pieces are left out; holes are filled with the least
/// area.
std::vector<std::string> mend(Mesh& mesh, std::vector<int>& lines, const MeshRepair& repair);

}  // namespace flyrock
