#pragma once
// What makes a mesh no ground.

#include <array>
#include <string>
#include <vector>

#include "geometry/mesh.h"

namespace flyrock {

/// One kind of fault of a mesh: the first place, and how many more there are.
struct MeshFault {
  enum class Kind {
    broken,   ///< no triangles, indices that do not exist, coordinates that are not finite
    flat,     ///< triangles without an area
    crowded,  ///< an edge of more than two triangles
    flipped,  ///< neighbours that face opposite ways
    down,     ///< a piece that faces down; a closed one: inwards
    hole,     ///< inside of a piece
    gap,      ///< pieces that nearly touch
    over      ///< open pieces over each other
  };
  Kind kind = Kind::broken;
  std::string text;
  double size = 0;  ///< of holes the most edges of one, of gaps the greatest width [m]
};

/// All that is wrong with a mesh as a surface, with places in the coordinates of the mesh: broken, flat,
/// crowded, flipped, down, hole. A connected piece may have one border, which is its end. `lines`: the line
/// of a file that each triangle stands in, for the texts; may be empty. The mesh must be `welded`
/// (mesh_edges.h). Pieces are looked at where their edges have no fault.
std::vector<MeshFault> faults(const Mesh& mesh, const std::vector<int>& lines = {});

/// The text of the first fault; empty if there is none.
std::string fault(const Mesh& mesh, const std::vector<int>& lines = {});

/// A triangle lower than 1e-6 of its longest side, or than 1e-6 m, has no normal that can be trusted at 100
/// km from the origin, where a double resolves 1e-11 m.
bool has_area(const Vec3& a, const Vec3& b, const Vec3& c);

/// Triangles that hang together by edges, and whether they have a border.
struct MeshPieces {
  std::vector<int> of;        ///< of each triangle: its piece
  std::vector<bool> is_open;  ///< of each piece
  int count() const { return static_cast<int>(is_open.size()); }
};
/// `across`: neighbours_of its triangles (mesh_edges.h).
MeshPieces pieces_of(const std::vector<std::array<int, 3>>& across);

/// " (lines 7 and 9)", " (line 7)"; empty without lines.
std::string lines_text(const std::vector<int>& lines, int triangle, int other = -1);

}  // namespace flyrock
