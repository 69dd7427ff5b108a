#pragma once
// Where the pieces of a mesh nearly touch, or lie over each other: places where rocks get below the ground.

#include <vector>

#include "geometry/mesh_fault.h"

namespace flyrock {

/// Borders closer than this to another border nearly touch [m]: 1e-4 of the extent of the mesh, at least 20
/// mm, which no survey leaves open.
double gap_reach(const Mesh& mesh);

/// The gaps of a mesh: a vertex at a border that is nearer to another border than gap_reach, and than a
/// quarter of the edges there, without being one of its ends; of one piece (a slit) or of two. And open
/// pieces that lie over each other in plan, as topography and pit shell do. Closed pieces may lie anywhere.
std::vector<MeshFault> gap_faults(const Mesh& mesh, const std::vector<int>& lines = {});

}  // namespace flyrock
