#pragma once
// Surfaces of triangles in files.

#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "survey/written_digits.h"

namespace flyrock::plugins {

/// The triangles of a file, in its coordinates, and the line that each stands in (empty: the file has no
/// lines). Corners at the same place are one vertex (`welded`, geometry/mesh_edges.h).
struct MeshFile {
  Mesh mesh;
  std::vector<int> lines;
  std::vector<std::string> notes = {};  ///< what may be wrong, a sentence each
  double unit =
      0;  ///< m, that the file says, in which the mesh no longer is: it is in m; 0: the file does not say
  std::string crs = {};  ///< "EPSG:2056", of the coordinates of the file; empty: it does not say
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

/// Reads a PLY file, text or binary in either order of bytes, of one part without a name: x, y, z of the
/// element `vertex` and the list `vertex_indices` (or `vertex_index`) of the element `face`, which comes
/// after it. All other properties and elements are passed over. A convex face of more than three corners
/// becomes a fan of triangles. Throws PluginError with the line, or with the number of the vertex or face,
/// also where the file has less or more than its head announces.
MeshFile read_ply(const std::string& plugin, const std::string& path);

/// Reads a triangulated surface (TIN) of a LandXML file, of one part without a name, with x east and y north.
/// Its triangles look up. Hidden faces are left out. `surface`: its name; empty: the only one. Throws
/// PluginError with the line.
MeshFile read_landxml(const std::string& plugin, const std::string& path, const std::string& surface);

/// Reads the 3D faces of a DXF file through the module flyrock_gdal.so; its layers are parts. `layer`: the
/// only one to read; empty: all. Its triangles look up as surfaces with a border, and outwards as closed
/// ones. Throws PluginError with the number of the entity.
MeshFile read_dxf(const std::string& plugin, const std::string& path, const std::string& layer);

/// A part's name from that of a group or layer: a character other than a letter, digit, `_` or `-` becomes
/// `_`.
std::string part_name(std::string name);

/// Appends a convex face of three corners or more as a fan of triangles of the line `line` (0: the file has
/// no lines). The parts of the triangles are left to the caller. Returns what is wrong with the face; empty:
/// nothing.
std::string add_fan(MeshFile& file, const std::vector<int>& face, int line);

/// Adds a note where numbers of single precision are too coarse for the coordinates of a mesh.
void note_single_precision(MeshFile& file);

/// Adds a note where a text has too few digits for its coordinates; throws PluginError where they are no
/// ground.
void judge_digits(const std::string& plugin, const std::string& path, const WrittenDigits& digits,
                  MeshFile& file);

/// Reads a file whose name ends in .obj, .ply or .stl.
MeshFile read_mesh(const std::string& plugin, const std::string& path, PartsOf parts = PartsOf::either);

/// Converts a mesh in units of `scale` m, with y or z up, to metres with z up. Throws PluginError
/// for a scale of 0 or less.
Mesh to_metres(const std::string& plugin, Mesh mesh, double scale, bool y_is_up);

}  // namespace flyrock::plugins
