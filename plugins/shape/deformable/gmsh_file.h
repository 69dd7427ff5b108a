#pragma once
// Meshes of triangles in the plane or of tetrahedra from files of Gmsh (.msh, ASCII, version 4.1).

#include <string>

#include "geometry/deformable.h"

namespace flyrock::plugins {

/// Reads the triangles of 3 nodes, in 3D the tetrahedra of 4 nodes, and their nodes, in the units of the
/// file; other elements are counted in `ignored`. Source: Gmsh reference manual, "MSH file format". Throws
/// PluginError with file and line: a file that cannot be read, is binary or of another version, ends early or
/// has no such elements; a node that is unknown or given twice, of no element, or within a side of one; an
/// element that is inverted or has no area or volume; several pieces; in 2D a node out of the plane of the
/// others, or a hole.
template <int D>
GivenMesh<D> read_gmsh(const std::string& path);

}  // namespace flyrock::plugins
