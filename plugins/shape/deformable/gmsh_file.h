#pragma once
// Meshes of triangles in the plane from files of Gmsh (.msh, ASCII, version 4.1).

#include <string>

#include "geometry/deformable.h"

namespace flyrock::plugins {

/// Reads the triangles of 3 nodes and their nodes, in the units of the file; other elements are counted in
/// `ignored`. Source: Gmsh reference manual, "MSH file format". Throws PluginError with file and line: a file
/// that cannot be read, is binary or of another version, ends early or has no triangles; a node that is
/// unknown or given twice, out of the plane of the others, of no triangle, or within a side of a triangle; a
/// triangle that is inverted or has no area; several pieces; a hole.
GivenMesh read_gmsh(const std::string& path);

}  // namespace flyrock::plugins
