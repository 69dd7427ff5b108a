#pragma once
// Surfaces of triangles in files.

#include <string>
#include <vector>

#include "geometry/mesh.h"

namespace flyrock::plugins {

/// The triangles of a file, in its coordinates, and the line that each stands in (empty: the file has no
/// lines). Corners at the same place are one vertex (`welded`, geometry/mesh_edges.h).
struct MeshFile {
  Mesh mesh;
  std::vector<int> lines;
  std::vector<std::string> notes = {};  ///< what may be wrong, a sentence each
};

/// What makes the parts of an OBJ file: its groups (`g`) and objects (`o`), or its materials (`usemtl`).
/// `either`: the materials where no face has a group.
enum class PartsOf { either, groups, materials };

/// Reads an OBJ file: its vertices and faces. A part has the name of its group or material, the rest of that
/// line, in which a character other than a letter, digit, `_` or `-` becomes `_`. A convex face of more than
/// three corners becomes a fan of triangles. Throws PluginError in the name of the plugin `plugin`, with the
/// line.
MeshFile read_obj(const std::string& plugin, const std::string& path, PartsOf parts);

/// Reads an STL file, text or binary, of one part without a name. Throws PluginError with the line, or with
/// the number of the triangle.
MeshFile read_stl(const std::string& plugin, const std::string& path);

/// Reads a file whose name ends in .obj or .stl.
MeshFile read_mesh(const std::string& plugin, const std::string& path, PartsOf parts = PartsOf::either);

/// A mesh in metres with z up, of one in units of `scale` m whose y or z axis points up. Throws PluginError
/// for a scale of 0 or less.
Mesh to_metres(const std::string& plugin, Mesh mesh, double scale, bool y_is_up);

}  // namespace flyrock::plugins
